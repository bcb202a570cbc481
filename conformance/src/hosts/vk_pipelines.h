// The pipelines of the suite's host on Vulkan.
#pragma once

#include "vk_shaders.h"

#include <map>
#include <set>

namespace agaa::conformance {

struct VulkanPipeline {
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline opaque = VK_NULL_HANDLE, masked = VK_NULL_HANDLE;
};

class VulkanPipelines {
public:
    VulkanPipelines(const VulkanApi& api, const Mistakes& mistakes);
    ~VulkanPipelines();
    VulkanPipelines(const VulkanPipelines&) = delete;
    VulkanPipelines& operator=(const VulkanPipelines&) = delete;

    // `descriptorSet` is the index of the SDK's set.
    void prepare(const Functions& sdk, AgaaView view, uint32_t descriptorSet);
    void forget(AgaaView view);
    // Returns null if the pass was not prepared.
    const VulkanPipeline* find(AgaaView view, uint64_t pipelineKey, uint32_t pass) const;

private:
    using Key = std::pair<AgaaView, uint64_t>; // null and the pass with Mistakes::keysByPass
    Key keyOf(AgaaView view, uint64_t pipelineKey, uint32_t pass) const;
    VulkanPipeline create(const AgaaDrawPass& pass, const AgaaVkDrawPass& native, uint32_t descriptorSet);
    VkPipeline createOne(const AgaaDrawPass& pass, const AgaaVkDrawPass& native, VkPipelineLayout layout,
                         bool isMasked);
    void destroy(const VulkanPipeline& pipeline) const;

    const VulkanApi& api_;
    const Mistakes& mistakes_;
    VulkanShaders shaders_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout emptySet_ = VK_NULL_HANDLE;
    std::map<Key, VulkanPipeline> pipelines_;
    std::set<AgaaView> views_;
};

} // namespace agaa::conformance
