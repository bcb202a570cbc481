#include "gl/shadow_maps.h"

#include "embedded.h"
#include "gl/draw_state.h"
#include "render/lights.h"

#include <glm/gtc/type_ptr.hpp>

namespace harness::gl {

ShadowMaps::ShadowMaps(const GladGLContext& gl, uint32_t size)
    : gl_(&gl), size_(size), opaque_(gl, vertexText(450, embedded::shadow_vert), "", "shadow.vert"),
      masked_(gl, vertexText(450, embedded::shadow_vert), vertexText(450, embedded::shadow_frag), "shadow.frag"),
      framebuffer_(createFramebuffer(gl)) {
    gl.NamedFramebufferDrawBuffer(framebuffer_.get(), GL_NONE);
    gl.NamedFramebufferReadBuffer(framebuffer_.get(), GL_NONE);
}

void ShadowMaps::update(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                        const CameraMatrices& camera, uint64_t placement) {
    std::vector<double> key = shadowKey(settings.lights, settings.worldOffset, camera, placement);
    if (key == key_)
        return;
    key_.clear();
    shadows_.clear();
    maps_.clear();
    for (const size_t i : shadowedLights(settings.lights)) {
        const ShadowFit fit = fitShadow(settings.lights[i], scene, camera, settings.worldOffset, size_);
        renderMap(gpuScene, scene, settings, camera.eye, fit.layers);
        shadows_.push_back(toAgaaShadow(fit));
    }
    key_ = std::move(key);
    ++version_;
}

std::vector<float> ShadowMaps::readDepths(size_t shadow) const {
    std::vector<float> depths(size_t(size_) * size_ * shadows_[shadow].layerCount);
    gl_->GetTextureImage(maps_[shadow].get(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(depths.size() * sizeof(float)),
                         depths.data());
    return depths;
}

void ShadowMaps::renderMap(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                           const glm::dvec3& eye, const std::vector<glm::dmat4>& layers) {
    const GladGLContext& gl = *gl_;
    maps_.push_back(createTexture(gl, GL_TEXTURE_2D_ARRAY));
    const GLuint map = maps_.back().get();
    gl.TextureStorage3D(map, 1, GL_DEPTH_COMPONENT32F, GLsizei(size_), GLsizei(size_), GLsizei(layers.size()));
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.get());
    setTarget(gl, size_, size_);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_SAMPLE_SHADING);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(1.5f, 0);
    for (size_t layer = 0; layer < layers.size(); ++layer) {
        gl.NamedFramebufferTextureLayer(framebuffer_.get(), GL_DEPTH_ATTACHMENT, map, 0, GLint(layer));
        const GLfloat far = 1;
        gl.ClearNamedFramebufferfv(framebuffer_.get(), GL_DEPTH, 0, &far);
        renderLayer(gpuScene, scene, settings, eye, layers[layer]);
    }
    gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void ShadowMaps::renderLayer(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                             const glm::dvec3& eye, const glm::dmat4& toClip) const {
    gpuScene.bindGeometry();
    uint32_t material = UINT32_MAX;
    for (const Draw& draw : makeDrawList(scene, settings.worldOffset, eye, toClip, {})) {
        const Program& program = draw.isMasked ? masked_ : opaque_;
        gl_->UseProgram(program.get());
        const Mesh& mesh = scene.meshes[draw.mesh];
        if (draw.isMasked && mesh.material != material) {
            material = mesh.material;
            gpuScene.bindMaterial(material);
        }
        const glm::mat4 matrix(toClip * draw.toShading);
        gl_->ProgramUniformMatrix4fv(program.get(), program.uniform("draw.toClip"), 1, GL_FALSE,
                                     glm::value_ptr(matrix));
        gpuScene.draw(mesh);
    }
}

} // namespace harness::gl
