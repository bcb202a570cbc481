// A descriptor set of storage buffers.
#pragma once

#include "vk/check.h"
#include "vk/descriptor_set.h"
#include "vk/device.h"

#include <vector>

namespace agaa::test {

class StorageSet {
public:
    StorageSet() = default;
    // Bindings 0 to count-1, unwritten.
    StorageSet(const harness::vk::Device& device, uint32_t count, VkShaderStageFlags stages);
    void write(const std::vector<VkBuffer>& buffers) const;

    VkDescriptorSetLayout layout() const { return layout_.get(); }
    VkDescriptorSet get() const { return set_.get(); }

private:
    VkDevice device_ = VK_NULL_HANDLE;
    harness::vk::DescriptorSetLayout layout_;
    harness::vk::DescriptorSet set_;
};

} // namespace agaa::test
