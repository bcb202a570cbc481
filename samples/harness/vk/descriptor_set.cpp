#include "vk/descriptor_set.h"

namespace harness::vk {

DescriptorSet::DescriptorSet(VkDevice device, VkDescriptorSetLayout layout,
                             std::span<const VkDescriptorPoolSize> sizes) {
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = 1;
    pool.poolSizeCount = uint32_t(sizes.size());
    pool.pPoolSizes = sizes.data();
    pool_ = make<DescriptorPool>(device, vkCreateDescriptorPool, pool, "create a descriptor pool");
    VkDescriptorSetAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocation.descriptorPool = pool_.get();
    allocation.descriptorSetCount = 1;
    allocation.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device, &allocation, &set_), "allocate a descriptor set");
}

} // namespace harness::vk
