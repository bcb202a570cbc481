#include "vk/gpu_fetch.h"

#include "vk/gpu_environment.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace harness::vk {

// Bindings of shaders/fetch.glsl.
enum : uint32_t {
    CameraBinding,
    ColorBinding,
    ValueBinding,
    DrawBinding,
    MaterialBinding,
    VertexBinding,
    IndexBinding,
    SmallColorBinding,
    SmallValueBinding,
    BindingCount
};

static bool isTexels(uint32_t binding) { return binding >= DrawBinding && binding <= IndexBinding; }

GpuFetch::GpuFetch(const Device& device, const Scene& scene, const GpuScene& gpuScene)
    : device_(&device), arena_(device) {
    const FetchScene fetch = makeFetchScene(scene);
    glsl_ = fetchGlsl(fetch, false);
    Uploader uploader(device);
    textures_[0] = uploader.textureArray(arena_, fetch.colors.large, true);
    textures_[1] = uploader.textureArray(arena_, fetch.values.large, false);
    textures_[2] = uploader.textureArray(arena_, fetch.colors.small, true);
    textures_[3] = uploader.textureArray(arena_, fetch.values.small, false);
    camera_ = arena_.hostBuffer(sizeof(FetchCamera), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    constexpr VkBufferUsageFlags texelBuffer = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
    const auto materials = std::as_bytes(std::span(fetch.materials));
    const auto vertices = std::as_bytes(std::span(fetch.vertices));
    draws_ = arena_.hostBuffer(fetch.maxDraws * sizeof(FetchDraw), texelBuffer);
    materials_ = arena_.deviceBuffer(materials.size(), texelBuffer | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    vertices_ = arena_.deviceBuffer(vertices.size(), texelBuffer | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    uploader.fill(materials_, materials);
    uploader.fill(vertices_, vertices);
    drawTexels_ = texels(draws_.buffer.get(), fetch.maxDraws * sizeof(FetchDraw), VK_FORMAT_R32G32B32A32_UINT);
    materialTexels_ = texels(materials_.buffer.get(), materials.size(), VK_FORMAT_R32G32B32A32_UINT);
    vertexTexels_ = texels(vertices_.buffer.get(), vertices.size(), VK_FORMAT_R32G32B32A32_UINT);
    indexTexels_ = texels(gpuScene.indices().buffer.get(), std::max(scene.indices.size(), size_t(1)) * sizeof(uint32_t),
                          VK_FORMAT_R32_UINT);
    sampler_ = makeSampler(device, {});
    createSet();
    function_.glsl = glsl_.c_str();
    function_.maxDraws = fetch.maxDraws;
    function_.maxPrimitives = fetch.maxPrimitives;
    function_.maxTriangles = fetch.maxTriangles;
    function_.descriptorSetLayout = (uint64_t)layout_.get();
}

BufferView GpuFetch::texels(VkBuffer buffer, VkDeviceSize size, VkFormat format) const {
    const VkDeviceSize texel = format == VK_FORMAT_R32_UINT ? 4 : 16;
    if (size / texel > device_->limits().maxTexelBufferElements)
        throw std::runtime_error("The scene has more vertices, indices or draws than the device's texel buffers hold.");
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = buffer;
    info.format = format;
    info.range = size;
    return make<BufferView>(device_->get(), vkCreateBufferView, info, "create a buffer view");
}

void GpuFetch::createSet() {
    const auto type = [](uint32_t binding) {
        if (binding == CameraBinding)
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        return isTexels(binding) ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    };
    std::array<VkDescriptorSetLayoutBinding, BindingCount + 4> bindings{};
    for (uint32_t i = 0; i < BindingCount; ++i)
        bindings[i] = {i, type(i), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    // Functions of one view share a set.
    static_assert(environmentBinding == BindingCount);
    std::ranges::copy(environmentLayoutBindings(VK_SHADER_STAGE_COMPUTE_BIT), bindings.begin() + BindingCount);
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout.bindingCount = uint32_t(bindings.size());
    layout.pBindings = bindings.data();
    layout_ = make<DescriptorSetLayout>(device_->get(), vkCreateDescriptorSetLayout, layout,
                                        "create a descriptor set layout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 3},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, 4},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 6}};
    set_ = DescriptorSet(device_->get(), layout_.get(), sizes);

    const VkDescriptorBufferInfo camera{camera_.buffer.get(), 0, VK_WHOLE_SIZE};
    VkDescriptorImageInfo images[4];
    for (size_t i = 0; i < std::size(images); ++i)
        images[i] = {sampler_.get(), textures_[i].view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkBufferView views[] = {drawTexels_.get(), materialTexels_.get(), vertexTexels_.get(), indexTexels_.get()};
    std::array<VkWriteDescriptorSet, BindingCount + 4> writes{};
    for (uint32_t i = 0; i < writes.size(); ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set_.get();
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = bindings[i].descriptorType;
        writes[i].pBufferInfo = &camera; // Vulkan ignores members that the type does not use
        if (isTexels(i))
            writes[i].pTexelBufferView = &views[i - DrawBinding];
        else if (i >= environmentBinding) // any resource: lavapipe (Mesa 22.3) reads bindings that shaders do not use
            writes[i].pImageInfo = &images[0];
        else if (i != CameraBinding)
            writes[i].pImageInfo = &images[i < DrawBinding ? i - ColorBinding : 2 + i - SmallColorBinding];
    }
    vkUpdateDescriptorSets(device_->get(), uint32_t(writes.size()), writes.data(), 0, nullptr);
}

void GpuFetch::update(const Scene& scene, const std::vector<Draw>& draws, const FetchCamera& camera) {
    const std::vector<FetchDraw> rows = fetchDraws(scene, draws);
    std::memcpy(draws_.mapped, rows.data(), rows.size() * sizeof(FetchDraw));
    std::memcpy(camera_.mapped, &camera, sizeof camera);
}

} // namespace harness::vk
