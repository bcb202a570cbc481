// Vulkan equivalents of plan formats.
#pragma once

#include "core/base/format.h"
#include "vk/vulkan.h"

namespace agaa::vk {

inline VkFormat vkFormat(Format format) {
    switch (format) {
    case Format::D24S8:
        return VK_FORMAT_D24_UNORM_S8_UINT;
    case Format::D32S8:
        return VK_FORMAT_D32_SFLOAT_S8_UINT;
    case Format::D32:
        return VK_FORMAT_D32_SFLOAT;
    case Format::R8:
        return VK_FORMAT_R8_UNORM;
    case Format::RG8:
        return VK_FORMAT_R8G8_UNORM;
    case Format::RGBA8:
        return VK_FORMAT_R8G8B8A8_UNORM;
    case Format::R16:
        return VK_FORMAT_R16_UNORM;
    case Format::RG16:
        return VK_FORMAT_R16G16_UNORM;
    case Format::RGBA16:
        return VK_FORMAT_R16G16B16A16_UNORM;
    case Format::RGBA16F:
        return VK_FORMAT_R16G16B16A16_SFLOAT;
    case Format::RGB10A2:
        return VK_FORMAT_A2B10G10R10_UNORM_PACK32;
    case Format::R8U:
        return VK_FORMAT_R8_UINT;
    case Format::R16U:
        return VK_FORMAT_R16_UINT;
    case Format::R32U:
        return VK_FORMAT_R32_UINT;
    case Format::RG32U:
        return VK_FORMAT_R32G32_UINT;
    case Format::RGBA32U:
        return VK_FORMAT_R32G32B32A32_UINT;
    case Format::None:
    case Format::Buffer:
    case Format::RGB16:
        break;
    }
    return VK_FORMAT_UNDEFINED;
}

inline VkImageAspectFlags aspects(Format format) {
    if (!isDepth(format))
        return VK_IMAGE_ASPECT_COLOR_BIT;
    return VK_IMAGE_ASPECT_DEPTH_BIT | (hasStencil(format) ? VkImageAspectFlags(VK_IMAGE_ASPECT_STENCIL_BIT) : 0u);
}

} // namespace agaa::vk
