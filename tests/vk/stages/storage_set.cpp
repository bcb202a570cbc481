#include "storage_set.h"

using namespace harness::vk;

namespace agaa::test {

StorageSet::StorageSet(const Device& device, uint32_t count, VkShaderStageFlags stages) : device_(device.get()) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (uint32_t i = 0; i < count; ++i)
        bindings.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, stages, nullptr});
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout.bindingCount = count;
    layout.pBindings = bindings.data();
    layout_ = make<DescriptorSetLayout>(device_, vkCreateDescriptorSetLayout, layout, "create a set layout");
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count};
    set_ = DescriptorSet(device_, layout_.get(), {&size, 1});
}

void StorageSet::write(const std::vector<VkBuffer>& buffers) const {
    std::vector<VkDescriptorBufferInfo> infos;
    for (VkBuffer buffer : buffers)
        infos.push_back({buffer, 0, VK_WHOLE_SIZE});
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set_.get();
    write.descriptorCount = uint32_t(infos.size());
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = infos.data(); // runs on from binding 0
    vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

} // namespace agaa::test
