#include "vk/arena.h"

#include <algorithm>
#include <stdexcept>

namespace harness::vk {

namespace {

constexpr VkDeviceSize blockSize = VkDeviceSize(32) << 20;

VkDeviceSize alignUp(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

} // namespace

uint32_t Arena::memoryType(uint32_t allowed, VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred) const {
    const VkPhysicalDeviceMemoryProperties& memory = device_->memory();
    for (const VkMemoryPropertyFlags flags : {wanted | preferred, wanted}) {
        for (uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            if ((allowed >> i & 1) && (memory.memoryTypes[i].propertyFlags & flags) == flags)
                return i;
        }
    }
    throw std::runtime_error("The device \"" + device_->name() + "\" has no fitting memory type.");
}

Arena::Allocation Arena::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted,
                                  VkMemoryPropertyFlags preferred, bool isImage) {
    const uint32_t type = memoryType(requirements.memoryTypeBits, wanted, preferred);
    for (Block& block : blocks_) {
        const VkDeviceSize offset = alignUp(block.used, requirements.alignment);
        if (block.type == type && block.isImages == isImage && offset + requirements.size <= block.size) {
            block.used = offset + requirements.size;
            return {block.memory.get(), offset, block.mapped ? block.mapped + offset : nullptr};
        }
    }

    Block block;
    block.type = type;
    block.isImages = isImage;
    // Blocks double up to the full size, so that small arenas stay small.
    const VkDeviceSize next = std::min(blockSize, (VkDeviceSize(1) << 20) << blocks_.size());
    block.size = std::max(requirements.size, next);
    block.used = requirements.size;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = block.size;
    info.memoryTypeIndex = type;
    block.memory = make<DeviceMemory>(device_->get(), vkAllocateMemory, info, "allocate memory");
    if (wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) {
        void* mapped = nullptr;
        check(vkMapMemory(device_->get(), block.memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "map memory");
        block.mapped = static_cast<std::byte*>(mapped);
    }
    blocks_.push_back(std::move(block));
    return {blocks_.back().memory.get(), 0, blocks_.back().mapped};
}

BufferResource Arena::buffer(VkDeviceSize size, VkBufferUsageFlags usage, VkMemoryPropertyFlags wanted,
                             VkMemoryPropertyFlags preferred) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    BufferResource result;
    result.size = size;
    result.buffer = make<Buffer>(device_->get(), vkCreateBuffer, info, "create a buffer");
    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(device_->get(), result.buffer.get(), &requirements);
    const Allocation allocation = allocate(requirements, wanted, preferred, false);
    check(vkBindBufferMemory(device_->get(), result.buffer.get(), allocation.memory, allocation.offset),
          "bind a buffer's memory");
    result.mapped = allocation.mapped;
    return result;
}

BufferResource Arena::deviceBuffer(VkDeviceSize size, VkBufferUsageFlags usage) {
    return buffer(size, usage, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0);
}

BufferResource Arena::hostBuffer(VkDeviceSize size, VkBufferUsageFlags usage, bool isRead) {
    return buffer(size, usage, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                  isRead ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : 0);
}

ImageResource Arena::image(const VkImageCreateInfo& info, VkImageViewType viewType, VkImageAspectFlags aspect) {
    ImageResource result;
    result.image = make<ImageHandle>(device_->get(), vkCreateImage, info, "create an image");
    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device_->get(), result.image.get(), &requirements);
    const Allocation allocation = allocate(requirements, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0, true);
    check(vkBindImageMemory(device_->get(), result.image.get(), allocation.memory, allocation.offset),
          "bind an image's memory");
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = result.image.get();
    view.viewType = viewType;
    view.format = info.format;
    view.subresourceRange = {aspect, 0, info.mipLevels, 0, info.arrayLayers};
    result.view = make<ImageView>(device_->get(), vkCreateImageView, view, "create an image view");
    return result;
}

} // namespace harness::vk
