#include "gl/gpu_fetch.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace harness::gl {

// Bindings of shaders/interface.glsl.
constexpr GLuint fetchCameraBinding = 6, firstUnit = 20;

static bool isTexels(GLuint i) { return i >= 2 && i <= 5; }

GpuFetch::GpuFetch(const GladGLContext& gl, const Scene& scene, const GpuScene& gpuScene) : gl_(&gl) {
    const FetchScene fetch = makeFetchScene(scene);
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    const size_t counts[] = {sizeof(FetchVertex) / 16 * fetch.vertices.size(), scene.indices.size(),
                             sizeof(FetchDraw) / 16 * fetch.maxDraws,
                             sizeof(FetchMaterial) / 16 * fetch.materials.size()};
    if (*std::max_element(std::begin(counts), std::end(counts)) > size_t(most))
        throw std::runtime_error("The scene has more vertices, indices, draws or materials than the device's texture "
                                 "buffers hold.");
    glsl_ = fetchGlsl(fetch, true);
    sampler_ = makeSampler(gl, {});
    camera_ = createBuffer(gl);
    draws_ = createBuffer(gl);
    materials_ = createBuffer(gl);
    vertices_ = createBuffer(gl);
    gl.NamedBufferData(camera_.get(), sizeof(FetchCamera), nullptr, GL_DYNAMIC_DRAW);
    gl.NamedBufferData(draws_.get(), GLsizeiptr(fetch.maxDraws * sizeof(FetchDraw)), nullptr, GL_DYNAMIC_DRAW);
    gl.NamedBufferData(materials_.get(), GLsizeiptr(fetch.materials.size() * sizeof(FetchMaterial)),
                       fetch.materials.data(), GL_STATIC_DRAW);
    gl.NamedBufferData(vertices_.get(), GLsizeiptr(fetch.vertices.size() * sizeof(FetchVertex)), fetch.vertices.data(),
                       GL_STATIC_DRAW);
    textures_[0] = makeArray(fetch.colors.large, true);
    textures_[1] = makeArray(fetch.values.large, false);
    textures_[2] = texels(draws_.get(), GL_RGBA32UI);
    textures_[3] = texels(materials_.get(), GL_RGBA32UI);
    textures_[4] = texels(vertices_.get(), GL_RGBA32UI);
    textures_[5] = texels(gpuScene.indices(), GL_R32UI);
    textures_[6] = makeArray(fetch.colors.small, true);
    textures_[7] = makeArray(fetch.values.small, false);
    function_.glsl = glsl_.c_str();
    function_.maxDraws = fetch.maxDraws;
    function_.maxPrimitives = fetch.maxPrimitives;
    function_.maxTriangles = fetch.maxTriangles;
}

Texture GpuFetch::makeArray(const TextureLayers& layers, bool srgb) const {
    const GladGLContext& gl = *gl_;
    Texture texture = createTexture(gl, GL_TEXTURE_2D_ARRAY);
    const std::vector<MipLevel>& first = layers[0];
    gl.TextureStorage3D(texture.get(), GLsizei(first.size()), srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                        GLsizei(first[0].width), GLsizei(first[0].height), GLsizei(layers.size()));
    for (size_t layer = 0; layer < layers.size(); ++layer)
        for (size_t i = 0; i < layers[layer].size(); ++i) {
            const MipLevel& level = layers[layer][i];
            gl.TextureSubImage3D(texture.get(), GLint(i), 0, 0, GLint(layer), GLsizei(level.width),
                                 GLsizei(level.height), 1, GL_RGBA, GL_UNSIGNED_BYTE, level.rgba.data());
        }
    return texture;
}

Texture GpuFetch::texels(GLuint buffer, GLenum format) const {
    Texture texture = createTexture(*gl_, GL_TEXTURE_BUFFER);
    gl_->TextureBuffer(texture.get(), format, buffer);
    return texture;
}

void GpuFetch::update(const Scene& scene, const std::vector<Draw>& draws, const FetchCamera& camera) {
    const std::vector<FetchDraw> rows = fetchDraws(scene, draws);
    gl_->NamedBufferSubData(draws_.get(), 0, GLsizeiptr(rows.size() * sizeof(FetchDraw)), rows.data());
    gl_->NamedBufferSubData(camera_.get(), 0, sizeof camera, &camera);
}

void GpuFetch::bind() const {
    gl_->BindBufferBase(GL_UNIFORM_BUFFER, fetchCameraBinding, camera_.get());
    for (GLuint i = 0; i < std::size(textures_); ++i) {
        gl_->BindTextureUnit(firstUnit + i, textures_[i].get());
        gl_->BindSampler(firstUnit + i, isTexels(i) ? 0 : sampler_.get());
    }
}

} // namespace harness::gl
