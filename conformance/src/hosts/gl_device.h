// An OpenGL context of the suite, without a window, with debug output.
#pragma once

#include "device.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/glcorearb.h>

namespace agaa::conformance {

// Restores the current context of this thread at the end of the scope.
class CurrentOpenGl {
public:
    CurrentOpenGl() = default;
    ~CurrentOpenGl();
    CurrentOpenGl(const CurrentOpenGl&) = delete;
    CurrentOpenGl& operator=(const CurrentOpenGl&) = delete;

private:
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLContext context_ = eglGetCurrentContext();
    EGLSurface draw_ = eglGetCurrentSurface(EGL_DRAW), read_ = eglGetCurrentSurface(EGL_READ);
};

class OpenGlApi {
public:
    // Creates a context on the first display whose GL_RENDERER contains the name, and makes it current in this thread.
    OpenGlApi(const std::string& name, const OpenGlVersion& version);
    ~OpenGlApi(); // restores the previous current context
    OpenGlApi(const OpenGlApi&) = delete;
    OpenGlApi& operator=(const OpenGlApi&) = delete;

    // Returns errors, undefined behaviour and messages of high severity.
    std::vector<std::string> takeMessages();

    std::string deviceName, driverName;

private:
    bool create(EGLDisplay display, const OpenGlVersion& version);
    void destroy() const;
    static void APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                   const GLchar* text, const void* user);

    const CurrentOpenGl earlier_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::vector<std::string> messages_;
};

} // namespace agaa::conformance
