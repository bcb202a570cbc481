#include "gl/gpu_fetch.h"

#include <glm/gtc/type_ptr.hpp>

namespace harness::gl {

// Of shaders/interface.glsl.
constexpr GLuint cameraPlace = 6, firstStorage = 4, firstUnit = 20;

GpuFetch::GpuFetch(const GladGLContext& gl, const Scene& scene) : gl_(&gl), glsl_(fetchGlsl(true)) {
    const FetchScene fetch = makeFetchScene(scene);
    colors_ = makeArray(fetch.colors, true);
    values_ = makeArray(fetch.values, false);
    sampler_ = makeSampler(gl, Wrap::Repeat, Wrap::Repeat);
    camera_ = createBuffer(gl);
    draws_ = createBuffer(gl);
    materials_ = createBuffer(gl);
    gl.NamedBufferData(camera_.get(), sizeof(glm::mat4), nullptr, GL_DYNAMIC_DRAW);
    gl.NamedBufferData(draws_.get(), GLsizeiptr(fetch.maxDraws * sizeof(FetchDraw)), nullptr, GL_DYNAMIC_DRAW);
    gl.NamedBufferData(materials_.get(), GLsizeiptr(fetch.materials.size() * sizeof(FetchMaterial)),
                       fetch.materials.data(), GL_STATIC_DRAW);
    function_.glsl = glsl_.c_str();
    function_.maxDraws = fetch.maxDraws;
    function_.maxPrimitives = fetch.maxPrimitives;
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

void GpuFetch::update(const Scene& scene, const std::vector<Draw>& draws, const glm::mat4& viewProjection) {
    const std::vector<FetchDraw> rows = fetchDraws(scene, draws);
    gl_->NamedBufferSubData(draws_.get(), 0, GLsizeiptr(rows.size() * sizeof(FetchDraw)), rows.data());
    gl_->NamedBufferSubData(camera_.get(), 0, sizeof viewProjection, glm::value_ptr(viewProjection));
}

void GpuFetch::bind(const GpuScene& gpuScene) const {
    gl_->BindBufferBase(GL_UNIFORM_BUFFER, cameraPlace, camera_.get());
    const GLuint buffers[] = {draws_.get(), materials_.get(), gpuScene.vertices(), gpuScene.indices()};
    for (GLuint i = 0; i < 4; ++i)
        gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, firstStorage + i, buffers[i]);
    const GLuint textures[] = {colors_.get(), values_.get()};
    for (GLuint i = 0; i < 2; ++i) {
        gl_->BindTextureUnit(firstUnit + i, textures[i]);
        gl_->BindSampler(firstUnit + i, sampler_.get());
    }
}

} // namespace harness::gl
