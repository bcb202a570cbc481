// An OpenGL context of the suite, without a window, with debug output.
#pragma once

#include "device.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/glcorearb.h>

namespace agaa::conformance {

class OpenGlApi {
public:
    // Core 4.5, current in this thread. Of the first display whose GL_RENDERER contains the name.
    explicit OpenGlApi(const std::string& name);
    ~OpenGlApi(); // what was current before is current again
    OpenGlApi(const OpenGlApi&) = delete;
    OpenGlApi& operator=(const OpenGlApi&) = delete;

    // Errors, undefined behaviour and messages of high severity.
    std::vector<std::string> takeMessages();

    std::string deviceName, driverName;

private:
    bool create(EGLDisplay display);
    void destroy() const;
    static void APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
                                   const void* user);

    EGLDisplay display_ = EGL_NO_DISPLAY, earlierDisplay_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT, earlierContext_ = EGL_NO_CONTEXT;
    EGLSurface earlierDraw_ = EGL_NO_SURFACE, earlierRead_ = EGL_NO_SURFACE;
    std::vector<std::string> messages_;
};

} // namespace agaa::conformance
