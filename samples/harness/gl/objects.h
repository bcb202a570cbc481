// OpenGL objects that delete themselves. Their context must be current at their destruction.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace harness::gl {

template <auto Delete> class Object {
public:
    Object() = default;
    Object(const GladGLContext& gl, GLuint name) : gl_(&gl), name_(name) {}
    ~Object() { reset(); }
    Object(Object&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        if (this != &other) {
            reset();
            gl_ = other.gl_;
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }

    GLuint get() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    void reset() {
        if (name_)
            (gl_->*Delete)(1, &name_);
        name_ = 0;
    }

    const GladGLContext* gl_ = nullptr;
    GLuint name_ = 0;
};

using Texture = Object<&GladGLContext::DeleteTextures>;
using Buffer = Object<&GladGLContext::DeleteBuffers>;
using Sampler = Object<&GladGLContext::DeleteSamplers>;
using Framebuffer = Object<&GladGLContext::DeleteFramebuffers>;
using VertexArray = Object<&GladGLContext::DeleteVertexArrays>;

template <class T, auto Create> T create(const GladGLContext& gl) {
    GLuint name = 0;
    (gl.*Create)(1, &name);
    return {gl, name};
}
inline Texture createTexture(const GladGLContext& gl, GLenum target) {
    GLuint name = 0;
    gl.CreateTextures(target, 1, &name);
    return {gl, name};
}
inline Buffer createBuffer(const GladGLContext& gl) { return create<Buffer, &GladGLContext::CreateBuffers>(gl); }
inline Sampler createSampler(const GladGLContext& gl) { return create<Sampler, &GladGLContext::CreateSamplers>(gl); }
inline Framebuffer createFramebuffer(const GladGLContext& gl) {
    return create<Framebuffer, &GladGLContext::CreateFramebuffers>(gl);
}
inline VertexArray createVertexArray(const GladGLContext& gl) {
    return create<VertexArray, &GladGLContext::CreateVertexArrays>(gl);
}

} // namespace harness::gl
