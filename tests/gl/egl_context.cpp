#include "egl_context.h"

#include "gl/display.h"

#include <stdexcept>

namespace agaa::test {
namespace {

// One display a process: terminating it would take the other contexts along.
EGLDisplay display() {
    static const EGLDisplay shared = [] {
        const EGLDisplay made = harness::gl::displayWithoutWindow();
        if (made == EGL_NO_DISPLAY)
            throw std::runtime_error("no EGL display without a window");
        return made;
    }();
    return shared;
}

// Messages on performance tell of shader variants that states call for, which is no mistake.
void GLAD_API_PTR collect(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                          const void* user) {
    if (type == GL_DEBUG_TYPE_PERFORMANCE ||
        (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM))
        return;
    auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    messages->emplace_back(text, static_cast<size_t>(length));
}

} // namespace

EglContext::EglContext(const EglContextDesc& desc) : display_(display()), compatibility_(desc.compatibility) {
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
        throw std::runtime_error("EGL without OpenGL");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 desc.major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 desc.minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 desc.compatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT
                                                    : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 desc.debug ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT)
        throw std::runtime_error("no OpenGL context of this version and profile");
    makeCurrent();
    if (gladLoadGLContext(&gl_, eglGetProcAddress) == 0)
        throw std::runtime_error("no OpenGL functions");
    if (desc.debug) {
        gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        gl_.DebugMessageCallback(collect, &messages_);
    }
}

EglContext::~EglContext() {
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void EglContext::makeCurrent() const {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
        throw std::runtime_error("cannot make the OpenGL context current");
}

void (*EglContext::getProcAddr(void*, const char* name))() { return eglGetProcAddress(name); }

std::string EglContext::takeMessages() {
    std::string lines;
    for (const std::string& message : messages_)
        lines += message + '\n';
    messages_.clear();
    for (GLenum error = gl_.GetError(); error != GL_NO_ERROR; error = gl_.GetError())
        lines += "OpenGL error " + std::to_string(error) + '\n';
    return lines;
}

} // namespace agaa::test
