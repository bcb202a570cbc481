// AGAA SDK on Vulkan for C++17 and later. The conventions are those of agaa.hpp. It includes no Vulkan header.
// SPDX-License-Identifier: MIT
#ifndef AGAA_VK_HPP
#define AGAA_VK_HPP

#include "agaa.hpp"
#include "agaa_vk.h"

namespace agaa {

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wzero-as-null-pointer-constant"
#endif
template <> constexpr AgaaVkRequirements init() noexcept { return AGAA_VK_REQUIREMENTS_INIT; }
template <> constexpr AgaaVkDeviceDesc init() noexcept { return AGAA_VK_DEVICE_DESC_INIT; }
template <> constexpr AgaaVkAllocator init() noexcept { return AGAA_VK_ALLOCATOR_INIT; }
template <> constexpr AgaaVkDrawPass init() noexcept { return AGAA_VK_DRAW_PASS_INIT; }
template <> constexpr AgaaVkSurface init() noexcept { return AGAA_VK_SURFACE_INIT; }
template <> constexpr AgaaVkFrame init() noexcept { return AGAA_VK_FRAME_INIT; }
template <> constexpr AgaaVkResolvedImages init() noexcept { return AGAA_VK_RESOLVED_IMAGES_INIT; }
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

template <> inline constexpr bool isChainable<AgaaContextDesc, AgaaVkDeviceDesc> = true;
template <> inline constexpr bool isChainable<AgaaContextDesc, AgaaVkAllocator> = true;
template <> inline constexpr bool isChainable<AgaaDrawPass, AgaaVkDrawPass> = true;
template <> inline constexpr bool isChainable<AgaaSurface, AgaaVkSurface> = true;
template <> inline constexpr bool isChainable<AgaaVkFrame, AgaaVkResolvedImages> = true;

namespace vk {

// Threads   Any. The names in the struct have static storage.
[[nodiscard]] inline Result<AgaaVkRequirements> getRequirements() noexcept {
    return detail::filled(init<AgaaVkRequirements>(), agaaVkGetRequirements);
}

// instance         VkInstance.
// physicalDevice   VkPhysicalDevice.
//
// Threads          Any.
[[nodiscard]] inline Result<AgaaDeviceCaps> getDeviceCaps(void* instance, void* physicalDevice,
                                                          AgaaVkGetInstanceProcAddr getProcAddr,
                                                          const AgaaLog* log = nullptr) noexcept {
    return detail::filled(init<AgaaDeviceCaps>(), [&](AgaaDeviceCaps* caps) {
        return agaaVkGetDeviceCaps(instance, physicalDevice, getProcAddr, log, caps);
    });
}

// desc      Must chain an AgaaVkDeviceDesc, whose device must outlive the context.
// version   The version that the host was compiled with. Tests pass others.
//
// Threads   Any.
[[nodiscard]] inline Result<Context> createContext(const AgaaContextDesc& desc,
                                                   uint32_t version = headerVersion) noexcept {
    AgaaContext context = nullptr;
    const AgaaResult result = agaaVkCreateContext(version, &desc, &context);
    if (result != AGAA_OK)
        return Failure{result};
    return Context(context);
}

// Threads   One call at a time per context.
[[nodiscard]] inline Result<AgaaDeviceCaps> getContextCaps(AgaaContext context) noexcept {
    return detail::filled(init<AgaaDeviceCaps>(),
                          [&](AgaaDeviceCaps* caps) { return agaaVkGetContextCaps(context, caps); });
}

// context   Must outlive the view.
// desc      Read during the call only, with all that it points to.
//
// Threads   One call at a time per context.
[[nodiscard]] inline Result<View> createView(AgaaContext context, const AgaaViewDesc& desc) noexcept {
    AgaaView view = nullptr;
    const AgaaResult result = agaaVkCreateView(context, &desc, &view);
    if (result != AGAA_OK)
        return Failure{result};
    return View(view);
}

struct DrawPass {
    AgaaDrawPass pass;
    AgaaVkDrawPass vk;
};
// The view owns texts and objects. They stay valid until it is resized or destroyed.
//
// Threads   One call at a time per context.
[[nodiscard]] inline Result<std::vector<DrawPass>> getDrawPasses(AgaaView view) {
    return detail::drawPassesWith(view, &DrawPass::vk);
}

struct Surface {
    AgaaSurface surface;
    AgaaVkSurface vk;
};
// The view owns the handles. They stay valid until it is resized or destroyed.
//
// Threads   One call at a time per context.
[[nodiscard]] inline Result<Surface> getSurface(AgaaView view, const char* name) noexcept {
    return detail::surfaceWith(view, name, &Surface::vk);
}

// Threads   One call at a time per context.
[[nodiscard]] inline AgaaResult recordFrame(AgaaView view, const AgaaFrame& frame,
                                            const AgaaVkFrame& vkFrame) noexcept {
    return agaaVkRecordFrame(view, &frame, &vkFrame);
}

} // namespace vk
} // namespace agaa

#endif // AGAA_VK_HPP
