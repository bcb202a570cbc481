#include "vk/device_table.h"

#include "core/base/error.h"

namespace agaa::vk {

InstanceTable loadInstanceTable(AgaaVkGetInstanceProcAddr getProcAddr, VkInstance instance) {
    InstanceTable table;
    const auto load = [&](auto& slot, const char* name) {
        slot = reinterpret_cast<std::remove_reference_t<decltype(slot)>>(getProcAddr(instance, name));
        if (!slot)
            fail(AGAA_ERROR_UNSUPPORTED, format("the instance has no %s.", name));
    };
#define AGAA_VK_LOAD(name) load(table.name, "vk" #name);
    AGAA_VK_INSTANCE_FUNCTIONS(AGAA_VK_LOAD)
#undef AGAA_VK_LOAD
    table.getProcAddr = getProcAddr;
    table.instance = instance;
    return table;
}

DeviceTable loadDeviceTable(const InstanceTable& functions, AgaaVkGetInstanceProcAddr getProcAddr, VkInstance instance,
                            VkDevice device, OptionalFunctions wanted) {
    DeviceTable table;
    const auto find = [&](auto& slot, const char* name) {
        slot = reinterpret_cast<std::remove_reference_t<decltype(slot)>>(functions.GetDeviceProcAddr(device, name));
        return slot != nullptr;
    };
    const auto load = [&](auto& slot, const char* name) {
        if (!find(slot, name))
            fail(AGAA_ERROR_UNSUPPORTED, format("the device has no %s.", name));
    };
#define AGAA_VK_LOAD(name) load(table.name, "vk" #name);
    AGAA_VK_DEVICE_FUNCTIONS(AGAA_VK_LOAD)
#undef AGAA_VK_LOAD
    if (wanted.dynamicRendering) {
        if (!find(table.CmdBeginRendering, "vkCmdBeginRendering"))
            load(table.CmdBeginRendering, "vkCmdBeginRenderingKHR");
        if (!find(table.CmdEndRendering, "vkCmdEndRendering"))
            load(table.CmdEndRendering, "vkCmdEndRenderingKHR");
    }
    if (wanted.conditionalRendering) {
        load(table.CmdBeginConditionalRenderingEXT, "vkCmdBeginConditionalRenderingEXT");
        load(table.CmdEndConditionalRenderingEXT, "vkCmdEndConditionalRenderingEXT");
    }
    if (wanted.sampleLocations)
        load(table.CmdSetSampleLocationsEXT, "vkCmdSetSampleLocationsEXT");
    const auto optional = [&](auto& slot, const char* name) {
        slot = reinterpret_cast<std::remove_reference_t<decltype(slot)>>(getProcAddr(instance, name));
    };
    optional(table.CmdBeginDebugUtilsLabelEXT, "vkCmdBeginDebugUtilsLabelEXT");
    optional(table.CmdEndDebugUtilsLabelEXT, "vkCmdEndDebugUtilsLabelEXT");
    optional(table.SetDebugUtilsObjectNameEXT, "vkSetDebugUtilsObjectNameEXT");
    return table;
}

void check(VkResult result, const char* call) {
    if (result == VK_SUCCESS)
        return;
    const bool memory = result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
    fail(memory ? AGAA_ERROR_OUT_OF_MEMORY : AGAA_ERROR_DEVICE, format("%s returned VkResult %d.", call, int(result)));
}

} // namespace agaa::vk
