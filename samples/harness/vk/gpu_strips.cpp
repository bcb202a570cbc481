#include "vk/gpu_strips.h"

#include "render/strip_indices.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>

namespace harness::vk {

static BufferView words(const Device& device, const BufferResource& buffer, size_t bytes) {
    if (bytes / 4 > device.limits().maxTexelBufferElements)
        throw std::runtime_error("The scene has more vertices or indices than the device's texel buffers hold.");
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = buffer.buffer.get();
    info.format = VK_FORMAT_R32_UINT;
    info.range = VK_WHOLE_SIZE;
    return make<BufferView>(device.get(), vkCreateBufferView, info, "create a buffer view");
}

GpuStrips::GpuStrips(const Device& device, const Scene& scene, const GpuScene& gpuScene) : arena_(device) {
    const std::vector<uint32_t> indices = stripIndices();
    const auto bytes = std::as_bytes(std::span(indices));
    indices_ = arena_.deviceBuffer(bytes.size(), VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    Uploader(device).fill(indices_, bytes);
    texels_[0] = words(device, gpuScene.vertices(), scene.vertices.size() * sizeof(Vertex));
    texels_[1] = words(device, gpuScene.indices(), scene.indices.size() * sizeof(uint32_t));

    VkDescriptorSetLayoutBinding bindings[2]{};
    for (uint32_t i = 0; i < std::size(bindings); ++i)
        bindings[i] = {i, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout.bindingCount = uint32_t(std::size(bindings));
    layout.pBindings = bindings;
    layout_ =
        make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, layout, "create a descriptor set layout");
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, uint32_t(std::size(bindings))};
    set_ = DescriptorSet(device.get(), layout_.get(), {&size, 1});
    const VkBufferView views[] = {texels_[0].get(), texels_[1].get()};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set_.get();
    write.descriptorCount = uint32_t(std::size(views)); // bindings from 0 on
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    write.pTexelBufferView = views;
    vkUpdateDescriptorSets(device.get(), 1, &write, 0, nullptr);
}

void GpuStrips::bind(VkCommandBuffer commands, VkPipelineLayout layout, uint32_t setIndex) const {
    const VkDescriptorSet set = set_.get();
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, setIndex, 1, &set, 0, nullptr);
    vkCmdBindIndexBuffer(commands, indices_.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
}

void GpuStrips::draw(VkCommandBuffer commands, const Mesh& mesh) const {
    const uint32_t triangles = mesh.indexCount / 3;
    for (uint32_t first = 0; first < triangles; first += stripsPerDraw)
        vkCmdDrawIndexed(commands, stripIndexCount * std::min(triangles - first, stripsPerDraw), 1, 0,
                         int32_t(stripVertices * first), 0);
}

} // namespace harness::vk
