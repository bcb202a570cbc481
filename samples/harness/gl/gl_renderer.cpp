#include "gl/gl_renderer.h"

#include "gl/draw_state.h"

#include <glm/gtc/type_ptr.hpp>

#include <chrono>

namespace harness {

using namespace gl;

GlRenderer::GlRenderer(const RendererOptions& options)
    : options_(options), device_(options), sdk_(device_, options), programs_(device_.gl(), options),
      shadowMaps_(device_.gl(), options.shadowMapSize), motion_(device_.gl()),
      cameraConstants_(createBuffer(device_.gl())) {
    device_.checkTextureSize(options.shadowMapSize, options.shadowMapSize);
    device_.gl().NamedBufferData(cameraConstants_.get(), sizeof(CameraConstants), nullptr, GL_DYNAMIC_DRAW);
}

// Objects are deleted in their own context.
GlRenderer::~GlRenderer() { device_.makeCurrent(); }

uint64_t GlRenderer::viewFlags() const { return options_.clipZFromMinusOne ? AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE : 0; }

// Maps z from [0, w] to [-w, w].
glm::dmat4 GlRenderer::rasterised(const glm::dmat4& projection) const {
    if (!options_.clipZFromMinusOne)
        return projection;
    glm::dmat4 result = projection;
    for (int column = 0; column < 4; ++column)
        result[column][2] = 2 * projection[column][2] - projection[column][3];
    return result;
}

void GlRenderer::upload() {
    device_.makeCurrent();
    shadowMaps_.invalidate();
    fetch_.reset();
    strips_.reset();
    gpuScene_.reset();
    gpuScene_.emplace(device_.gl(), scene());
}

const AgaaFetchFunction* GlRenderer::fetchFunction(bool) {
    device_.makeCurrent();
    if (!fetch_)
        fetch_.emplace(device_.gl(), scene(), *gpuScene_);
    return &fetch_->function();
}

EnvironmentBindings GlRenderer::useEnvironment(const std::shared_ptr<const Environment>& environment, bool) {
    device_.makeCurrent();
    if (environmentSource_ != environment) {
        environment_.emplace(device_.gl(), *environment);
        environmentSource_ = environment;
    }
    return {"binding = " + std::to_string(GpuEnvironment::mapUnit),
            "binding = " + std::to_string(GpuEnvironment::constantsBinding), 0};
}

FilteredShadowBindings GlRenderer::useFilteredShadows() {
    device_.makeCurrent();
    if (!filteredShadows_)
        filteredShadows_.emplace(device_.gl());
    return {"binding = " + std::to_string(GpuFilteredShadows::mapUnit),
            "binding = " + std::to_string(GpuFilteredShadows::constantsBinding), 0};
}

AgaaView GlRenderer::useView(const AgaaViewDesc& desc) {
    device_.makeCurrent();
    view_ = &sdk_.view(desc);
    return view_->view;
}

void GlRenderer::prepare(const FrameInput& input) {
    const GladGLContext& gl = device_.gl();
    const RenderSettings& settings = input.settings;
    if (outputWidth_ != settings.width || outputHeight_ != settings.height) {
        device_.checkTextureSize(settings.width, settings.height);
        outputWidth_ = settings.width;
        outputHeight_ = settings.height;
        output_ = makeOutput();
        resolved_.clear();
    }
    while (resolved_.size() < resolvedValues(settings).size())
        resolved_.push_back(makeOutput());
    shadowMaps_.update(*gpuScene_, scene(), settings, input.camera, input.placement);
    if (settings.filtersShadows && filteredShadows_)
        filteredShadows_->update(shadowMaps_);
    for (const DrawPass<AgaaGlDrawPass>& pass : view_->passes) {
        programs_.prepare(pass, scene(), input.draws);
        if (pass.state.vertexPulling && !strips_)
            strips_.emplace(gl, scene(), *gpuScene_);
    }
    device_.checkErrors("prepare a frame");
}

void GlRenderer::setCamera(const FrameInput& input) {
    const GladGLContext& gl = device_.gl();
    const glm::mat4 viewProjection(rasterised(input.camera.projection) * input.camera.view);
    const CameraConstants camera{viewProjection, glm::vec4(input.camera.viewer), float(input.settings.footprint),
                                 float(input.camera.targetDistance), glm::vec2(input.camera.jitter)};
    gl.NamedBufferSubData(cameraConstants_.get(), 0, sizeof camera, &camera);
    motion_.update(input.draws);
    if (fetch_) {
        fetch_->update(scene(), input.draws, {viewProjection, camera.viewer});
        fetch_->bind();
    }
    if (environment_)
        environment_->bind();
    if (filteredShadows_)
        filteredShadows_->bind();
    device_.checkErrors("set the camera");
}

double GlRenderer::renderFrame(const FrameInput& input) {
    const GladGLContext& gl = device_.gl();
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = output_.get();
    for (size_t i = 0; i < shadowMaps_.shadows().size(); ++i)
        glFrame.shadowTextures[i] = shadowMaps_.texture(i);
    AgaaGlResolvedTextures resolved = AGAA_GL_RESOLVED_TEXTURES_INIT;
    const size_t count = resolvedValues(input.settings).size();
    for (size_t i = 0; i < count; ++i)
        resolved.textures[i] = resolved_[i].get();
    glFrame.pNext = count == 0 ? nullptr : &resolved;
    if (input.settings.background.a == 0)
        gl.ClearTexImage(output_.get(), 0, GL_RGBA, GL_FLOAT, glm::value_ptr(input.settings.background));
    gl.Finish();
    const auto start = std::chrono::steady_clock::now();
    record(input, "agaaGlRecordFrame",
           [&](const AgaaFrame& frame) { return agaaGlRecordFrame(view_->view, &frame, &glFrame); });
    if (input.settings.hasLayers) {
        if (!layers_)
            layers_.emplace(gl);
        gl.ClipControl(GL_LOWER_LEFT, options_.clipZFromMinusOne ? GL_NEGATIVE_ONE_TO_ONE : GL_ZERO_TO_ONE);
        layers_->draw(layerConstants(input.camera, rasterised(input.camera.projection)), output_, resolved_[count - 2],
                      resolved_[count - 1], outputWidth_, outputHeight_);
    }
    gl.Finish();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    device_.checkErrors("render a frame");
    return elapsed.count();
}

gl::Texture GlRenderer::makeOutput() const {
    gl::Texture texture = createTexture(device_.gl(), GL_TEXTURE_2D);
    device_.gl().TextureStorage2D(texture.get(), 1, GL_RGBA32F, GLsizei(outputWidth_), GLsizei(outputHeight_));
    return texture;
}

Image GlRenderer::read(const gl::Texture& texture) const {
    Image image{outputWidth_, outputHeight_, {}};
    image.rgb.resize(3 * image.pixelCount());
    device_.gl().GetTextureImage(texture.get(), 0, GL_RGB, GL_FLOAT, GLsizei(image.rgb.size() * sizeof(float)),
                                 image.rgb.data());
    return image;
}

void GlRenderer::draw(const AgaaDrawTarget& target, const FrameInput& input) {
    const GladGLContext& gl = device_.gl();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    setTarget(gl, target.width, target.height);
    setDrawState(gl, target.state);
    gl.ClipControl(GL_LOWER_LEFT, options_.clipZFromMinusOne ? GL_NEGATIVE_ONE_TO_ONE : GL_ZERO_TO_ONE);
    gl.CullFace(GL_BACK);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, cameraBinding, cameraConstants_.get());
    motion_.bind();
    if (target.state.vertexPulling)
        strips_->bind();
    else
        gpuScene_->bindGeometry();
    for (const std::span<const AgaaViewport> viewports : viewportGroups(target)) {
        setViewports(gl, viewports);
        drawScene(target, input);
    }
    gl.Disable(GL_SCISSOR_TEST);
}

void GlRenderer::drawScene(const AgaaDrawTarget& target, const FrameInput& input) {
    const GladGLContext& gl = device_.gl();
    uint32_t material = UINT32_MAX;
    for (uint32_t index = 0; index < input.draws.size(); ++index) {
        const Draw& draw = input.draws[index];
        if (!isDrawnIn(target, draw))
            continue;
        const Mesh& mesh = scene().meshes[draw.mesh];
        const Variant variant = variantOf(scene(), draw);
        const PassProgram& program = programs_.program(target.pipelineKey, variant);
        gl.UseProgram(program.program.get());
        setStencilTest(gl, draw.isMasked ? target.state.stencilTestMasked : target.state.stencilTest);
        (variant.isDoubleSided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
        // y points down, so OpenGL sees triangles that are counter-clockwise on the screen as clockwise.
        gl.FrontFace(variant.isMirrored ? GL_CCW : GL_CW);
        if (mesh.material != material) {
            material = mesh.material;
            gpuScene_->bindMaterial(material);
        }
        program.setDraw(gl, drawConstants(scene(), draw, index));
        if (target.constants)
            gl.Uniform4fv(program.constants, GLsizei(target.constantCount), target.constants);
        if (target.state.vertexPulling)
            strips_->draw(mesh);
        else
            gpuScene_->draw(mesh);
    }
}

std::unique_ptr<Renderer> makeGlRenderer(const RendererOptions& options) {
    return std::make_unique<GlRenderer>(options);
}

} // namespace harness
