// AGAA SDK on OpenGL for C++17 and later. The conventions are those of agaa.hpp. It includes no OpenGL header.
// SPDX-License-Identifier: MIT
//
// Threads   The thread in which the OpenGL context is current, except for getRequirements and getProgramCache.
#ifndef AGAA_GL_HPP
#define AGAA_GL_HPP

#include "agaa.hpp"
#include "agaa_gl.h"

namespace agaa {

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wzero-as-null-pointer-constant"
#endif
template <> constexpr AgaaGlRequirements init() noexcept { return AGAA_GL_REQUIREMENTS_INIT; }
template <> constexpr AgaaGlDeviceDesc init() noexcept { return AGAA_GL_DEVICE_DESC_INIT; }
template <> constexpr AgaaGlDrawPass init() noexcept { return AGAA_GL_DRAW_PASS_INIT; }
template <> constexpr AgaaGlSurface init() noexcept { return AGAA_GL_SURFACE_INIT; }
template <> constexpr AgaaGlFrame init() noexcept { return AGAA_GL_FRAME_INIT; }
template <> constexpr AgaaGlResolvedTextures init() noexcept { return AGAA_GL_RESOLVED_TEXTURES_INIT; }
template <> constexpr AgaaGlProgramCache init() noexcept { return AGAA_GL_PROGRAM_CACHE_INIT; }
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

template <> inline constexpr bool isChainable<AgaaContextDesc, AgaaGlDeviceDesc> = true;
template <> inline constexpr bool isChainable<AgaaContextDesc, AgaaGlProgramCache> = true;
template <> inline constexpr bool isChainable<AgaaDrawPass, AgaaGlDrawPass> = true;
template <> inline constexpr bool isChainable<AgaaSurface, AgaaGlSurface> = true;
template <> inline constexpr bool isChainable<AgaaGlFrame, AgaaGlResolvedTextures> = true;

namespace gl {

// Threads   Any. No context needs to be current. The names in the struct have static storage.
[[nodiscard]] inline Result<AgaaGlRequirements> getRequirements() noexcept {
    return detail::filled(init<AgaaGlRequirements>(), agaaGlGetRequirements);
}

// getProcUser   The first argument of getProcAddr.
[[nodiscard]] inline Result<AgaaDeviceCaps> getDeviceCaps(AgaaGlGetProcAddr getProcAddr, void* getProcUser = nullptr,
                                                          const AgaaLog* log = nullptr) noexcept {
    return detail::filled(init<AgaaDeviceCaps>(), [&](AgaaDeviceCaps* caps) {
        return agaaGlGetDeviceCaps(getProcAddr, getProcUser, log, caps);
    });
}

// desc      Must chain an AgaaGlDeviceDesc. It may chain an AgaaGlProgramCache to keep programs.
// version   The version that the host was compiled with. Tests pass others.
[[nodiscard]] inline Result<Context> createContext(const AgaaContextDesc& desc,
                                                   uint32_t version = headerVersion) noexcept {
    AgaaContext context = nullptr;
    const AgaaResult result = agaaGlCreateContext(version, &desc, &context);
    if (result != AGAA_OK)
        return Failure{result};
    return Context(context);
}

[[nodiscard]] inline Result<AgaaDeviceCaps> getContextCaps(AgaaContext context) noexcept {
    return detail::filled(init<AgaaDeviceCaps>(),
                          [&](AgaaDeviceCaps* caps) { return agaaGlGetContextCaps(context, caps); });
}

// Returns the bytes for AgaaGlProgramCache::data of a later run.
//
// Threads   One call at a time per context. The OpenGL context need not be current.
[[nodiscard]] inline Result<std::vector<unsigned char>> getProgramCache(AgaaContext context) {
    return detail::list<size_t, unsigned char>(
        0, [&](size_t* size, unsigned char* data) { return agaaGlGetProgramCache(context, size, data); });
}

// context   Must outlive the view.
// desc      Read during the call only, with all that it points to.
[[nodiscard]] inline Result<View> createView(AgaaContext context, const AgaaViewDesc& desc) noexcept {
    AgaaView view = nullptr;
    const AgaaResult result = agaaGlCreateView(context, &desc, &view);
    if (result != AGAA_OK)
        return Failure{result};
    return View(view);
}

struct DrawPass {
    AgaaDrawPass pass;
    AgaaGlDrawPass gl;
};
// The view owns texts and objects. They stay valid until it is resized or destroyed.
[[nodiscard]] inline Result<std::vector<DrawPass>> getDrawPasses(AgaaView view) {
    return detail::drawPassesWith(view, &DrawPass::gl);
}

struct Surface {
    AgaaSurface surface;
    AgaaGlSurface gl;
};
// The view owns the objects. They stay valid until it is resized or destroyed.
[[nodiscard]] inline Result<Surface> getSurface(AgaaView view, const char* name) noexcept {
    return detail::surfaceWith(view, name, &Surface::gl);
}

[[nodiscard]] inline AgaaResult recordFrame(AgaaView view, const AgaaFrame& frame,
                                            const AgaaGlFrame& glFrame) noexcept {
    return agaaGlRecordFrame(view, &frame, &glFrame);
}

} // namespace gl
} // namespace agaa

#endif // AGAA_GL_HPP
