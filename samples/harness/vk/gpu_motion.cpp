#include "vk/gpu_motion.h"

#include "render/host_material.h"

#include <cstring>
#include <stdexcept>

namespace harness::vk {

constexpr size_t rowsPerDraw = std::tuple_size_v<MotionRows>;

// The descriptor is valid before anything moves.
GpuMotion::GpuMotion(const Device& device, VkDescriptorSet set, uint32_t binding)
    : device_(&device), set_(set), binding_(binding), arena_(device) {
    reserve(1);
}

void GpuMotion::reserve(size_t draws) {
    if (draws <= capacity_)
        return;
    if (draws * rowsPerDraw > device_->limits().maxTexelBufferElements)
        throw std::runtime_error("The scene has more draws than the device's texel buffers hold.");
    texels_ = {};
    rows_ = {};
    arena_ = Arena(*device_);
    rows_ = arena_.hostBuffer(draws * sizeof(MotionRows), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = rows_.buffer.get();
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.range = draws * sizeof(MotionRows);
    texels_ = make<BufferView>(device_->get(), vkCreateBufferView, info, "create a buffer view");
    const VkBufferView view = texels_.get();
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set_;
    write.dstBinding = binding_;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    write.pTexelBufferView = &view;
    vkUpdateDescriptorSets(device_->get(), 1, &write, 0, nullptr);
    capacity_ = draws;
}

void GpuMotion::update(const std::vector<Draw>& draws) {
    if (draws.empty() || draws.front().motionOutput == MotionOutput::None)
        return;
    reserve(draws.size());
    const std::vector<MotionRows> rows = motionRows(draws);
    std::memcpy(rows_.mapped, rows.data(), rows.size() * sizeof(MotionRows));
}

} // namespace harness::vk
