#include "gl/device.h"

#include "gl/display.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace harness::gl {

namespace {

// Collects messages of medium and high severity. Lower ones are remarks. Messages on performance are skipped, too: Mesa
// reports every shader variant that a state needs.
void GLAD_API_PTR onMessage(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
                            const void* user) {
    if (type == GL_DEBUG_TYPE_PERFORMANCE)
        return;
    if (severity != GL_DEBUG_SEVERITY_MEDIUM && severity != GL_DEBUG_SEVERITY_HIGH)
        return;
    ApiMessage message;
    message.severity = type == GL_DEBUG_TYPE_ERROR ? "error" : "warning";
    message.id = std::to_string(id);
    message.text = std::string(text, length >= 0 ? size_t(length) : std::char_traits<char>::length(text));
    static_cast<MessageCollector*>(const_cast<void*>(user))->add(std::move(message));
}

std::string errorName(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "error " + std::to_string(error);
    }
}

} // namespace

Device::Device(const RendererOptions& options) {
    try {
        createContext(options);
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() { destroy(); }

void Device::createContext(const RendererOptions& options) {
    const EGLDisplay display = displayWithoutWindow();
    if (display == EGL_NO_DISPLAY)
        throw std::runtime_error("EGL has no display without a window (EGL_EXT_platform_device, "
                                 "EGL_MESA_platform_surfaceless).");
    display_ = display;
    if (!eglBindAPI(EGL_OPENGL_API))
        throw std::runtime_error("EGL does not know OpenGL.");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 options.compatibilityProfile ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT
                                                              : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 options.validation ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT)
        throw std::runtime_error("EGL cannot create an OpenGL 4.5 context.");
    makeCurrent();
    if (!gladLoadGLContext(&gl_, eglGetProcAddress))
        throw std::runtime_error("The functions of OpenGL could not be loaded.");
    if (!gl_.VERSION_4_5)
        throw std::runtime_error("The installed OpenGL is older than 4.5.");
    if (!options.validation)
        return;
    gl_.Enable(GL_DEBUG_OUTPUT);
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_.DebugMessageCallback(onMessage, &messages_);
}

void Device::makeCurrent() const {
    if (eglGetCurrentContext() != context_ && !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        throw std::runtime_error("The OpenGL context could not be made current.");
}

void Device::checkErrors(const char* what) const {
    const GLenum error = gl_.GetError();
    if (error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL could not " + std::string(what) + ": " + errorName(error) + ".");
}

void Device::checkTextureSize(uint32_t width, uint32_t height) const {
    GLint largest = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width == 0 || height == 0 || std::max(width, height) > uint32_t(largest))
        throw std::runtime_error("OpenGL has no textures of " + std::to_string(width) + "x" + std::to_string(height) +
                                 " pixels here.");
}

// The display belongs to the process. Other devices may use it, so it is not terminated.
void Device::destroy() {
    if (context_) {
        if (eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    messages_.handOver();
}

AgaaGlFunction AGAA_CALL Device::getProcAddr(void*, const char* name) {
    return reinterpret_cast<AgaaGlFunction>(eglGetProcAddress(name));
}

} // namespace harness::gl
