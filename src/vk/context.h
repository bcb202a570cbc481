// The SDK's state for one Vulkan device of the host.
#pragma once

#include "core/abi/handles.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/host_glsl.h"
#include "vk/device_table.h"

namespace agaa::vk {

AgaaDeviceCaps queryCaps(const InstanceTable& functions, VkPhysicalDevice device);

class Context : public AgaaContext_T {
public:
    Context(const AgaaContextDesc& common, const AgaaVkDeviceDesc& desc,
            const std::optional<AgaaVkAllocator>& allocatorOfHost);
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
    bool secondary = true; // draw callbacks record into secondary command buffers of the SDK
    HostDialect dialect;
    GlslCompilerUse compilerUse;
    VkPipelineCache pipelineCache;             // of the host, or createdCache_
    std::optional<AgaaVkAllocator> hostMemory; // nullopt: vkAllocateMemory
    VkPhysicalDeviceMemoryProperties memory{};
    uint32_t maxStorageImages = 0; // of a shader stage
    VkDeviceSize maxAllocation = 0;
    VkDeviceSize granularity = 1; // bytes, bufferImageGranularity
    float timestampPeriod = 0;    // nanoseconds per tick
    uint32_t timestampBits = 0;   // width of the counter in [0, 64]; 0: the queue has no timestamps
    VkSampler texelSampler = VK_NULL_HANDLE;
    VkSampler linearSampler = VK_NULL_HANDLE;
    VkSampler shadowSampler = VK_NULL_HANDLE;

private:
    void createObjects();
    void destroyObjects();
    VkPipelineCache createdCache_ = VK_NULL_HANDLE; // null if the host has a cache
};

} // namespace agaa::vk
