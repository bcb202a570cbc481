// The Vulkan functions of one device, loaded from the host's proc-address function and checked once.
#pragma once

#include "agaa_vk.h"
#include "vk/vulkan.h"

namespace agaa::vk {

#define AGAA_VK_INSTANCE_FUNCTIONS(X)                                                                                  \
    X(GetPhysicalDeviceProperties2)                                                                                    \
    X(GetPhysicalDeviceFeatures2)                                                                                      \
    X(GetPhysicalDeviceMemoryProperties)                                                                               \
    X(GetPhysicalDeviceFormatProperties)                                                                               \
    X(GetPhysicalDeviceImageFormatProperties)                                                                          \
    X(GetPhysicalDeviceQueueFamilyProperties)                                                                          \
    X(EnumerateDeviceExtensionProperties)                                                                              \
    X(GetDeviceProcAddr)

#define AGAA_VK_DEVICE_FUNCTIONS(X)                                                                                    \
    X(AllocateCommandBuffers)                                                                                          \
    X(AllocateDescriptorSets)                                                                                          \
    X(AllocateMemory)                                                                                                  \
    X(BeginCommandBuffer)                                                                                              \
    X(BindBufferMemory)                                                                                                \
    X(BindImageMemory)                                                                                                 \
    X(CmdBeginRenderPass)                                                                                              \
    X(CmdBindDescriptorSets)                                                                                           \
    X(CmdBindPipeline)                                                                                                 \
    X(CmdCopyBuffer)                                                                                                   \
    X(CmdDispatch)                                                                                                     \
    X(CmdDispatchIndirect)                                                                                             \
    X(CmdEndRenderPass)                                                                                                \
    X(CmdExecuteCommands)                                                                                              \
    X(CmdFillBuffer)                                                                                                   \
    X(CmdPipelineBarrier)                                                                                              \
    X(CmdResetQueryPool)                                                                                               \
    X(CmdUpdateBuffer)                                                                                                 \
    X(CmdWriteTimestamp)                                                                                               \
    X(CreateBuffer)                                                                                                    \
    X(CreateCommandPool)                                                                                               \
    X(CreateComputePipelines)                                                                                          \
    X(CreateDescriptorPool)                                                                                            \
    X(CreateDescriptorSetLayout)                                                                                       \
    X(CreateFramebuffer)                                                                                               \
    X(CreateImage)                                                                                                     \
    X(CreateImageView)                                                                                                 \
    X(CreatePipelineCache)                                                                                             \
    X(CreatePipelineLayout)                                                                                            \
    X(CreateQueryPool)                                                                                                 \
    X(CreateRenderPass)                                                                                                \
    X(CreateSampler)                                                                                                   \
    X(CreateShaderModule)                                                                                              \
    X(DestroyBuffer)                                                                                                   \
    X(DestroyCommandPool)                                                                                              \
    X(DestroyDescriptorPool)                                                                                           \
    X(DestroyDescriptorSetLayout)                                                                                      \
    X(DestroyFramebuffer)                                                                                              \
    X(DestroyImage)                                                                                                    \
    X(DestroyImageView)                                                                                                \
    X(DestroyPipeline)                                                                                                 \
    X(DestroyPipelineCache)                                                                                            \
    X(DestroyPipelineLayout)                                                                                           \
    X(DestroyQueryPool)                                                                                                \
    X(DestroyRenderPass)                                                                                               \
    X(DestroySampler)                                                                                                  \
    X(DestroyShaderModule)                                                                                             \
    X(EndCommandBuffer)                                                                                                \
    X(FreeMemory)                                                                                                      \
    X(GetBufferMemoryRequirements)                                                                                     \
    X(GetImageMemoryRequirements)                                                                                      \
    X(GetQueryPoolResults)                                                                                             \
    X(MapMemory)                                                                                                       \
    X(UpdateDescriptorSets)

struct InstanceTable {
#define AGAA_VK_MEMBER(name) PFN_vk##name name = nullptr;
    AGAA_VK_INSTANCE_FUNCTIONS(AGAA_VK_MEMBER)
    // Functions of device extensions are loaded where a device has the extension.
    AgaaVkGetInstanceProcAddr getProcAddr = nullptr;
    VkInstance instance = VK_NULL_HANDLE;
};

struct DeviceTable {
    AGAA_VK_DEVICE_FUNCTIONS(AGAA_VK_MEMBER)
#undef AGAA_VK_MEMBER
    // Dynamic rendering; null if the context uses render passes.
    PFN_vkCmdBeginRendering CmdBeginRendering = nullptr;
    PFN_vkCmdEndRendering CmdEndRendering = nullptr;
    // Conditional rendering; null if the host did not enable it.
    PFN_vkCmdBeginConditionalRenderingEXT CmdBeginConditionalRenderingEXT = nullptr;
    PFN_vkCmdEndConditionalRenderingEXT CmdEndConditionalRenderingEXT = nullptr;
    // Sample locations; null if the host did not enable them.
    PFN_vkCmdSetSampleLocationsEXT CmdSetSampleLocationsEXT = nullptr;
    // Debug utilities; null if the host's instance lacks them.
    PFN_vkCmdBeginDebugUtilsLabelEXT CmdBeginDebugUtilsLabelEXT = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT CmdEndDebugUtilsLabelEXT = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT SetDebugUtilsObjectNameEXT = nullptr;
};

// Optional features that the host enabled.
struct OptionalFunctions {
    bool dynamicRendering = false;
    bool conditionalRendering = false;
    bool sampleLocations = false;
};

// Both throw AGAA_ERROR_UNSUPPORTED with the name of the first missing function.
InstanceTable loadInstanceTable(AgaaVkGetInstanceProcAddr getProcAddr, VkInstance instance);
DeviceTable loadDeviceTable(const InstanceTable& functions, AgaaVkGetInstanceProcAddr getProcAddr, VkInstance instance,
                            VkDevice device, OptionalFunctions wanted);

// Throws if a Vulkan call failed.
void check(VkResult result, const char* call);

} // namespace agaa::vk
