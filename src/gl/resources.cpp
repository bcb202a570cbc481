#include "gl/resources.h"

#include "core/base/error.h"
#include "gl/errors.h"
#include "gl/formats.h"

namespace agaa::gl {

// Returns the texel format through which host shaders without blocks access a buffer: storage buffers as images, frame
// constants as a texture. Returns GL_NONE for buffers that no host draw accesses as texels.
static GLenum texelsOfDraws(const Context& context, const Plan& plan, ResourceId id) {
    for (const Pass& pass : plan.passes)
        for (const Binding& binding : pass.bindings) {
            if (pass.kind() != PassKind::HostDraw || binding.resource != id)
                continue;
            if (binding.type == BindingType::StorageBuffer && context.dialect.storageImages)
                return GL_R32UI;
            if (binding.type == BindingType::UniformBuffer && context.dialect.constants == AGAA_GL_CONSTANTS_TEXELS)
                return GL_RGBA32UI;
        }
    return GL_NONE;
}

ViewResources::ViewResources(const Context& context, const Plan& plan) : context_(context) {
    context.clearHostErrors("creating surfaces");
    try {
        resources_.resize(plan.resources.size());
        for (ResourceId id = 0; id < plan.resources.size(); ++id) {
            const Resource& resource = plan.resources[id];
            if (resource.isImported())
                continue;
            if (resource.kind == ResourceKind::Image)
                createTexture(resource, resources_[id]);
            else if (id == plan.breadcrumbs)
                createMappedBuffer(resource, resources_[id]);
            else
                createBuffers(resource, texelsOfDraws(context, plan, id), resources_[id]);
            context.checkErrors(("allocating " + resource.name).c_str());
        }
    } catch (...) {
        destroy();
        throw;
    }
}

ViewResources::~ViewResources() { destroy(); }

void ViewResources::destroy() {
    for (GpuResource& resource : resources_) {
        context_.gl.DeleteTextures(1, &resource.texture);
        context_.gl.DeleteTextures(GLsizei(resource.bufferImages.size()), resource.bufferImages.data());
        context_.gl.DeleteBuffers(GLsizei(resource.buffers.size()), resource.buffers.data());
    }
    resources_.clear();
}

void ViewResources::createTexture(const Resource& resource, GpuResource& out) {
    const GladGLContext& gl = context_.gl;
    const GLenum texels = internalFormat(resource.format);
    const auto width = GLsizei(resource.width), height = GLsizei(resource.height);
    if (resource.samples > 1) {
        gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &out.texture);
        requireObject(gl, out.texture, "glCreateTextures");
        gl.TextureStorage2DMultisample(out.texture, GLsizei(resource.samples), texels, width, height, GL_TRUE);
        GLint samples = 0;
        gl.GetTextureLevelParameteriv(out.texture, 0, GL_TEXTURE_SAMPLES, &samples);
        if (samples != 0 && uint32_t(samples) != resource.samples)
            fail(AGAA_ERROR_UNSUPPORTED, format("%s was to have %u samples; the driver gives it %d.",
                                                resource.name.c_str(), resource.samples, samples));
    } else {
        gl.CreateTextures(resource.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &out.texture);
        requireObject(gl, out.texture, "glCreateTextures");
        if (resource.layers > 1)
            gl.TextureStorage3D(out.texture, 1, texels, width, height, GLsizei(resource.layers));
        else
            gl.TextureStorage2D(out.texture, 1, texels, width, height);
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl.TextureParameteri(out.texture, filter, GL_NEAREST);
    }
    context_.label(GL_TEXTURE, out.texture, "agaa " + resource.name);
    if (resource.isPerPixel())
        payloadBytes_ += uint64_t(resource.width) * resource.height * resource.samples * resource.layers *
                         bytesPerTexel(resource.format);
}

static void clear(const GladGLContext& gl, GLuint buffer) {
    gl.ClearNamedBufferData(buffer, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void ViewResources::clearPersistent(const Plan& plan) {
    for (ResourceId id = 0; id < plan.resources.size(); ++id)
        if (plan.resources[id].isPersistent)
            for (const GLuint buffer : resources_[id].buffers)
                clear(context_.gl, buffer);
}

void ViewResources::createBuffers(const Resource& resource, GLenum texels, GpuResource& out) {
    const GladGLContext& gl = context_.gl;
    for (uint32_t copy = 0; copy < resource.copies; ++copy) {
        GLuint& buffer = out.buffers.emplace_back(0u);
        gl.CreateBuffers(1, &buffer);
        requireObject(gl, buffer, "glCreateBuffers");
        const GLenum usage = resource.kind == ResourceKind::UploadBuffer     ? GL_STREAM_DRAW
                             : resource.kind == ResourceKind::ReadbackBuffer ? GL_STREAM_READ
                                                                             : GL_DYNAMIC_COPY;
        gl.NamedBufferData(buffer, GLsizeiptr(resource.bytes), nullptr, usage);
        context_.label(GL_BUFFER, buffer, "agaa " + resource.name);
        if (resource.isPersistent)
            clear(gl, buffer);
        if (resource.isPerPixel())
            payloadBytes_ += resource.bytes;
        if (texels == GL_NONE)
            continue;
        GLuint& image = out.bufferImages.emplace_back(0u);
        gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &image);
        requireObject(gl, image, "glCreateTextures");
        gl.TextureBuffer(image, texels, buffer);
        context_.label(GL_TEXTURE, image, "agaa " + resource.name);
    }
}

void ViewResources::createMappedBuffer(const Resource& resource, GpuResource& out) {
    const GladGLContext& gl = context_.gl;
    require(gl.NamedBufferStorage && (gl.VERSION_4_4 || gl.ARB_buffer_storage), AGAA_ERROR_UNSUPPORTED,
            "AGAA_CONFIG_BREADCRUMBS needs OpenGL 4.4 or GL_ARB_buffer_storage.");
    constexpr GLbitfield access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    GLuint& buffer = out.buffers.emplace_back(0u);
    gl.CreateBuffers(1, &buffer);
    requireObject(gl, buffer, "glCreateBuffers");
    const std::vector<std::byte> zeros(resource.bytes);
    gl.NamedBufferStorage(buffer, GLsizeiptr(resource.bytes), zeros.data(), access);
    context_.label(GL_BUFFER, buffer, "agaa " + resource.name);
    context_.checkErrors(("allocating " + resource.name).c_str());
    out.mapped = static_cast<const std::byte*>(gl.MapNamedBufferRange(buffer, 0, GLsizeiptr(resource.bytes), access));
    require(out.mapped, AGAA_ERROR_DEVICE, "glMapNamedBufferRange failed.");
}

GLuint ViewResources::buffer(ResourceId id, uint32_t slot) const { return copyOfSlot(resources_[id].buffers, slot); }

GLuint ViewResources::bufferImage(ResourceId id, uint32_t slot) const {
    return copyOfSlot(resources_[id].bufferImages, slot);
}

} // namespace agaa::gl
