#include "gl_device.h"

#include <EGL/eglext.h>

#include <cstring>

namespace agaa::conformance {

namespace {

bool hasClientExtension(const char* name) {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return extensions && std::strstr(extensions, name);
}

// Displays that need no window system come first.
std::vector<EGLDisplay> findDisplays() {
    std::vector<EGLDisplay> displays;
    if (hasClientExtension("EGL_MESA_platform_surfaceless"))
        displays.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (queryDevices && hasClientExtension("EGL_EXT_platform_device") && queryDevices(0, nullptr, &count) &&
        count > 0) {
        std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
        queryDevices(count, devices.data(), &count);
        for (EGLint i = 0; i < count; ++i)
            displays.push_back(
                eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)], nullptr));
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

std::string textOf(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

} // namespace

CurrentOpenGl::~CurrentOpenGl() {
    if (context_ != EGL_NO_CONTEXT)
        eglMakeCurrent(display_, draw_, read_, context_);
}

OpenGlApi::OpenGlApi(const std::string& name, const OpenGlVersion& version) {
    for (const EGLDisplay display : findDisplays()) {
        if (display == EGL_NO_DISPLAY || !create(display, version))
            continue;
        if (textOf(GL_RENDERER).find(name) != std::string::npos)
            break;
        destroy();
        context_ = EGL_NO_CONTEXT;
    }
    if (context_ == EGL_NO_CONTEXT)
        throw Skipped{"EGL has no context of OpenGL " + std::to_string(version.major) + '.' +
                      std::to_string(version.minor) + " without a window" +
                      (name.empty() ? std::string(".") : ", whose GL_RENDERER contains " + name + ".")};
    deviceName = textOf(GL_RENDERER);
    driverName = textOf(GL_VERSION);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, this);
}

OpenGlApi::~OpenGlApi() { destroy(); }

// Makes the context current.
bool OpenGlApi::create(EGLDisplay display, const OpenGlVersion& version) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 version.major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 version.minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 version.isCompatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT
                                                         : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    display_ = display;
    context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT)
        return false;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        return true;
    eglDestroyContext(display, context_);
    context_ = EGL_NO_CONTEXT;
    return false;
}

// The display remains: another context of this program may use it.
void OpenGlApi::destroy() const {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void APIENTRY OpenGlApi::onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                                   const void* user) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR || severity == GL_DEBUG_SEVERITY_HIGH)
        const_cast<OpenGlApi*>(static_cast<const OpenGlApi*>(user))->messages_.push_back(text);
}

// Pending errors are removed, because the next function of the SDK that checks for errors would report them again.
std::vector<std::string> OpenGlApi::takeMessages() {
    const bool isEmpty = messages_.empty();
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        if (isEmpty) // the debug output of this driver does not name the errors
            messages_.push_back("glGetError returns " + std::to_string(error) + ".");
    std::vector<std::string> messages;
    messages.swap(messages_);
    return messages;
}

} // namespace agaa::conformance
