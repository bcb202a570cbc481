#include "vk/gpu_scene.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace harness::vk {

namespace {

VkSamplerAddressMode addressMode(Wrap wrap) {
    switch (wrap) {
    case Wrap::Mirror:
        return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case Wrap::Clamp:
        return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case Wrap::Repeat:
        break;
    }
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

VkFilter filterOf(Filter filter) { return filter == Filter::Nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; }

} // namespace

Sampler makeSampler(const Device& device, const Sampling& sampling) {
    const TextureFilters& filters = sampling.filters;
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = filterOf(filters.magnify);
    info.minFilter = filterOf(filters.minify);
    info.mipmapMode =
        filters.mips == MipFilter::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = addressMode(sampling.wrapU);
    info.addressModeV = addressMode(sampling.wrapV);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.anisotropyEnable = filters == TextureFilters{} && device.hasAnisotropy();
    info.maxAnisotropy = std::min(8.0f, device.limits().maxSamplerAnisotropy);
    // Vulkan has no sampler without mip levels. Below 0.5, level 0 is read, and minification still differs from
    // magnification.
    info.maxLod = filters.mips == MipFilter::None ? 0.25f : VK_LOD_CLAMP_NONE;
    return make<Sampler>(device.get(), vkCreateSampler, info, "create a sampler");
}

GpuScene::GpuScene(const Device& device, const Scene& scene) : device_(&device), arena_(device) {
    Uploader uploader(device);
    uploadGeometry(uploader, scene);
    uploadTextures(uploader, scene);
    createMaterials(uploader, scene);
}

void GpuScene::uploadGeometry(Uploader& uploader, const Scene& scene) {
    checkMeshes(scene);
    const auto vertices = std::as_bytes(std::span(scene.vertices));
    const auto indices = std::as_bytes(std::span(scene.indices));
    // A scene may be empty, but a buffer may not.
    vertices_ = arena_.deviceBuffer(std::max(vertices.size(), sizeof(Vertex)),
                                    VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                                        VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    indices_ = arena_.deviceBuffer(std::max(indices.size(), sizeof(uint32_t)),
                                   VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                                       VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    uploader.fill(vertices_, vertices);
    uploader.fill(indices_, indices);
}

void GpuScene::uploadTextures(Uploader& uploader, const Scene& scene) {
    checkTextureSizes(scene, device_->limits().maxImageDimension2D);
    const std::vector<MipOptions> options = mipOptions(scene);
    for (size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        textures_.push_back(uploader.texture(arena_, makeMipChain(texture, options[i]), texture.srgb));
        samplings_.push_back(texture.sampling());
    }
    // This texture is bound if a material has no texture, because a driver may read every binding of a bound set.
    textures_.push_back(uploader.texture(arena_, {{1, 1, {255, 255, 255, 255}}}, false));
    samplings_.emplace_back();
}

VkSampler GpuScene::sampler(const Sampling& sampling) {
    Sampler& sampler = samplers_[sampling];
    if (!sampler)
        sampler = makeSampler(*device_, sampling);
    return sampler.get();
}

void GpuScene::createMaterials(Uploader& uploader, const Scene& scene) {
    std::vector<Material> materials = scene.materials;
    materials.emplace_back();
    const uint32_t count = uint32_t(materials.size());

    std::array<VkDescriptorSetLayoutBinding, materialTextureCount + 1> bindings{};
    for (uint32_t i = 0; i < bindings.size(); ++i)
        bindings[i] = {i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    bindings[materialConstantsBinding].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout.bindingCount = uint32_t(bindings.size());
    layout.pBindings = bindings.data();
    layout_ = make<DescriptorSetLayout>(device_->get(), vkCreateDescriptorSetLayout, layout,
                                        "create a descriptor set layout");

    const std::array<VkDescriptorPoolSize, 2> sizes = {
        {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, count * materialTextureCount},
         {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count}}};
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = count;
    pool.poolSizeCount = uint32_t(sizes.size());
    pool.pPoolSizes = sizes.data();
    pool_ = make<DescriptorPool>(device_->get(), vkCreateDescriptorPool, pool, "create a descriptor pool");
    const std::vector<VkDescriptorSetLayout> layouts(count, layout_.get());
    VkDescriptorSetAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocation.descriptorPool = pool_.get();
    allocation.descriptorSetCount = count;
    allocation.pSetLayouts = layouts.data();
    materialSets_.resize(count);
    check(vkAllocateDescriptorSets(device_->get(), &allocation, materialSets_.data()), "allocate descriptor sets");

    const VkDeviceSize alignment = std::max<VkDeviceSize>(device_->limits().minUniformBufferOffsetAlignment, 1);
    const VkDeviceSize stride = (sizeof(MaterialConstants) + alignment - 1) / alignment * alignment;
    std::vector<std::byte> constants(size_t(stride) * count);
    materialConstants_ =
        arena_.deviceBuffer(constants.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);

    for (uint32_t m = 0; m < count; ++m) {
        const Material& material = materials[m];
        const std::array<int, materialTextureCount> maps = materialTextures(scene, material);
        std::array<VkDescriptorImageInfo, materialTextureCount> images{};
        for (size_t i = 0; i < maps.size(); ++i) {
            const size_t texture = maps[i] >= 0 ? size_t(maps[i]) : scene.textures.size();
            images[i] = {sampler(samplings_[texture]), textures_[texture].view.get(),
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        }
        const MaterialConstants values = materialConstants(material);
        std::memcpy(&constants[size_t(stride) * m], &values, sizeof values);

        const VkDescriptorBufferInfo buffer{materialConstants_.buffer.get(), stride * m, sizeof(MaterialConstants)};
        std::array<VkWriteDescriptorSet, 2> writes{};
        for (VkWriteDescriptorSet& write : writes) {
            write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            write.dstSet = materialSets_[m];
        }
        writes[0].descriptorCount = materialTextureCount;
        writes[0].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        writes[0].pImageInfo = images.data();
        writes[1].dstBinding = materialConstantsBinding;
        writes[1].descriptorCount = 1;
        writes[1].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        writes[1].pBufferInfo = &buffer;
        vkUpdateDescriptorSets(device_->get(), uint32_t(writes.size()), writes.data(), 0, nullptr);
    }
    uploader.fill(materialConstants_, constants);
}

VkDescriptorSet GpuScene::materialSet(uint32_t material) const {
    return materialSets_[std::min(size_t(material), materialSets_.size() - 1)];
}

void GpuScene::bindGeometry(VkCommandBuffer commands) const {
    const VkBuffer vertices = vertices_.buffer.get();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
    vkCmdBindIndexBuffer(commands, indices_.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
}

VertexInput::VertexInput(uint32_t locations) {
    binding = {0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    attributes = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
                  {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
                  {2, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, tangent)},
                  {3, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv)},
                  {4, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(Vertex, color)}};
    std::erase_if(attributes, [locations](const auto& a) { return !(locations >> a.location & 1); });
    state.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    state.vertexBindingDescriptionCount = attributes.empty() ? 0 : 1;
    state.pVertexBindingDescriptions = &binding;
    state.vertexAttributeDescriptionCount = uint32_t(attributes.size());
    state.pVertexAttributeDescriptions = attributes.data();
}

} // namespace harness::vk
