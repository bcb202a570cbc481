/* The part of EGL that the samples and the conformance suite call, by WGL, so that their hosts are the same on Windows.
 * Each context has a window that is never shown.
 * SPDX-License-Identifier: MIT
 */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdint.h>
#include <stdlib.h>
#include <windows.h>

#include <GL/gl.h>
#include <GL/wglext.h>

typedef __eglMustCastToProperFunctionPointerType Function;

struct Context {
    HWND window;
    HDC device;
    HGLRC context;
};

/* The only display. */
static int displayObject;
static EGLDisplay const onlyDisplay = &displayObject;

static __thread struct Context* current;

EGLDisplay EGLAPIENTRY eglGetDisplay(EGLNativeDisplayType id) {
    (void)id;
    return onlyDisplay;
}

EGLDisplay EGLAPIENTRY eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* attributes) {
    (void)platform, (void)native, (void)attributes;
    return onlyDisplay;
}

EGLBoolean EGLAPIENTRY eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    if (major)
        *major = 1;
    if (minor)
        *minor = 5;
    return display == onlyDisplay;
}

EGLBoolean EGLAPIENTRY eglBindAPI(EGLenum api) { return api == EGL_OPENGL_API; }

const char* EGLAPIENTRY eglQueryString(EGLDisplay display, EGLint name) {
    (void)display, (void)name;
    return "";
}

static EGLBoolean createWindow(struct Context* context) {
    WNDCLASSA type = {.style = CS_OWNDC, .lpfnWndProc = DefWindowProcA, .lpszClassName = "agaa"};
    const PIXELFORMATDESCRIPTOR format = {.nSize = sizeof format,
                                          .nVersion = 1,
                                          .dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL,
                                          .iPixelType = PFD_TYPE_RGBA,
                                          .cColorBits = 24};
    type.hInstance = GetModuleHandleA(NULL);
    RegisterClassA(&type); /* fails if it is registered already */
    context->window =
        CreateWindowA(type.lpszClassName, "", WS_OVERLAPPED, 0, 0, 1, 1, NULL, NULL, type.hInstance, NULL);
    context->device = context->window ? GetDC(context->window) : NULL;
    return context->device && SetPixelFormat(context->device, ChoosePixelFormat(context->device, &format), &format);
}

/* Returns the value of an attribute, or `missing`. The last one counts if it is there several times. */
static int valueOf(const EGLint* attributes, EGLint name, int missing) {
    for (; attributes && attributes[0] != EGL_NONE; attributes += 2)
        if (attributes[0] == name)
            missing = attributes[1];
    return missing;
}

static HGLRC createWithAttributes(const struct Context* context, const EGLint* attributes) {
    const int wanted[] = {WGL_CONTEXT_MAJOR_VERSION_ARB,
                          valueOf(attributes, EGL_CONTEXT_MAJOR_VERSION, 1),
                          WGL_CONTEXT_MINOR_VERSION_ARB,
                          valueOf(attributes, EGL_CONTEXT_MINOR_VERSION, 0),
                          WGL_CONTEXT_FLAGS_ARB,
                          valueOf(attributes, EGL_CONTEXT_OPENGL_DEBUG, 0) ? WGL_CONTEXT_DEBUG_BIT_ARB : 0,
                          WGL_CONTEXT_PROFILE_MASK_ARB, /* its bits are those of EGL */
                          valueOf(attributes, EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT),
                          0};
    const HGLRC old = wglGetCurrentContext(), first = wglCreateContext(context->device);
    const HDC oldDevice = wglGetCurrentDC();
    HGLRC created = NULL;
    /* WGL finds functions only while a context is current. */
    if (first && wglMakeCurrent(context->device, first)) {
        const PFNWGLCREATECONTEXTATTRIBSARBPROC create =
            (PFNWGLCREATECONTEXTATTRIBSARBPROC)(Function)wglGetProcAddress("wglCreateContextAttribsARB");
        if (create)
            created = create(context->device, NULL, wanted);
        wglMakeCurrent(oldDevice, old);
    }
    if (first)
        wglDeleteContext(first);
    return created;
}

static void destroy(struct Context* context) {
    if (context->context)
        wglDeleteContext(context->context);
    if (context->device)
        ReleaseDC(context->window, context->device);
    if (context->window)
        DestroyWindow(context->window);
    free(context);
}

/* Contexts that share objects are not supported. */
EGLContext EGLAPIENTRY eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext shared,
                                        const EGLint* attributes) {
    struct Context* context = calloc(1, sizeof *context);
    (void)config;
    if (!context || display != onlyDisplay || shared != EGL_NO_CONTEXT || !createWindow(context) ||
        !(context->context = createWithAttributes(context, attributes))) {
        if (context)
            destroy(context);
        return EGL_NO_CONTEXT;
    }
    return context;
}

EGLBoolean EGLAPIENTRY eglDestroyContext(EGLDisplay display, EGLContext handle) {
    if (display != onlyDisplay || !handle)
        return EGL_FALSE;
    if (current == handle)
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    destroy(handle);
    return EGL_TRUE;
}

EGLBoolean EGLAPIENTRY eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext handle) {
    struct Context* const context = handle;
    (void)display, (void)draw, (void)read;
    if (!(context ? wglMakeCurrent(context->device, context->context) : wglMakeCurrent(NULL, NULL)))
        return EGL_FALSE;
    current = context;
    return EGL_TRUE;
}

EGLContext EGLAPIENTRY eglGetCurrentContext(void) { return current; }

EGLDisplay EGLAPIENTRY eglGetCurrentDisplay(void) { return current ? onlyDisplay : EGL_NO_DISPLAY; }

EGLSurface EGLAPIENTRY eglGetCurrentSurface(EGLint which) {
    (void)which;
    return EGL_NO_SURFACE;
}

/* WGL does not find the functions of OpenGL 1.1. Some drivers return 1, 2, 3 or -1 in place of null. */
Function EGLAPIENTRY eglGetProcAddress(const char* name) {
    const Function found = (Function)wglGetProcAddress(name);
    const intptr_t value = (intptr_t)found;
    return value > 3 || value < -1 ? found : (Function)GetProcAddress(GetModuleHandleA("opengl32.dll"), name);
}

/* The contexts are those of the process, which ends soon. */
EGLBoolean EGLAPIENTRY eglTerminate(EGLDisplay display) {
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}
