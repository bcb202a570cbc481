#include "vk/gpu_motion.h"

#include "render/host_material.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace harness::vk {

GpuMotion::GpuMotion(const Device& device, size_t maxDraws) : device_(&device), arena_(device) {
    const size_t draws = std::max(maxDraws, size_t(1));
    if (draws * std::tuple_size_v < MotionRows >> device.limits().maxTexelBufferElements)
        throw std::runtime_error("The scene has more draws than the device's texel buffers hold.");
    rows_ = arena_.hostBuffer(draws * sizeof(MotionRows), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = rows_.buffer.get();
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.range = draws * sizeof(MotionRows);
    texels_ = make<BufferView>(device.get(), vkCreateBufferView, info, "create a buffer view");
}

void GpuMotion::write(VkDescriptorSet set, uint32_t binding) const {
    const VkBufferView view = texels_.get();
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    write.pTexelBufferView = &view;
    vkUpdateDescriptorSets(device_->get(), 1, &write, 0, nullptr);
}

void GpuMotion::update(const std::vector<Draw>& draws) {
    if (draws.empty() || draws.front().motionOutput == MotionOutput::None)
        return;
    const std::vector<MotionRows> rows = motionRows(draws);
    std::memcpy(rows_.mapped, rows.data(), rows.size() * sizeof(MotionRows));
}

} // namespace harness::vk
