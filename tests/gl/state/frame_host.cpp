#include "frame_host.h"

#include "gl/bindings.h"
#include "gl/context.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace agaa::test {
namespace {

constexpr float kNear = 0.5f, kFar = 10.0f;

constexpr const char* kVertexShader = R"(#version 450
layout(location = 0) out vec3 position;
invariant gl_Position;
void main() {
    const vec2 corners[3] = vec2[3](vec2(-1.5, -1.2), vec2(1.7, -0.9), vec2(0.1, 1.4));
    position = vec3(corners[gl_VertexID], -2.0 - 0.5 * float(gl_VertexID));
    gl_Position = vec4(position.xy, -10.5 / 9.5 * position.z - 10.0 / 9.5, -position.z);
}
)";

constexpr const char* kFragmentBody = R"(
layout(location = 0) in vec3 position;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = position;
    s.geometricNormal = s.normal = vec3(0.0, 0.0, 1.0);
    s.diffuse = vec3(0.8, 0.4, 0.2);
    s.primitive = uint(gl_PrimitiveID);
#if AGAA_SOME_UNFETCHED
    s.draw = position.x < 0.0 ? 0u : AGAA_UNFETCHED;
#endif
    agaa_emit(s);
}
)";

constexpr GLuint kFetchBinding = 4, kFetchUnit = 17; // that the SDK leaves alone

constexpr const char* kFetchFunctions = R"(
layout(std430, binding = 4) readonly buffer Corners { vec4 clipCorner[3]; };
layout(binding = 17) uniform sampler2D colour;
void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    a = clipCorner[0];
    b = clipCorner[1];
    c = clipCorner[2];
}
void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {
    m.diffuse = textureLod(colour, vec2(0.5), 0.0).rgb;
    m.normal = vec3(0.0, 0.0, 1.0);
}
)";

void AGAA_CALL collect(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity >= AGAA_SEVERITY_WARNING)
        static_cast<std::vector<std::string>*>(user)->push_back(message);
}

AgaaResult AGAA_CALL push(void* user) {
    auto& host = *static_cast<FrameHost*>(user);
    host.calls += 'p';
    if (host.onPush)
        host.onPush();
    return host.calls.size() - 1 == host.failingCall ? AGAA_ERROR_DEVICE : AGAA_OK;
}

AgaaResult AGAA_CALL pop(void* user) {
    auto& host = *static_cast<FrameHost*>(user);
    host.calls += 'o';
    if (host.onPop)
        host.onPop();
    return host.calls.size() - 1 == host.failingCall ? AGAA_ERROR_DEVICE : AGAA_OK;
}

void attach(const GladGLContext& gl, GLuint program, GLenum stage, const std::string& text) {
    const GLuint shader = gl.CreateShader(stage);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
}

std::vector<uint32_t> upTo(uint32_t last) {
    std::vector<uint32_t> points;
    for (uint32_t i = 0; i <= last; ++i)
        points.push_back(i);
    return points;
}

} // namespace

gl::StateScope touchedScope(const FrameSettings& settings) {
    const bool storageImages = settings.storageImages;
    gl::StateScope scope = gl::passBindings();
    scope.textureUnits.push_back(kMetadataUnit);
    if (settings.constants == AGAA_GL_CONSTANTS_BLOCK)
        scope.uniformBindings.push_back(kFrameBinding);
    if (settings.constants == AGAA_GL_CONSTANTS_TEXELS)
        scope.textureUnits.push_back(kFrameUnit);
    auto& places = storageImages ? scope.imageUnits : scope.storageBindings;
    places.insert(places.end(), {kAggregatesBinding, kCountersBinding});
    (storageImages ? scope.uniformBindings : scope.storageBindings).push_back(kLightsBinding);
    for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i)
        scope.textureUnits.push_back(kShadowUnit + i);
    return scope;
}

gl::StateScope watchedScope() {
    gl::StateScope scope;
    scope.textureUnits = upTo(31);
    scope.uniformBindings = upTo(11);
    scope.storageBindings = upTo(7);
    scope.imageUnits = upTo(7);
    return scope;
}

FrameHost::FrameHost(const EglContext& egl, const FrameSettings& settings, AgaaGlStatePolicy policy)
    : gl_(egl.gl()), compatibility_(egl.compatibility()), settings_(settings),
      defaults_(egl.gl(), {}, egl.compatibility()) {
    defaults_.capture();
    gl_.CreateVertexArrays(1, &vertexArray_);
    gl_.CreateTextures(GL_TEXTURE_2D, 1, &output);
    gl_.TextureStorage2D(output, 1, GL_RGBA16F, kWidth, kHeight);
    gl_.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &shadowMap_);
    gl_.TextureStorage3D(shadowMap_, 1, GL_DEPTH_COMPONENT32F, 4, 4, 1);
    const GLfloat far = 1.0f;
    gl_.ClearTexImage(shadowMap_, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);

    std::array<std::array<GLfloat, 4>, 3> corners;
    for (size_t i = 0; i < 3; ++i) { // as kVertexShader has them
        constexpr GLfloat x[] = {-1.5f, 1.7f, 0.1f}, y[] = {-1.2f, -0.9f, 1.4f};
        const GLfloat z = -2.0f - 0.5f * GLfloat(i);
        corners[i] = {x[i], y[i], -10.5f / 9.5f * z - 10.0f / 9.5f, -z};
    }
    gl_.CreateBuffers(1, &fetchCorners_);
    gl_.NamedBufferStorage(fetchCorners_, sizeof corners, corners.data(), 0);
    gl_.CreateTextures(GL_TEXTURE_2D, 1, &fetchColour_);
    gl_.TextureStorage2D(fetchColour_, 1, GL_RGBA8, 1, 1);
    constexpr GLubyte colour[] = {204, 102, 51, 255};
    gl_.ClearTexImage(fetchColour_, 0, GL_RGBA, GL_UNSIGNED_BYTE, colour); // whatever unpacks pixels by now

    AgaaLog messages = AGAA_LOG_INIT;
    messages.callback = collect;
    messages.user = &log;
    AgaaGlDeviceDesc desc = AGAA_GL_DEVICE_DESC_INIT;
    desc.getProcAddr = EglContext::getProcAddr;
    desc.storage = settings.storageImages ? AGAA_GL_STORAGE_IMAGES : AGAA_GL_STORAGE_BUFFERS;
    desc.statePolicy = policy;
    desc.pushState = push;
    desc.popState = pop;
    desc.stateUser = this;
    desc.constants = settings.constants;
    desc.bindings[AGAA_GL_BINDING_FRAME] = settings.constants == AGAA_GL_CONSTANTS_TEXELS ? kFrameUnit : kFrameBinding;
    desc.bindings[AGAA_GL_BINDING_METADATA] = kMetadataUnit;
    desc.bindings[AGAA_GL_BINDING_AGGREGATES] = kAggregatesBinding;
    desc.bindings[AGAA_GL_BINDING_COUNTERS] = kCountersBinding;
    desc.bindings[AGAA_GL_BINDING_LIGHTS] = kLightsBinding;
    for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i)
        desc.bindings[AGAA_GL_BINDING_SHADOW0 + i] = kShadowUnit + i;
    AgaaContextDesc common = AGAA_CONTEXT_DESC_INIT;
    common.pNext = &desc;
    common.log = &messages;
    if (agaaGlCreateContext(AGAA_HEADER_VERSION, &common, &context_) != AGAA_OK)
        throw std::runtime_error(log.empty() ? "agaaGlCreateContext" : log.back());
}

FrameHost::~FrameHost() {
    agaaDestroyView(view_);
    agaaDestroyContext(context_);
    for (const uint32_t program : programs_)
        gl_.DeleteProgram(program);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteTextures(1, &output);
    gl_.DeleteTextures(1, &shadowMap_);
    gl_.DeleteTextures(1, &fetchColour_);
    gl_.DeleteBuffers(1, &fetchCorners_);
}

void FrameHost::fillByShader(const GladGLContext& gl) {
    static_cast<gl::Context&>(*context_).bufferFill.emplace(gl, true);
}

void FrameHost::bindFetched() {
    if (!settings_.fetches)
        return;
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kFetchBinding, fetchCorners_);
    gl_.BindTextureUnit(kFetchUnit, fetchColour_);
    gl_.BindSampler(kFetchUnit, 0);
}

AgaaResult FrameHost::createView() {
    AgaaConfig config = AGAA_CONFIG_INIT;
    config.technique = settings_.technique.c_str();
    config.samples = settings_.samples;
    config.generationTier = settings_.generationTier;
    config.flags = settings_.flags | AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = kWidth;
    desc.height = kHeight;
    desc.config = &config;
    desc.facts = &facts;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE | (settings_.composite ? AGAA_VIEW_COMPOSITE : 0);
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = kFetchFunctions;
    fetch.maxDraws = fetch.maxPrimitives = 1;
    fetch.flags = settings_.fetchFlags;
    desc.pNext = settings_.fetches ? &fetch : nullptr;
    const AgaaResult result = agaaGlCreateView(context_, &desc, &view_);
    if (result != AGAA_OK)
        return result;
    uint32_t count = 0;
    agaaGetDrawPasses(view_, &count, nullptr);
    passes_.assign(count, AGAA_DRAW_PASS_INIT);
    agaaGetDrawPasses(view_, &count, passes_.data());
    for (const AgaaDrawPass& pass : passes_)
        programs_.push_back(program(pass));
    return AGAA_OK;
}

uint32_t FrameHost::program(const AgaaDrawPass& pass) {
    const GLuint made = gl_.CreateProgram();
    attach(gl_, made, GL_VERTEX_SHADER, kVertexShader);
    attach(gl_, made, GL_FRAGMENT_SHADER,
           std::string("#version 450\n") + pass.glslExtensions + pass.glslDeclarations + kFragmentBody);
    gl_.LinkProgram(made);
    GLint linked = GL_FALSE;
    gl_.GetProgramiv(made, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        char text[2048] = "";
        gl_.GetProgramInfoLog(made, sizeof text, nullptr, text);
        throw std::runtime_error(text);
    }
    return made;
}

AgaaFrame FrameHost::frame(uint64_t segments) {
    light_.type = AGAA_LIGHT_DIRECTIONAL;
    light_.direction[2] = -1.0f;
    light_.color[0] = light_.color[1] = light_.color[2] = 1.0f;
    shadow_.layerCount = 1;
    for (int i = 0; i < 4; ++i)
        shadow_.matrices[0][5 * i] = i == 3 ? 10.0f : 1.0f;
    AgaaFrame out = AGAA_FRAME_INIT;
    if (segments & AGAA_SEGMENT_PREPASS)
        ++frameIndex;
    gl_.Finish();
    out.frameIndex = frameIndex;
    out.completedFrame = frameIndex - 1;
    out.segments = segments;
    out.projection[0] = out.projection[5] = 1.0f;
    out.projection[10] = -(kFar + kNear) / (kFar - kNear);
    out.projection[11] = -1.0f;
    out.projection[14] = -2.0f * kFar * kNear / (kFar - kNear);
    out.lightCount = out.shadowCount = 1;
    out.lights = &light_;
    out.shadows = &shadow_;
    out.ambient[0] = out.ambient[1] = out.ambient[2] = 0.25f;
    out.background[3] = settings_.composite ? 0.0f : 1.0f;
    out.draw = draw;
    out.drawUser = this;
    return out;
}

AgaaResult FrameHost::record(const AgaaFrame& frame, uint32_t outputTexture) {
    if (frame.segments & AGAA_SEGMENT_PREPASS)
        calls.clear();
    bindFetched();
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = outputTexture;
    glFrame.shadowTextures[0] = shadowMap_;
    return agaaGlRecordFrame(view_, &frame, &glFrame);
}

void FrameHost::readStatistics() {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    EXPECT_EQ(agaaGetFrameStatistics(view_, frameIndex, &statistics), AGAA_OK);
    EXPECT_GT(statistics.counters.visible, 0u);
    EXPECT_NE(statistics.timeSource, uint32_t(AGAA_TIME_NONE));
    EXPECT_GT(statistics.passCount, 0u);
    double sum = 0;
    for (uint32_t i = 0; i < statistics.passCount; ++i) {
        EXPECT_EQ(statistics.passes[i].isTimed, 1u) << statistics.passes[i].name;
        EXPECT_GE(statistics.passes[i].milliseconds, 0.0) << statistics.passes[i].name;
        EXPECT_LT(statistics.passes[i].milliseconds, 1e5) << statistics.passes[i].name;
        sum += statistics.passes[i].milliseconds;
    }
    EXPECT_GT(sum, 0.0);
}

std::vector<StateText> FrameHost::read() const { return readState(gl_, watchedScope(), compatibility_); }

AgaaResult AGAA_CALL FrameHost::draw(void* user, const AgaaDrawTarget* target) {
    auto& host = *static_cast<FrameHost*>(user);
    const auto number = static_cast<uint32_t>(std::count(host.calls.begin(), host.calls.end(), 'd'));
    host.calls += 'd';
    if (host.beforeDraw)
        host.beforeDraw();
    host.drawTriangle(*target);
    return host.afterDraw ? host.afterDraw(number) : AGAA_OK;
}

void FrameHost::drawTriangle(const AgaaDrawTarget& target) {
    useDefaults();
    const AgaaDrawState& state = target.state;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, static_cast<GLsizei>(target.width), static_cast<GLsizei>(target.height));
    gl_.Enable(GL_DEPTH_TEST);
    constexpr GLenum compare[] = {GL_LESS, GL_GREATER, GL_EQUAL, GL_ALWAYS};
    gl_.DepthFunc(compare[state.depthCompare]);
    gl_.DepthMask(state.depthWrite != 0 ? GL_TRUE : GL_FALSE);
    if (state.stencilTest != 0) {
        gl_.Enable(GL_STENCIL_TEST);
        gl_.StencilFunc(GL_EQUAL, 0, 0xFF);
        gl_.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    }
    const auto mask = [&](uint32_t bit) { return (state.colorWriteMask & bit) != 0 ? GL_TRUE : GL_FALSE; };
    gl_.ColorMask(mask(1), mask(2), mask(4), mask(8));
    if (state.keepFirst != 0) {
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    }
    if (state.additive != 0) {
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_ONE, GL_ONE);
    }
    if (state.sampleShading != 0) {
        gl_.Enable(GL_SAMPLE_SHADING);
        gl_.MinSampleShading(1.0f);
    }
    gl_.BindVertexArray(vertexArray_);
    for (size_t i = 0; i < passes_.size(); ++i)
        if (passes_[i].pass == target.pass) {
            gl_.UseProgram(programs_[i]);
            if (target.constants)
                gl_.Uniform4fv(gl_.GetUniformLocation(programs_[i], "agaa_constants"), GLsizei(target.constantCount),
                               target.constants);
        }
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void FrameHost::clearOutput() {
    const GLfloat color[] = {0.25f, 0.5f, 0.75f, 1.0f};
    useDefaults();
    gl_.ClearTexImage(output, 0, GL_RGBA, GL_FLOAT, color);
}

std::vector<float> FrameHost::picture() {
    std::vector<float> texels(size_t{4} * kWidth * kHeight);
    useDefaults();
    gl_.GetTextureImage(output, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * 4), texels.data());
    return texels;
}

} // namespace agaa::test
