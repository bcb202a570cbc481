// The image that the SDK writes its result into, and its way back to the host.
#pragma once

#include "vk/arena.h"

namespace harness::vk {

class OutputImage {
public:
    OutputImage(const Device& device, uint32_t width, uint32_t height);

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    VkImage image() const { return target_.image.get(); }
    VkImageView view() const { return target_.view.get(); }

    // Fills it and leaves it in GENERAL: what the SDK composites over.
    void recordClear(VkCommandBuffer commands, const glm::vec3& color) const;
    // The image must be in TRANSFER_SRC_OPTIMAL, and is left there.
    Image read() const;

private:
    const Device* device_;
    uint32_t width_;
    uint32_t height_;
    Arena arena_;
    ImageResource target_;
    BufferResource readback_;
};

} // namespace harness::vk
