/* SPDX-License-Identifier: MIT */
#include "egl_window.h"

#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>

vtkStandardNewMacro(EglWindow);

EglWindow::EglWindow() {
    constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     4,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     5,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_DEBUG,
                                     EGL_TRUE,
                                     EGL_NONE};
    m_display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(m_display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        throw std::runtime_error("EGL offers no OpenGL without a window.");
    m_context = eglCreateContext(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (m_context == EGL_NO_CONTEXT || !eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
        throw std::runtime_error("EGL has no context of OpenGL 4.5.");
    SetOwnContext(1);
    SetSupportsOpenGL(1);
    SetFrameBlitModeToNoBlit(); // there is no framebuffer 0
    SetMultiSamples(0);
}

EglWindow::~EglWindow() {
    Finalize();
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

void EglWindow::MakeCurrent() { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context); }

bool EglWindow::IsCurrent() { return eglGetCurrentContext() == m_context; }

/* Debian's GLEW loads all functions and then fails because there is no GLX display. VTK would give up. */
void EglWindow::OpenGLInitContext() {
    constexpr GLenum noGlxDisplay = 4; // GLEW_ERROR_NO_GLX_DISPLAY
    if (!Initialized) {
        glewExperimental = GL_TRUE; // load the functions of extensions, too
        const GLenum result = glewInit();
        if (result != GLEW_OK && result != noGlxDisplay)
            throw std::runtime_error("GLEW loads no OpenGL functions.");
        Initialized = GlewInitValid = true;
        MaximumHardwareLineWidth = 1.0f;
    }
    Superclass::OpenGLInitContext();
}
