// A descriptor set with its own pool.
#pragma once

#include "vk/check.h"

#include <span>

namespace harness::vk {

class DescriptorSet {
public:
    DescriptorSet() = default;
    // `sizes` are the descriptors of the layout.
    DescriptorSet(VkDevice device, VkDescriptorSetLayout layout, std::span<const VkDescriptorPoolSize> sizes);

    VkDescriptorSet get() const { return set_; }

private:
    DescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

} // namespace harness::vk
