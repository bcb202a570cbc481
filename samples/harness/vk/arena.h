// Device memory in large blocks that are freed together, and the buffers and images in it.
#pragma once

#include "vk/device.h"

#include <cstddef>
#include <vector>

namespace harness::vk {

struct BufferResource {
    Buffer buffer;
    VkDeviceSize size = 0;
    std::byte* mapped = nullptr; // address of a host-visible buffer
};

struct ImageResource {
    ImageHandle image;
    ImageView view;
};

class Arena {
public:
    explicit Arena(const Device& device) : device_(&device) {}

    BufferResource deviceBuffer(VkDeviceSize size, VkBufferUsageFlags usage);
    // Creates a host-visible, coherent buffer. isRead: the host reads it, so cached memory is preferred.
    BufferResource hostBuffer(VkDeviceSize size, VkBufferUsageFlags usage, bool isRead = false);
    // The view covers all levels and layers.
    ImageResource image(const VkImageCreateInfo& info, VkImageViewType viewType, VkImageAspectFlags aspect);

private:
    struct Block {
        DeviceMemory memory;
        uint32_t type = 0;
        bool isImages = false; // separate from buffers, because of the device's granularity
        VkDeviceSize size = 0;
        VkDeviceSize used = 0;
        std::byte* mapped = nullptr;
    };
    struct Allocation {
        VkDeviceMemory memory;
        VkDeviceSize offset;
        std::byte* mapped;
    };
    Allocation allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted,
                        VkMemoryPropertyFlags preferred, bool isImage);
    uint32_t memoryType(uint32_t allowed, VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred) const;
    BufferResource buffer(VkDeviceSize size, VkBufferUsageFlags usage, VkMemoryPropertyFlags wanted,
                          VkMemoryPropertyFlags preferred);

    const Device* device_;
    std::vector<Block> blocks_;
};

} // namespace harness::vk
