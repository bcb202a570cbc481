#include "vk/gpu_environment.h"

#include "vk/gpu_filtered_shadows.h"
#include "vk/gpu_scene.h"

#include <cstring>

namespace harness::vk {

namespace {

std::vector<MipLevel> bytesOf(const std::vector<HalfLevel>& levels) {
    std::vector<MipLevel> result;
    for (const HalfLevel& level : levels) {
        MipLevel& bytes = result.emplace_back(MipLevel{level.width, level.height, {}});
        bytes.rgba.resize(level.rgba.size() * sizeof(uint16_t));
        std::memcpy(bytes.rgba.data(), level.rgba.data(), bytes.rgba.size());
    }
    return result;
}

} // namespace

std::array<VkDescriptorSetLayoutBinding, 4> environmentLayoutBindings(VkShaderStageFlags stages) {
    static_assert(filteredShadowBinding == environmentBinding + 2);
    return {{{environmentBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, stages, nullptr},
             {environmentBinding + 1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, stages, nullptr},
             {filteredShadowBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, stages, nullptr},
             {filteredShadowBinding + 1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, stages, nullptr}}};
}

DescriptorSetLayout makeEnvironmentLayout(const Device& device) {
    const auto bindings = environmentLayoutBindings(VK_SHADER_STAGE_COMPUTE_BIT | VK_SHADER_STAGE_FRAGMENT_BIT);
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = uint32_t(bindings.size());
    info.pBindings = bindings.data();
    return make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, info, "create a descriptor set layout");
}

GpuEnvironment::GpuEnvironment(const Device& device, VkDescriptorSetLayout layout, const Environment& environment)
    : device_(&device), arena_(device) {
    Uploader uploader(device);
    map_ = uploader.halfTexture(arena_, bytesOf(environment.levels));
    constants_ = arena_.hostBuffer(sizeof environment.constants, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    std::memcpy(constants_.mapped, &environment.constants, sizeof environment.constants);
    // Shaders interpolate between levels themselves, because rows of levels have different places.
    sampler_ = makeSampler(device, {Wrap::Repeat, Wrap::Clamp, {Filter::Linear, Filter::Linear, MipFilter::Nearest}});
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2}};
    set_ = DescriptorSet(device.get(), layout, sizes);
    write(set_.get());
    // Any resource: lavapipe (Mesa 22.3) reads bindings that shaders do not use.
    write(set_.get(), filteredShadowBinding);
}

void GpuEnvironment::write(VkDescriptorSet set, uint32_t binding) const {
    const VkDescriptorImageInfo map{sampler_.get(), map_.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkDescriptorBufferInfo constants{constants_.buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet writes[2]{};
    for (VkWriteDescriptorSet& write : writes) {
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.descriptorCount = 1;
    }
    writes[0].dstBinding = binding;
    writes[0].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[0].pImageInfo = &map;
    writes[1].dstBinding = binding + 1;
    writes[1].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    writes[1].pBufferInfo = &constants;
    vkUpdateDescriptorSets(device_->get(), 2, writes, 0, nullptr);
}

} // namespace harness::vk
