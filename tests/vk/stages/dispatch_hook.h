// Functions of Vulkan for contexts whose dispatches a test observes.
#pragma once

#include "agaa_vk.h"

#include <vulkan/vulkan.h>

#include <functional>

namespace agaa::test {

struct DispatchHook {
    // Called before each vkCmdDispatch of contexts with procAddr, with its command buffer. Empty: none.
    static std::function<void(VkCommandBuffer)> before;
    // For HostOptions::getProcAddr.
    static AgaaVkFunction AGAA_CALL procAddr(void* instance, const char* name);
};

} // namespace agaa::test
