// The SDK inside one host device.
#pragma once

#include "core/abi/handles.h"
#include "core/glsl/host_glsl.h"
#include "vk/device_table.h"

namespace agaa::vk {

AgaaDeviceCaps queryCaps(const InstanceTable& functions, VkPhysicalDevice device);

class Context : public AgaaContext_T {
public:
    Context(const AgaaContextDesc& common, const AgaaVkDeviceDesc& desc, const std::optional<AgaaVkAllocator>& memoryOfHost);
    ~Context() override;

    void name(VkObjectType type, uint64_t handle, const std::string& text) const;

    InstanceTable instanceFunctions;
    DeviceTable vk;
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    uint32_t queueFamily;
    bool dynamicRendering = false;
    bool conditionalRendering = false;
    bool secondary = true; // draw callbacks get a command buffer of ours
    HostDialect dialect;
    VkPipelineCache pipelineCache; // the host's, or ownCache_
    std::optional<AgaaVkAllocator> hostMemory; // else vkAllocateMemory
    VkPhysicalDeviceMemoryProperties memory{};
    VkDeviceSize maxAllocation = 0;
    VkDeviceSize granularity = 1; // between buffers and images in one allocation
    float timestampPeriod = 0;    // nanoseconds a tick
    uint64_t timestampMask = 0;   // 0: the queue has no timestamps
    VkSampler texelSampler = VK_NULL_HANDLE;
    VkSampler linearSampler = VK_NULL_HANDLE;
    VkSampler shadowSampler = VK_NULL_HANDLE;

private:
    void createObjects();
    void destroyObjects();
    VkPipelineCache ownCache_ = VK_NULL_HANDLE;
};

} // namespace agaa::vk
