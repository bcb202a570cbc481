#include "vk/gpu_filtered_shadows.h"

#include "vk/gpu_environment.h"
#include "vk/gpu_scene.h"

#include <cstring>
#include <stdexcept>

namespace harness::vk {

GpuFilteredShadows::GpuFilteredShadows(const Device& device, VkDescriptorSetLayout layout)
    : device_(&device), arena_(device), constantArena_(device) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physicalDevice(), VK_FORMAT_R32G32_SFLOAT, &properties);
    if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
        throw std::runtime_error("The device does not filter images of 32-bit floats, in which the moments are.");
    constants_ = constantArena_.hostBuffer(sizeof(FilteredShadowConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    sampler_ = makeSampler(device, {Wrap::Clamp, Wrap::Clamp, {Filter::Linear, Filter::Linear, MipFilter::Linear}});
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2}};
    set_ = DescriptorSet(device.get(), layout, sizes);
}

void GpuFilteredShadows::update(const ShadowMaps& maps) {
    if (maps.shadows().empty() || version_ == maps.version())
        return;
    moments_ = {};
    arena_ = Arena(*device_);
    Uploader uploader(*device_);
    moments_ = uploader.momentArray(arena_, momentLayers(depthsOf(maps), maps.size()));
    const FilteredShadowConstants constants = filteredShadowConstants(maps.shadows());
    std::memcpy(constants_.mapped, &constants, sizeof constants);
    write(set_.get());
    // Any resource: lavapipe (Mesa 22.3) reads bindings that shaders do not use.
    write(set_.get(), environmentBinding);
    version_ = maps.version();
}

void GpuFilteredShadows::write(VkDescriptorSet set, uint32_t binding) const {
    const VkDescriptorImageInfo map{sampler_.get(), moments_.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkDescriptorBufferInfo constants{constants_.buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet writes[2]{};
    for (uint32_t i = 0; i < 2; ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set;
        writes[i].dstBinding = binding + i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType =
            i == 0 ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        writes[i].pImageInfo = &map; // Vulkan ignores members that the type does not use
        writes[i].pBufferInfo = &constants;
    }
    vkUpdateDescriptorSets(device_->get(), 2, writes, 0, nullptr);
}

} // namespace harness::vk
