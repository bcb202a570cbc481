#include "dispatch_hook.h"

#include "vk/device.h"

#include <cstring>

namespace agaa::test {

std::function<void(VkCommandBuffer)> DispatchHook::before;

namespace {

PFN_vkCmdDispatch hookedDispatch = nullptr;
PFN_vkGetDeviceProcAddr hookedDeviceProcAddr = nullptr;

VKAPI_ATTR void VKAPI_CALL dispatchWithHook(VkCommandBuffer commands, uint32_t x, uint32_t y, uint32_t z) {
    if (DispatchHook::before)
        DispatchHook::before(commands);
    hookedDispatch(commands, x, y, z);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddrWithHook(VkDevice device, const char* name) {
    const PFN_vkVoidFunction real = hookedDeviceProcAddr(device, name);
    if (std::strcmp(name, "vkCmdDispatch") != 0)
        return real;
    hookedDispatch = reinterpret_cast<PFN_vkCmdDispatch>(real);
    return reinterpret_cast<PFN_vkVoidFunction>(dispatchWithHook);
}

} // namespace

AgaaVkFunction AGAA_CALL DispatchHook::procAddr(void* instance, const char* name) {
    const AgaaVkFunction real = harness::vk::Device::getProcAddr(instance, name);
    if (std::strcmp(name, "vkGetDeviceProcAddr") != 0)
        return real;
    hookedDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(real);
    return reinterpret_cast<AgaaVkFunction>(deviceProcAddrWithHook);
}

} // namespace agaa::test
