#include "stage_host.h"

#include "compute_pass.h"
#include "plan_view.h"

#include "gl/draw_state.h"
#include "render/draw_pass.h"

#include <gtest/gtest.h>

#include <glm/gtc/type_ptr.hpp>

#include <cstddef>
#include <stdexcept>

using namespace harness::gl;

namespace agaa::test {

namespace {

// The materials' vectors are attributes of each corner.
constexpr const char* vertexText = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec4 material[5];
layout(location = 6) in vec2 coordinates;
uniform mat4 clip;
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec4 constants[5];
layout(location = 6) flat out uvec2 drawn;
layout(location = 7) out vec2 uv;
invariant gl_Position;
void main() {
    position = corner + float(gl_InstanceID) * STAGE_INSTANCE_STEP;
    constants = material;
    uv = coordinates;
    drawn = uvec2(gl_InstanceID, gl_VertexID / 3);
    precise vec4 place = clip * vec4(position, 1.0); // as pullingText
    gl_Position = place;
}
)";

// Of passes with AgaaDrawPass::glslVertex, in place of vertexText: an instance is a triangle, and its vertices are 25
// floats each.
constexpr const char* pullingText = R"(
layout(std430, binding = 6) readonly buffer Vertices { float words[]; } vertices;
uniform mat4 clip;
uniform uint firstTriangle, instance;
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec4 constants[5];
layout(location = 6) flat out uvec2 drawn;
layout(location = 7) out vec2 uv;
vec3 placeOf(uint vertex) {
    uint word = 25u * vertex;
    return vec3(vertices.words[word], vertices.words[word + 1u], vertices.words[word + 2u]) +
           float(instance) * STAGE_INSTANCE_STEP;
}
void main() {
    uint triangle = firstTriangle + uint(gl_InstanceID);
    position = placeOf(3u * triangle);
    for (uint i = 0u; i < 20u; ++i)
        constants[i / 4u][i % 4u] = vertices.words[75u * triangle + 3u + i];
    uv = vec2(vertices.words[75u * triangle + 23u], vertices.words[75u * triangle + 24u]);
    drawn = uvec2(instance, triangle);
    precise vec4 a = clip * vec4(position, 1.0);
    precise vec4 b = clip * vec4(placeOf(3u * triangle + 1u), 1.0);
    precise vec4 c = clip * vec4(placeOf(3u * triangle + 2u), 1.0);
    agaa_pullVertex(a, b, c, uint(gl_VertexID));
}
)";

// Of passes with expansionText of a test, which moves each corner by its agaa_place().
constexpr const char* geometryText = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 0) in vec3 positions[];
layout(location = 1) flat in vec4 materials[][5];
layout(location = 6) flat in uvec2 draws[];
layout(location = 7) in vec2 uvs[];
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec4 constants[5];
layout(location = 6) flat out uvec2 drawn;
layout(location = 7) out vec2 uv;
void main() {
    for (int i = 0; i < 3; ++i) {
        position = positions[i];
        constants = materials[i];
        drawn = draws[i];
        uv = uvs[i];
        gl_Position = agaa_place(gl_in[i].gl_Position);
        EmitVertex();
    }
}
)";

// Of passes whose fragments need the corners of their triangle.
constexpr const char* hullText = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out;
layout(location = 0) in vec3 positions[];
layout(location = 1) flat in vec4 materials[][5];
layout(location = 6) flat in uvec2 draws[];
layout(location = 7) in vec2 uvs[];
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec4 constants[5];
layout(location = 6) flat out uvec2 drawn;
layout(location = 7) out vec2 uv;
void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        position = positions[0];
        constants = materials[0];
        drawn = draws[0];
        uv = uvs[0];
        agaa_setVertex(i);
        EmitVertex();
    }
}
)";

constexpr const char* fragmentText = R"(
layout(location = 0) in vec3 position;
layout(location = 1) flat in vec4 constants[5];
layout(location = 6) flat in uvec2 drawn;
layout(location = 7) in vec2 uv;
void main() {
    uint triangle = drawn.y;
    vec2 spare = vec2(constants[1].w, constants[2].w);
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = position;
    s.diffuse = constants[0].xyz;
    s.alpha = constants[0].w * STAGE_ALPHA_FACTOR;
    s.specular = constants[1].xyz;
    s.emissive = constants[2].xyz;
    s.normal = constants[3].xyz;
    s.alpha2 = constants[3].w;
    s.geometricNormal = constants[4].xyz;
    s.primitiveSeed = uint(constants[4].w);
    s.draw = STAGE_DRAW + drawn.x;
    s.primitive = triangle;
)";

struct Vertex {
    glm::vec3 position;
    Material material;
    glm::vec2 uv;
};

void require(AgaaResult result, const StageContext& context, const char* call) {
    if (result < 0)
        throw std::runtime_error(context.lines.empty() ? call : context.lines.back().text);
}

} // namespace

EglContext& sharedEgl() {
    static EglContext egl(leastContext);
    return egl;
}

static uint32_t glslVersion(const GladGLContext& gl) { return gl.VERSION_4_5 ? 450 : 430; }

OpenGLContextDesc contextDesc() {
    OpenGLContextDesc desc(AGAA_GL_DEVICE_DESC_INIT);
    desc.device.getProcAddr = EglContext::getProcAddr;
    desc.device.glslVersion = glslVersion(sharedEgl().gl());
    return desc;
}

StageContext::StageContext(const OpenGLContextDesc& wanted, EglContext& egl) : egl_(egl) {
    egl.makeCurrent();
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = collectLines;
    log.user = &lines;
    OpenGLContextDesc desc = wanted;
    desc.log = &log;
    require(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context_), *this, "agaaGlCreateContext");
    require(agaaGlGetContextCaps(context_, &caps_), *this, "agaaGlGetContextCaps");
}

StageContext::~StageContext() {
    egl_.makeCurrent();
    destroy();
    EXPECT_EQ(egl_.takeMessages(), "");
}

void StageContext::destroy() {
    agaaDestroyContext(context_);
    context_ = nullptr;
}

Texture shadowMap(const GladGLContext& gl, float depth) {
    Texture map = createTexture(gl, GL_TEXTURE_2D_ARRAY);
    gl.TextureStorage3D(map.get(), 1, GL_DEPTH_COMPONENT32F, 4, 4, 1);
    const Framebuffer framebuffer = createFramebuffer(gl);
    gl.NamedFramebufferTextureLayer(framebuffer.get(), GL_DEPTH_ATTACHMENT, map.get(), 0, 0);
    gl.NamedFramebufferDrawBuffer(framebuffer.get(), GL_NONE);
    gl.DepthMask(GL_TRUE); // clears obey it
    gl.ClearNamedFramebufferfv(framebuffer.get(), GL_DEPTH, 0, &depth);
    return map;
}

GLuint deletedTexture(const GladGLContext& gl) {
    GLuint name = 0;
    gl.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    gl.DeleteTextures(1, &name);
    return name;
}

StageView::StageView(StageContext& context, const ViewSettings& settings)
    : context_(context), gl_(context.egl().gl()), settings_(settings), output_(createTexture(gl_, GL_TEXTURE_2D)),
      vertexArray_(createVertexArray(gl_)), vertices_(createBuffer(gl_)) {
    gl_.TextureStorage2D(output_.get(), 1, GL_RGBA32F, GLsizei(settings.width), GLsizei(settings.height));
    const AgaaViewDesc desc = viewDesc(settings_);
    if (settings.build)
        view_ = makePlanView<agaa::gl::View, agaa::gl::Context>(context.get(), desc, settings.build);
    else
        require(agaaGlCreateView(context.get(), &desc, &view_), context, "agaaGlCreateView");
    uint32_t count = 0;
    agaaGetDrawPasses(view_, &count, nullptr);
    std::vector<AgaaDrawPass> passes(count, AgaaDrawPass AGAA_DRAW_PASS_INIT);
    require(agaaGetDrawPasses(view_, &count, passes.data()), context, "agaaGetDrawPasses");
    for (const AgaaDrawPass& pass : passes)
        programs_.emplace(pass.pipelineKey, PassPrograms{passProgram(pass, false), passProgram(pass, true)});
    const GLuint array = vertexArray_.get();
    gl_.VertexArrayVertexBuffer(array, 0, vertices_.get(), 0, sizeof(Vertex));
    const auto addAttribute = [&](GLuint location, GLint count, size_t offset) {
        gl_.EnableVertexArrayAttrib(array, location);
        gl_.VertexArrayAttribFormat(array, location, count, GL_FLOAT, GL_FALSE, GLuint(offset));
        gl_.VertexArrayAttribBinding(array, location, 0);
    };
    addAttribute(0, 3, offsetof(Vertex, position));
    for (GLuint i = 0; i < 5; ++i)
        addAttribute(1 + i, 4, offsetof(Vertex, material) + i * sizeof(glm::vec4));
    addAttribute(6, 2, offsetof(Vertex, uv));
}

StageView::~StageView() {
    context_.egl().makeCurrent();
    agaaDestroyView(view_);
}

StageView::PassProgram StageView::passProgram(const AgaaDrawPass& pass, bool isMasked) const {
    const std::string version = versionLine(glslVersion(gl_)), defines = shaderDefines(settings_, pass.pass, isMasked);
    PassProgram made;
    made.vertex =
        pass.glslVertex
            ? rasterisedInOrder(settings_, version + pass.glslExtensions + defines + pass.glslVertex + pullingText)
            : version + defines + vertexText;
    made.fragment = rasterisedInOrder(settings_, version + pass.glslExtensions + defines + pass.glslDeclarations +
                                                     fragmentText + emitText);
    if (pass.glslGeometry)
        made.geometry =
            rasterisedInOrder(settings_, version + pass.glslExtensions + pass.glslGeometry +
                                             (pass.pass == AGAA_DRAW_PASS_FRAGMENTS ? hullText : geometryText));
    made.name = pass.name;
    return made;
}

void StageView::setTriangles(const std::vector<Triangle>& triangles) {
    std::vector<Vertex> vertices;
    for (size_t i = 0; i < triangles.size(); ++i)
        for (size_t corner = 0; corner < 3; ++corner) {
            vertices.push_back({triangles[i].position[corner], triangles[i].material, triangles[i].uv[corner]});
            vertices.back().material.geometricNormal.w = float(triangles[i].seed ? triangles[i].seed : uint32_t(i));
        }
    gl_.NamedBufferData(vertices_.get(), GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(), GL_STATIC_DRAW);
    for (uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE, AGAA_DRAW_PASS_GBUFFER,
                          AGAA_DRAW_PASS_FORWARD, AGAA_DRAW_PASS_FRAGMENTS})
        runs_[pass] = drawRuns(settings_, triangles, pass);
}

AgaaFrame StageView::frame() {
    AgaaFrame frame = nextFrame(settings_, frameIndex_);
    frame.draw = onDraw;
    frame.drawUser = this;
    return frame;
}

AgaaGlFrame StageView::glFrame() const {
    AgaaGlFrame frame = AGAA_GL_FRAME_INIT;
    frame.outputTexture = output_.get();
    return frame;
}

void StageView::render(const AgaaFrame& wanted, const AgaaGlFrame& glFrame, bool splitSegments) {
    AgaaFrame frame = wanted;
    for (uint64_t segments : segmentCalls(splitSegments)) {
        frame.segments = segments;
        require(agaaGlRecordFrame(view_, &frame, &glFrame), context_, "agaaGlRecordFrame");
    }
    gl_.Finish();
}

std::vector<float> StageView::image() const {
    std::vector<float> texels(size_t(4) * settings_.width * settings_.height);
    gl_.GetTextureImage(output_.get(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(float)), texels.data());
    return texels;
}

AgaaFrameStatistics StageView::statistics() const {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    require(agaaGetFrameStatistics(view_, frameIndex_, &statistics), context_, "agaaGetFrameStatistics");
    return statistics;
}

std::vector<glm::uvec4> StageView::readSurface(const std::string& name) const {
    const Resource& resource = plan().resources[findResource(plan(), name)];
    AgaaGlSurface surface = AGAA_GL_SURFACE_INIT;
    AgaaSurface common = AGAA_SURFACE_INIT;
    common.pNext = &surface;
    require(agaaGetSurface(view_, name.c_str(), &common), context_, "agaaGetSurface");
    std::vector<glm::uvec4> texels(size_t(resource.width) * resource.height * resource.samples);
    const auto bytes = GLsizeiptr(texels.size() * sizeof texels[0]);
    const Buffer out = createBuffer(gl_);
    gl_.NamedBufferData(out.get(), bytes, nullptr, GL_STATIC_READ);
    gl_.BindTextureUnit(0, surface.texture);
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.get());
    ComputePass(gl_, versionLine(glslVersion(gl_)) + surfaceText(resource)).run(resource.width, resource.height);
    gl_.BindTextureUnit(0, 0);
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, 0);
    gl_.GetNamedBufferSubData(out.get(), 0, bytes, texels.data());
    return texels;
}

std::vector<uint32_t> StageView::readBuffer(const std::string& name) const {
    const ResourceId id = findResource(plan(), name);
    const Resource& resource = plan().resources[id];
    std::vector<uint32_t> words(resource.bytes / 4);
    if (resource.kind == ResourceKind::Image) {
        gl_.MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        gl_.GetTextureImage((*executor().resources)[id].texture, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                            GLsizei(4 * words.size()), words.data());
        return byPixels(resource, words);
    }
    gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl_.GetNamedBufferSubData(executor().resources->buffer(id, 0), 0, GLsizeiptr(4 * words.size()), words.data());
    return words;
}

AgaaResult AGAA_CALL StageView::onDraw(void* user, const AgaaDrawTarget* target) {
    return static_cast<StageView*>(user)->draw(*target);
}

AgaaResult StageView::draw(const AgaaDrawTarget& target) {
    ++drawCalls;
    batches.push_back(target.batch);
    states.push_back(target.state);
    if (beforeDraw)
        beforeDraw();
    if (const auto result = drawResults.find(target.pass); result != drawResults.end())
        return result->second;
    const AgaaDrawState state = drawState(settings_, target.state, target.pass);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    setTarget(gl_, target.width, target.height);
    setDrawState(gl_, state);
    gl_.Disable(GL_CULL_FACE);
    gl_.ClipControl(GL_LOWER_LEFT,
                    settings_.flags & AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE ? GL_NEGATIVE_ONE_TO_ONE : GL_ZERO_TO_ONE);
    gl_.BindVertexArray(vertexArray_.get());
    if (state.vertexPulling)
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, vertices_.get());
    for (const std::span<const AgaaViewport> viewports : harness::viewportGroups(target)) {
        setViewports(gl_, viewports);
        drawAll(target, state);
    }
    gl_.Disable(GL_SCISSOR_TEST);
    return AGAA_OK;
}

void StageView::drawAll(const AgaaDrawTarget& target, const AgaaDrawState& state) {
    PassPrograms& programs = programs_.at(target.pipelineKey);
    const glm::mat4 clip = clipMatrix(settings_, target.pass);
    for (const Run& run : runs_.at(target.pass)) {
        PassProgram& made = programs[run.isMasked];
        if (!made.linked)
            made.linked = Program(gl_, made.vertex, made.fragment, made.name, made.geometry);
        const Program& program = made.linked;
        gl_.UseProgram(program.get());
        setStencilTest(gl_, run.isMasked ? state.stencilTestMasked : state.stencilTest);
        gl_.UniformMatrix4fv(program.uniform("clip"), 1, GL_FALSE, glm::value_ptr(clip));
        if (!state.vertexPulling)
            gl_.DrawArraysInstanced(GL_TRIANGLES, GLint(3 * run.first), GLsizei(3 * run.count),
                                    GLsizei(settings_.instances));
        for (uint32_t instance = 0; state.vertexPulling && instance < settings_.instances; ++instance) {
            gl_.Uniform1ui(program.uniform("firstTriangle"), run.first);
            gl_.Uniform1ui(program.uniform("instance"), instance);
            gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 8, GLsizei(run.count));
        }
    }
}

} // namespace agaa::test
