#include "gl/gpu_scene.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

namespace harness::gl {

namespace {

GLint wrapMode(Wrap wrap) {
    switch (wrap) {
    case Wrap::Mirror:
        return GL_MIRRORED_REPEAT;
    case Wrap::Clamp:
        return GL_CLAMP_TO_EDGE;
    case Wrap::Repeat:
        break;
    }
    return GL_REPEAT;
}

GLint minFilter(const TextureFilters& filters) {
    const bool isNearest = filters.minify == Filter::Nearest;
    switch (filters.mips) {
    case MipFilter::None:
        return isNearest ? GL_NEAREST : GL_LINEAR;
    case MipFilter::Nearest:
        return isNearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST;
    case MipFilter::Linear:
        break;
    }
    return isNearest ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR;
}

// llvmpipe walks the whole footprint of the pixel, which takes minutes if a primitive's gradients are steep. lavapipe
// accepts the setting, but filters without it.
bool hasUsableAnisotropy(const GladGLContext& gl) {
    const std::string renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    return (gl.ARB_texture_filter_anisotropic || gl.EXT_texture_filter_anisotropic) &&
           renderer.find("llvmpipe") == std::string::npos;
}

Buffer filledBuffer(const GladGLContext& gl, const void* data, size_t bytes, size_t least) {
    Buffer buffer = createBuffer(gl);
    // A scene may be empty, but a buffer may not.
    gl.NamedBufferData(buffer.get(), GLsizeiptr(std::max(bytes, least)), nullptr, GL_STATIC_DRAW);
    if (bytes)
        gl.NamedBufferSubData(buffer.get(), 0, GLsizeiptr(bytes), data);
    return buffer;
}

} // namespace

GpuScene::GpuScene(const GladGLContext& gl, const Scene& scene) : gl_(&gl) {
    checkMeshes(scene);
    uploadGeometry(scene);
    uploadTextures(scene);
    uploadMaterials(scene);
    if (gl.GetError() != GL_NO_ERROR)
        throw std::runtime_error("The scene \"" + scene.name + "\" could not be uploaded.");
}

void GpuScene::uploadGeometry(const Scene& scene) {
    const GladGLContext& gl = *gl_;
    vertices_ = filledBuffer(gl, scene.vertices.data(), scene.vertices.size() * sizeof(Vertex), sizeof(Vertex));
    indices_ = filledBuffer(gl, scene.indices.data(), scene.indices.size() * sizeof(uint32_t), sizeof(uint32_t));
    vertexArray_ = createVertexArray(gl);
    const GLuint array = vertexArray_.get();
    gl.VertexArrayVertexBuffer(array, 0, vertices_.get(), 0, sizeof(Vertex));
    gl.VertexArrayElementBuffer(array, indices_.get());
    struct Attribute {
        GLint components;
        GLenum type;
        GLboolean normalised;
        size_t offset;
    };
    const Attribute attributes[] = {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position)},
                                    {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, normal)},
                                    {4, GL_FLOAT, GL_FALSE, offsetof(Vertex, tangent)},
                                    {2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv)},
                                    {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, color)}};
    for (GLuint i = 0; i < std::size(attributes); ++i) {
        const Attribute& a = attributes[i];
        gl.EnableVertexArrayAttrib(array, i);
        gl.VertexArrayAttribFormat(array, i, a.components, a.type, a.normalised, GLuint(a.offset));
        gl.VertexArrayAttribBinding(array, i, 0);
    }
}

Texture GpuScene::makeTexture(const std::vector<MipLevel>& levels, bool srgb) const {
    const GladGLContext& gl = *gl_;
    Texture texture = createTexture(gl, GL_TEXTURE_2D);
    gl.TextureStorage2D(texture.get(), GLsizei(levels.size()), srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                        GLsizei(levels[0].width), GLsizei(levels[0].height));
    for (size_t i = 0; i < levels.size(); ++i)
        gl.TextureSubImage2D(texture.get(), GLint(i), 0, 0, GLsizei(levels[i].width), GLsizei(levels[i].height),
                             GL_RGBA, GL_UNSIGNED_BYTE, levels[i].rgba.data());
    return texture;
}

void GpuScene::uploadTextures(const Scene& scene) {
    GLint largest = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    checkTextureSizes(scene, uint32_t(largest));
    const std::vector<MipOptions> options = mipOptions(scene);
    for (size_t i = 0; i < scene.textures.size(); ++i) {
        const harness::Texture& source = scene.textures[i];
        textures_.push_back(makeTexture(makeMipChain(source, options[i]), source.srgb));
    }
    textures_.push_back(makeTexture({{1, 1, {255, 255, 255, 255}}}, false));
}

Sampler makeSampler(const GladGLContext& gl, const Sampling& sampling) {
    Sampler sampler = createSampler(gl);
    gl.SamplerParameteri(sampler.get(), GL_TEXTURE_MIN_FILTER, minFilter(sampling.filters));
    gl.SamplerParameteri(sampler.get(), GL_TEXTURE_MAG_FILTER,
                         sampling.filters.magnify == Filter::Nearest ? GL_NEAREST : GL_LINEAR);
    gl.SamplerParameteri(sampler.get(), GL_TEXTURE_WRAP_S, wrapMode(sampling.wrapU));
    gl.SamplerParameteri(sampler.get(), GL_TEXTURE_WRAP_T, wrapMode(sampling.wrapV));
    if (sampling.filters == TextureFilters{} && hasUsableAnisotropy(gl)) {
        GLfloat most = 1;
        gl.GetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
        gl.SamplerParameterf(sampler.get(), GL_TEXTURE_MAX_ANISOTROPY, std::min(8.0f, most));
    }
    return sampler;
}

GLuint GpuScene::sampler(const Sampling& sampling) {
    Sampler& sampler = samplers_[sampling];
    if (!sampler)
        sampler = makeSampler(*gl_, sampling);
    return sampler.get();
}

void GpuScene::uploadMaterials(const Scene& scene) {
    std::vector<Material> materials = scene.materials;
    materials.emplace_back();
    GLint alignment = 1;
    gl_->GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    stride_ = (GLsizeiptr(sizeof(MaterialConstants)) + alignment - 1) / alignment * alignment;
    std::vector<std::byte> constants(size_t(stride_) * materials.size());
    for (size_t m = 0; m < materials.size(); ++m) {
        MaterialBindings bindings;
        const auto maps = materialTextures(scene, materials[m]);
        for (size_t i = 0; i < maps.size(); ++i) {
            const bool has = maps[i] >= 0;
            const size_t texture = has ? size_t(maps[i]) : scene.textures.size();
            bindings.textures[i] = textures_[texture].get();
            bindings.samplers[i] = sampler(has ? scene.textures[texture].sampling() : Sampling{});
        }
        materials_.push_back(bindings);
        const MaterialConstants values = materialConstants(materials[m]);
        std::memcpy(&constants[size_t(stride_) * m], &values, sizeof values);
    }
    constants_ = filledBuffer(*gl_, constants.data(), constants.size(), 1);
}

void GpuScene::bindGeometry() const { gl_->BindVertexArray(vertexArray_.get()); }

void GpuScene::bindMaterial(uint32_t material) const {
    const size_t index = std::min(size_t(material), materials_.size() - 1);
    for (GLuint i = 0; i < materialTextureCount; ++i) {
        gl_->BindTextureUnit(i, materials_[index].textures[i]);
        gl_->BindSampler(i, materials_[index].samplers[i]);
    }
    gl_->BindBufferRange(GL_UNIFORM_BUFFER, materialConstantsBinding, constants_.get(), GLintptr(index) * stride_,
                         sizeof(MaterialConstants));
}

void GpuScene::draw(const Mesh& mesh) const {
    gl_->DrawElementsBaseVertex(GL_TRIANGLES, GLsizei(mesh.indexCount), GL_UNSIGNED_INT,
                                reinterpret_cast<const void*>(size_t(mesh.firstIndex) * sizeof(uint32_t)),
                                GLint(mesh.firstVertex));
}

} // namespace harness::gl
