// An EGL display that needs no window.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

namespace harness::gl {

namespace detail {

inline bool lists(const char* extensions, std::string_view name) {
    return extensions && std::string_view(extensions).find(name) != std::string_view::npos;
}

inline bool hasOpenGl(EGLDisplay display) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return context != EGL_NO_CONTEXT && eglDestroyContext(display, context);
}

// Returns the display of the first graphics card that EGL lists and this process may use.
inline EGLDisplay displayOfCard() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!lists(client, "EGL_EXT_platform_device") ||
        !(lists(client, "EGL_EXT_device_enumeration") || lists(client, "EGL_EXT_device_base")))
        return EGL_NO_DISPLAY;
    const auto queryDevices = PFNEGLQUERYDEVICESEXTPROC(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto queryString = PFNEGLQUERYDEVICESTRINGEXTPROC(eglGetProcAddress("eglQueryDeviceStringEXT"));
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (!queryDevices || !queryString || !queryDevices(16, devices, &count))
        return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        if (lists(queryString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
            continue;
        const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (display != EGL_NO_DISPLAY && hasOpenGl(display))
            return display;
    }
    return EGL_NO_DISPLAY;
}

} // namespace detail

// Returns an initialised display, or EGL_NO_DISPLAY. It is Mesa's software rasteriser if there is no card or
// LIBGL_ALWAYS_SOFTWARE is true as Mesa reads it.
inline EGLDisplay displayWithoutWindow() {
    const char* software = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const bool isSoftware = software && software[0] && std::strchr("1tTyY", software[0]);
    const EGLDisplay card = isSoftware ? EGL_NO_DISPLAY : detail::displayOfCard();
    if (card != EGL_NO_DISPLAY)
        return card;
    const EGLDisplay mesa = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return mesa != EGL_NO_DISPLAY && eglInitialize(mesa, nullptr, nullptr) ? mesa : EGL_NO_DISPLAY;
}

} // namespace harness::gl
