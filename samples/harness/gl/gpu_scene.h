// A scene on the device: a vertex array, its textures, and each material's constants.
#pragma once

#include "gl/objects.h"
#include "render/host_material.h"
#include "render/mip_chain.h"

#include <map>

namespace harness::gl {

// Besides the material's bindings of 0 to 4.
constexpr GLuint cameraBinding = 1; // uniform buffer

// As all of the engine's textures are filtered.
Sampler makeSampler(const GladGLContext& gl, Wrap u, Wrap v);

class GpuScene {
public:
    GpuScene(const GladGLContext& gl, const Scene& scene);

    void bindGeometry() const;
    // Textures 0 to 3 with their samplers, and the uniform buffer 4. Meshes without a valid material get the
    // default one.
    void bindMaterial(uint32_t material) const;
    void draw(const Mesh& mesh) const;
    GLuint indices() const { return indices_.get(); }
    GLuint vertices() const { return vertices_.get(); }

private:
    void uploadGeometry(const Scene& scene);
    void uploadTextures(const Scene& scene);
    void uploadMaterials(const Scene& scene);
    Texture makeTexture(const std::vector<MipLevel>& levels, bool srgb) const;
    GLuint sampler(Wrap u, Wrap v);

    struct MaterialBindings {
        std::array<GLuint, materialTextureCount> textures{};
        std::array<GLuint, materialTextureCount> samplers{};
    };

    const GladGLContext* gl_;
    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer constants_;
    GLsizeiptr stride_ = 0; // of constants_
    std::vector<Texture> textures_; // as Scene::textures, then a white one
    std::map<std::pair<Wrap, Wrap>, Sampler> samplers_;
    std::vector<MaterialBindings> materials_; // as Scene::materials, then the default one
};

} // namespace harness::gl
