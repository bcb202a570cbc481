// A scene on the device: a vertex array, textures, and the constants of each material.
#pragma once

#include "gl/objects.h"
#include "render/host_material.h"
#include "render/mip_chain.h"

#include <map>

namespace harness::gl {

// Bindings in addition to the material's bindings 0 to 4.
constexpr GLuint cameraBinding = 1; // uniform buffer

// Filters are anisotropic unless a texture sets its own.
Sampler makeSampler(const GladGLContext& gl, const Sampling& sampling);

class GpuScene {
public:
    GpuScene(const GladGLContext& gl, const Scene& scene);

    void bindGeometry() const;
    // Binds textures 0 to 3 with their samplers, and the uniform buffer 4. Meshes without a valid material use the
    // default material.
    void bindMaterial(uint32_t material) const;
    void draw(const Mesh& mesh) const;
    GLuint indices() const { return indices_.get(); }
    GLuint vertices() const { return vertices_.get(); }

private:
    void uploadGeometry(const Scene& scene);
    void uploadTextures(const Scene& scene);
    void uploadMaterials(const Scene& scene);
    Texture makeTexture(const std::vector<MipLevel>& levels, bool srgb) const;
    GLuint sampler(const Sampling& sampling);

    struct MaterialBindings {
        std::array<GLuint, materialTextureCount> textures{};
        std::array<GLuint, materialTextureCount> samplers{};
    };

    const GladGLContext* gl_;
    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer constants_;
    GLsizeiptr stride_ = 0;         // bytes per material in constants_
    std::vector<Texture> textures_; // Scene::textures, then a white texture
    std::map<Sampling, Sampler> samplers_;
    std::vector<MaterialBindings> materials_; // Scene::materials, then the default material
};

} // namespace harness::gl
