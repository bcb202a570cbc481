// The suite's host on OpenGL. It relies on OpenGL's initial state, including glClipControl.
#include "drawing.h"
#include "gl_draw_state.h"
#include "gl_programs.h"
#include "host_shaders.h"

#include <algorithm>
#include <cstddef>

namespace agaa::conformance {

namespace {

constexpr GLenum outputFormat = GL_RGBA32F;
constexpr GLuint fetchBinding = 6; // the SDK's passes use lower bindings

struct Attribute {
    GLint size;
    GLuint offset;
};
constexpr Attribute attributes[] = {{3, offsetof(Vertex, position)},  {3, offsetof(Vertex, normal)},
                                    {4, offsetof(Vertex, diffuse)},   {3, offsetof(Vertex, specular)},
                                    {1, offsetof(Vertex, roughness)}, {3, offsetof(Vertex, emissive)}};

class OpenGlDevice : public Device {
public:
    OpenGlDevice(const std::string& name, const OpenGlVersion& version) : api_(name, version), programs_(mistakes) {
        glCreateVertexArrays(1, &vertexArray_);
        for (GLuint i = 0; i < std::size(attributes); ++i) {
            glVertexArrayAttribFormat(vertexArray_, i, attributes[i].size, GL_FLOAT, GL_FALSE, attributes[i].offset);
            glVertexArrayAttribBinding(vertexArray_, i, 0);
            glEnableVertexArrayAttrib(vertexArray_, i);
        }
        // Attributes of pullingShader: those of the first corner, then the positions of the others.
        glCreateVertexArrays(1, &pullingArray_);
        for (GLuint i = 0; i < std::size(attributes) + 2; ++i) {
            const GLuint corner = i < std::size(attributes) ? 0 : i - GLuint(std::size(attributes)) + 1;
            const Attribute& attribute = attributes[corner ? 0 : i];
            glVertexArrayAttribFormat(pullingArray_, i, attribute.size, GL_FLOAT, GL_FALSE,
                                      attribute.offset + corner * GLuint(sizeof(Vertex)));
            glVertexArrayAttribBinding(pullingArray_, i, 0);
            glEnableVertexArrayAttrib(pullingArray_, i);
        }
        glVertexArrayBindingDivisor(pullingArray_, 0, 1);
        setShadowDepth(1.0f);
    }
    ~OpenGlDevice() override {
        glDeleteTextures(1, &output_);
        glDeleteTextures(1, &shadow_);
        glDeleteTextures(GLsizei(resolved_.size()), resolved_.data());
        glDeleteVertexArrays(1, &vertexArray_);
        glDeleteVertexArrays(1, &pullingArray_);
    }

    AgaaFetchFunction sceneFetch() const override {
        static const std::string text = fetchShader("binding = 6");
        AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
        fetch.glsl = text.c_str();
        fetch.maxDraws = 1;
        fetch.maxPrimitives = maxScenePrimitives;
        return fetch;
    }

    Backend backend() const override { return Backend::OpenGl; }
    std::string deviceName() const override { return api_.deviceName; }
    std::string driverName() const override { return api_.driverName; }
    uint64_t viewFlags() const override { return AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; }
    bool testsMessages() const override { return true; }
    std::vector<std::string> takeMessages() override { return api_.takeMessages(); }

    ContextDescription description() override {
        const AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
        const AgaaVkDeviceDesc vk = AGAA_VK_DEVICE_DESC_INIT;
        const AgaaGlDeviceDesc gl = AGAA_GL_DEVICE_DESC_INIT;
        ContextDescription description = {desc, vk, gl};
        description.gl.getProcAddr = getProcAddr;
        return description;
    }

    AgaaResult createContext(const Functions& sdk, uint32_t headerVersion, ContextDescription& description,
                             AgaaContext* outContext) override {
        description.gl.pNext = description.desc.pNext;
        description.desc.pNext = &description.gl;
        const AgaaResult result = sdk.agaaGlCreateContext(headerVersion, &description.desc, outContext);
        if (result == AGAA_OK)
            dialectOfContext_[*outContext] = {description.gl.glslVersion,
                                              description.gl.outputs == AGAA_GL_OUTPUTS_HOST};
        return result;
    }

    AgaaResult createView(const Functions& sdk, AgaaContext context, const AgaaViewDesc* desc,
                          AgaaView* outView) override {
        const AgaaResult result = sdk.agaaGlCreateView(context, desc, outView);
        if (result == AGAA_OK)
            adopt(context, *outView);
        return result;
    }

    void adopt(AgaaContext context, AgaaView view) override { dialectOfView_[view] = dialectOfContext_[context]; }

    AgaaResult getContextCaps(const Functions& sdk, AgaaContext context, AgaaDeviceCaps* outCaps) override {
        return sdk.agaaGlGetContextCaps(context, outCaps);
    }

    AgaaResult getDeviceCaps(const Functions& sdk, const AgaaLog* log, AgaaDeviceCaps* outCaps) override {
        return sdk.agaaGlGetDeviceCaps(getProcAddr, nullptr, log, outCaps);
    }

    void prepare(const Functions& sdk, AgaaView view) override { programs_.prepare(sdk, view, dialectOfView_[view]); }

    void forget(AgaaView view) override {
        programs_.forget(view);
        dialectOfView_.erase(view);
    }

    void setOutput(uint32_t width, uint32_t height) override {
        if (!output_ || width_ != width || height_ != height) {
            glDeleteTextures(1, &output_);
            glCreateTextures(GL_TEXTURE_2D, 1, &output_);
            glTextureStorage2D(output_, 1, outputFormat, GLsizei(width), GLsizei(height));
            width_ = width;
            height_ = height;
        }
        fillOutput(0.0f);
    }

    void fillOutput(float value) override {
        const float color[4] = {value, value, value, value};
        glClearTexImage(output_, 0, GL_RGBA, GL_FLOAT, color);
    }

    std::vector<float> readOutput() override {
        std::vector<float> pixels(size_t(width_) * height_ * 4);
        glGetTextureImage(output_, 0, GL_RGBA, GL_FLOAT, GLsizei(pixels.size() * sizeof(float)), pixels.data());
        return pixels;
    }

    void setResolvedOutputs(uint32_t count) override {
        glDeleteTextures(GLsizei(resolved_.size()), resolved_.data());
        resolved_.assign(count, 0);
        resolvedTextures_ = AGAA_GL_RESOLVED_TEXTURES_INIT;
        glCreateTextures(GL_TEXTURE_2D, GLsizei(count), resolved_.data());
        for (uint32_t i = 0; i < count; ++i) {
            glTextureStorage2D(resolved_[i], 1, outputFormat, GLsizei(width_), GLsizei(height_));
            resolvedTextures_.textures[i] = resolved_[i];
        }
    }

    std::vector<float> readResolvedOutput(uint32_t i) override {
        std::vector<float> pixels(size_t(width_) * height_ * 4);
        glGetTextureImage(resolved_.at(i), 0, GL_RGBA, GL_FLOAT, GLsizei(pixels.size() * sizeof(float)), pixels.data());
        return pixels;
    }

    void setShadowDepth(float depth) override {
        if (!shadow_) {
            glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &shadow_);
            glTextureStorage3D(shadow_, 1, GL_DEPTH_COMPONENT32F, 4, 4, AGAA_MAX_SHADOW_LAYERS);
        }
        glClearTexImage(shadow_, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    }

    void bindScene() const override { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, fetchBinding, vertices_); }
    AgaaResult record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) override;
    AgaaResult draw(const AgaaDrawTarget& target) override;

private:
    static AgaaGlFunction AGAA_CALL getProcAddr(void*, const char* name) { return eglGetProcAddress(name); }

    GLuint upload(const Scene& scene) {
        std::vector<char> bytes(sceneBytes(scene));
        writeScene(bytes.data(), clipFromShading_, scene);
        GLuint buffer = 0;
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, GLsizeiptr(bytes.size()), bytes.data(), 0);
        uploads_.push_back(buffer);
        return buffer;
    }

    void drawRangesOf(const Scene& scene, const OpenGlProgram& programs, const AgaaDrawTarget& target,
                      const AgaaDrawState& state) const;
    void drawScene(const Scene& scene, GLuint vertices, const OpenGlProgram& programs, const AgaaDrawTarget& target,
                   const AgaaDrawState& state) const;

    OpenGlApi api_;
    OpenGlPrograms programs_;
    GLuint vertexArray_ = 0, pullingArray_ = 0, output_ = 0, shadow_ = 0;
    std::vector<GLuint> resolved_;
    AgaaGlResolvedTextures resolvedTextures_ = AGAA_GL_RESOLVED_TEXTURES_INIT;
    uint32_t width_ = 0, height_ = 0; // size of the output
    std::map<AgaaContext, ShaderDialect> dialectOfContext_;
    std::map<AgaaView, ShaderDialect> dialectOfView_;
    // Set during record().
    AgaaView view_ = nullptr;
    const Scene* scene_ = nullptr;
    GLuint vertices_ = 0;
    float clipFromShading_[16];
    std::vector<GLuint> uploads_;
};

AgaaResult OpenGlDevice::record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) {
    view_ = view;
    scene_ = &scene;
    clipFromShading(frame, mistakes, clipFromShading_);
    const bool isOurs = !frame.draw;
    if (isOurs) {
        frame.draw = drawCallback;
        frame.drawUser = this;
    }
    vertices_ = upload(scene);
    bindScene();
    AgaaGlFrame native = AGAA_GL_FRAME_INIT;
    native.outputTexture = output_;
    for (uint32_t& map : native.shadowTextures)
        map = shadow_;
    if (!resolved_.empty())
        native.pNext = &resolvedTextures_;
    if (changeGlFrame)
        changeGlFrame(native);
    const AgaaResult result = sdk.agaaGlRecordFrame(view, &frame, &native);
    glFinish();
    glDeleteBuffers(GLsizei(uploads_.size()), uploads_.data());
    uploads_.clear();
    if (isOurs) {
        frame.draw = nullptr;
        frame.drawUser = nullptr;
    }
    return result;
}

AgaaResult OpenGlDevice::draw(const AgaaDrawTarget& target) {
    const OpenGlProgram* programs = programs_.find(view_, target.pipelineKey, target.pass);
    if (!programs)
        return AGAA_ERROR_CALLBACK;
    AgaaDrawState state = target.state;
    if (mistakes.changeState)
        mistakes.changeState(target.pass, state);
    if (mistakes.changeScene) {
        const Scene changed = mistakes.changeScene(target, *scene_);
        drawScene(changed, upload(changed), *programs, target, state);
    } else
        drawScene(*scene_, vertices_, *programs, target, state);
    bindScene(); // some tests change the bindings before the callback
    return AGAA_OK;
}

static void setViewport(GLuint index, const AgaaViewport& v) {
    glViewportIndexedf(index, v.x, v.y, v.width, v.height);
    glScissorIndexed(index, GLint(v.scissorX), GLint(v.scissorY), GLsizei(v.scissorWidth), GLsizei(v.scissorHeight));
    glEnablei(GL_SCISSOR_TEST, index);
}

void OpenGlDevice::drawScene(const Scene& scene, GLuint vertices, const OpenGlProgram& programs,
                             const AgaaDrawTarget& target, const AgaaDrawState& state) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    setDrawState(state, mistakes.blends);
    const GLuint vertexArray = state.vertexPulling ? pullingArray_ : vertexArray_;
    glVertexArrayVertexBuffer(vertexArray, 0, vertices, matrixBytes, (state.vertexPulling ? 3 : 1) * sizeof(Vertex));
    glBindVertexArray(vertexArray);
    const uint32_t together = std::max(state.multicast, 1u);
    for (uint32_t first = 0; first < target.viewportCount; first += together) {
        for (uint32_t i = 0; i < together; ++i)
            setViewport(i, target.viewports[first + i]);
        drawRangesOf(scene, programs, target, state);
    }
    setCapability(GL_SCISSOR_TEST, false);
}

void OpenGlDevice::drawRangesOf(const Scene& scene, const OpenGlProgram& programs, const AgaaDrawTarget& target,
                                const AgaaDrawState& state) const {
    for (const DrawRange& range : drawRanges(scene)) {
        const GLuint program = range.isMasked ? programs.masked : programs.opaque;
        setCapability(GL_STENCIL_TEST, (range.isMasked ? state.stencilTestMasked : state.stencilTest) != 0);
        glUseProgram(program);
        glUniformMatrix4fv(0, 1, GL_FALSE, clipFromShading_);
        if (target.constants) // the location is -1, which OpenGL ignores, if the program does not use it
            glUniform4fv(glGetUniformLocation(program, "agaa_constants"), GLsizei(target.constantCount),
                         target.constants);
        if (!state.vertexPulling) {
            glDrawArrays(GL_TRIANGLES, GLint(range.first), GLsizei(range.count));
            continue;
        }
        glUniform1ui(glGetUniformLocation(program, "firstTriangle"), range.first / 3);
        glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, stripVertices, GLsizei(range.count / 3),
                                          range.first / 3);
    }
}

} // namespace

std::unique_ptr<Device> makeOpenGlDevice(const std::string& name, const OpenGlVersion& version) {
    return std::make_unique<OpenGlDevice>(name, version);
}

std::unique_ptr<Device> makeOpenGlDevice(const std::string& name) {
    try {
        return makeOpenGlDevice(name, {4, 5, false});
    } catch (const Skipped&) {
        return makeOpenGlDevice(name, {4, 3, false});
    }
}

} // namespace agaa::conformance
