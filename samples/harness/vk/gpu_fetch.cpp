#include "vk/gpu_fetch.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>

namespace harness::vk {

// Bindings of shaders/fetch.glsl.
enum : uint32_t { CameraBinding, DrawBinding, MaterialBinding, VertexBinding, IndexBinding, ColorBinding, ValueBinding,
                  BindingCount };

GpuFetch::GpuFetch(const Device& device, const Scene& scene, const GpuScene& gpuScene)
    : device_(&device), arena_(device), glsl_(fetchGlsl(false)) {
    const FetchScene fetch = makeFetchScene(scene);
    Uploader uploader(device);
    colors_ = uploader.textureArray(arena_, fetch.colors, true);
    values_ = uploader.textureArray(arena_, fetch.values, false);
    camera_ = arena_.hostBuffer(sizeof(glm::mat4), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    draws_ = arena_.hostBuffer(fetch.maxDraws * sizeof(FetchDraw), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    materials_ = arena_.hostBuffer(fetch.materials.size() * sizeof(FetchMaterial), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(materials_.mapped, fetch.materials.data(), fetch.materials.size() * sizeof(FetchMaterial));
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.anisotropyEnable = device.hasAnisotropy();
    info.maxAnisotropy = std::min(8.0f, device.limits().maxSamplerAnisotropy);
    info.maxLod = VK_LOD_CLAMP_NONE;
    sampler_ = make<Sampler>(device.get(), vkCreateSampler, info, "create a sampler");
    createSet(gpuScene);
    function_.glsl = glsl_.c_str();
    function_.maxDraws = fetch.maxDraws;
    function_.maxPrimitives = fetch.maxPrimitives;
    function_.descriptorSetLayout = (uint64_t)layout_.get();
}

void GpuFetch::createSet(const GpuScene& gpuScene) {
    const auto type = [](uint32_t binding) {
        return binding == CameraBinding ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
               : binding < ColorBinding ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                        : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    };
    std::array<VkDescriptorSetLayoutBinding, BindingCount> bindings{};
    for (uint32_t i = 0; i < BindingCount; ++i)
        bindings[i] = {i, type(i), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout.bindingCount = BindingCount;
    layout.pBindings = bindings.data();
    layout_ = make<DescriptorSetLayout>(device_->get(), vkCreateDescriptorSetLayout, layout,
                                        "create a descriptor set layout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 4},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2}};
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = 1;
    pool.poolSizeCount = uint32_t(std::size(sizes));
    pool.pPoolSizes = sizes;
    pool_ = make<DescriptorPool>(device_->get(), vkCreateDescriptorPool, pool, "create a descriptor pool");
    const VkDescriptorSetLayout handle = layout_.get();
    VkDescriptorSetAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocation.descriptorPool = pool_.get();
    allocation.descriptorSetCount = 1;
    allocation.pSetLayouts = &handle;
    check(vkAllocateDescriptorSets(device_->get(), &allocation, &set_), "allocate a descriptor set");

    const VkBuffer buffers[] = {camera_.buffer.get(), draws_.buffer.get(), materials_.buffer.get(),
                                gpuScene.vertices(), gpuScene.indices()};
    const VkImageView views[] = {colors_.view.get(), values_.view.get()};
    std::array<VkDescriptorBufferInfo, ColorBinding> bufferInfos{};
    std::array<VkDescriptorImageInfo, BindingCount - ColorBinding> imageInfos{};
    std::array<VkWriteDescriptorSet, BindingCount> writes{};
    for (uint32_t i = 0; i < BindingCount; ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set_;
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = type(i);
        if (i < ColorBinding) {
            bufferInfos[i] = {buffers[i], 0, VK_WHOLE_SIZE};
            writes[i].pBufferInfo = &bufferInfos[i];
        } else {
            imageInfos[i - ColorBinding] = {sampler_.get(), views[i - ColorBinding],
                                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            writes[i].pImageInfo = &imageInfos[i - ColorBinding];
        }
    }
    vkUpdateDescriptorSets(device_->get(), BindingCount, writes.data(), 0, nullptr);
}

void GpuFetch::update(const Scene& scene, const std::vector<Draw>& draws, const glm::mat4& viewProjection) {
    const std::vector<FetchDraw> rows = fetchDraws(scene, draws);
    std::memcpy(draws_.mapped, rows.data(), rows.size() * sizeof(FetchDraw));
    std::memcpy(camera_.mapped, glm::value_ptr(viewProjection), sizeof viewProjection);
}

} // namespace harness::vk
