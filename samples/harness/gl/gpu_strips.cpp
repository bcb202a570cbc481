#include "gl/gpu_strips.h"

#include "render/strip_indices.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace harness::gl {

constexpr GLuint firstUnit = 28; // PULLED_VERTICES_AT of shaders/interface.glsl

GpuStrips::GpuStrips(const GladGLContext& gl, const Scene& scene, const GpuScene& gpuScene)
    : gl_(&gl), vertexArray_(createVertexArray(gl)), indices_(createBuffer(gl)) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (std::max(scene.vertices.size() * (sizeof(Vertex) / 4), scene.indices.size()) > size_t(most))
        throw std::runtime_error("The scene has more vertices or indices than the device's texture buffers hold.");
    const std::vector<uint32_t> indices = stripIndices();
    gl.NamedBufferData(indices_.get(), GLsizeiptr(indices.size() * sizeof(uint32_t)), indices.data(), GL_STATIC_DRAW);
    gl.VertexArrayElementBuffer(vertexArray_.get(), indices_.get());
    const GLuint buffers[] = {gpuScene.vertices(), gpuScene.indices()};
    for (size_t i = 0; i < std::size(buffers); ++i) {
        texels_[i] = createTexture(gl, GL_TEXTURE_BUFFER);
        gl.TextureBuffer(texels_[i].get(), GL_R32UI, buffers[i]);
    }
}

void GpuStrips::bind() const {
    gl_->BindVertexArray(vertexArray_.get());
    for (GLuint i = 0; i < std::size(texels_); ++i) {
        gl_->BindTextureUnit(firstUnit + i, texels_[i].get());
        gl_->BindSampler(firstUnit + i, 0);
    }
}

void GpuStrips::draw(const Mesh& mesh) const {
    const uint32_t triangles = mesh.indexCount / 3;
    for (uint32_t first = 0; first < triangles; first += stripsPerDraw)
        gl_->DrawElementsBaseVertex(GL_TRIANGLES, GLsizei(stripIndexCount * std::min(triangles - first, stripsPerDraw)),
                                    GL_UNSIGNED_INT, nullptr, GLint(stripVertices * first));
}

} // namespace harness::gl
