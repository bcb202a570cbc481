// The SDK inside one host device.
#pragma once

#include "core/api_guard.h"
#include "vk/device_table.h"

namespace agaa::vk {

AgaaDeviceCaps queryCaps(const InstanceTable& functions, VkPhysicalDevice device);

// Host memory for the objects behind handles.
struct HostAllocator {
    AgaaAllocateCallback allocateCallback = nullptr;
    AgaaFreeCallback freeCallback = nullptr;
    void* user = nullptr;

    void* allocate(size_t size, size_t alignment) const;
    void free(void* memory) const;
};

} // namespace agaa::vk

struct AgaaContext_T {
    explicit AgaaContext_T(const AgaaVkContextDesc& desc);
    ~AgaaContext_T();
    AgaaContext_T(const AgaaContext_T&) = delete;
    AgaaContext_T& operator=(const AgaaContext_T&) = delete;

    void name(VkObjectType type, uint64_t handle, const std::string& text) const;

    agaa::Log log;
    agaa::vk::HostAllocator allocator;
    agaa::vk::InstanceTable instanceFunctions;
    agaa::vk::DeviceTable vk;
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    uint32_t queueFamily;
    bool dynamicRendering = false;
    bool secondary = true; // draw callbacks get a command buffer of ours
    uint32_t descriptorSet;
    VkPipelineCache pipelineCache;
    uint32_t framesInFlight;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT; // less what the host did not enable
    VkPhysicalDeviceMemoryProperties memory{};
    VkDeviceSize maxAllocation = 0;
    VkDeviceSize granularity = 1; // between buffers and images in one allocation
    float timestampPeriod = 0;    // nanoseconds a tick
    uint64_t timestampMask = 0;   // 0: the queue has no timestamps
    VkSampler texelSampler = VK_NULL_HANDLE;
    VkSampler shadowSampler = VK_NULL_HANDLE;
    uint32_t viewCount = 0;
};
