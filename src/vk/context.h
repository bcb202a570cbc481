// The SDK's state for one Vulkan device of the host.
#pragma once

#include "core/abi/handles.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/host_glsl.h"
#include "core/plan/plan.h"
#include "vk/device_table.h"

#include <vector>

namespace agaa::vk {

// Numbers of samples that one rendering can have.
struct MixedSamples {
    uint32_t samples;          // of rasterisation and depth
    VkSampleCountFlags colors; // of colour attachments
};
// Returns the combinations with which a colour sample is written if the rasterisation sample of the same index is
// covered (VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV). It returns none if the instance lacks
// VK_NV_coverage_reduction_mode.
std::vector<MixedSamples> truncatedSamples(const InstanceTable& functions, VkPhysicalDevice device);
AgaaDeviceCaps queryCaps(const InstanceTable& functions, VkPhysicalDevice device);

class Context : public AgaaContext_T {
public:
    Context(const AgaaContextDesc& common, const AgaaVkDeviceDesc& desc,
            const std::optional<AgaaVkAllocator>& allocatorOfHost);
    ~Context() override;

    // Throws AGAA_ERROR_UNSUPPORTED if the targets of a draw have numbers of samples that the device cannot combine, or
    // formats that it cannot blend although the draw blends.
    void checkTargets(const Plan& plan, const Pass& pass) const;
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
    std::vector<MixedSamples> mixedSamples; // with AGAA_DEVICE_NV_MIXED_SAMPLES
    uint32_t maxStorageImages = 0;          // of a shader stage
    uint32_t maxColorAttachments = 0;
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
