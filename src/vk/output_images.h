// The images of the host that a frame writes, by Resource::hostSlot.
#pragma once

#include "agaa_vk.h"
#include "core/plan/plan.h"
#include "vk/device_table.h"

#include <array>

namespace agaa::vk {

struct OutputImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout layoutIn = VK_IMAGE_LAYOUT_UNDEFINED, layoutOut = VK_IMAGE_LAYOUT_GENERAL;
};
using OutputImages = std::array<OutputImage, 1 + AGAA_MAX_RESOLVED_OUTPUTS>;

// Returns the images of a frame that shades. Throws Error if one that the plan writes is missing or not valid.
OutputImages outputImages(const Plan& plan, const AgaaFrame& frame, const AgaaVkFrame& vkFrame);

} // namespace agaa::vk
