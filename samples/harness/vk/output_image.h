// The image into which the SDK writes its result, and its read-back.
#pragma once

#include "vk/arena.h"

namespace harness::vk {

class OutputImage {
public:
    // Full precision, so that errors measure the SDK and not the image.
    static constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;

    OutputImage(const Device& device, uint32_t width, uint32_t height);

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    VkImage image() const { return target_.image.get(); }
    VkImageView view() const { return target_.view.get(); }

    // Fills the image, over which the SDK composites, and leaves it in GENERAL.
    void recordClear(VkCommandBuffer commands, const glm::vec3& color) const;
    // The image must be in TRANSFER_SRC_OPTIMAL and stays in it.
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
