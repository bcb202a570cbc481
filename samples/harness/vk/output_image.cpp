#include "vk/output_image.h"

#include "vk/barrier.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace harness::vk {

namespace {

constexpr size_t channels = 4;

} // namespace

OutputImage::OutputImage(const Device& device, uint32_t width, uint32_t height)
    : device_(&device), width_(width), height_(height), arena_(device) {
    if (width == 0 || height == 0 || std::max(width, height) > device.limits().maxImageDimension2D)
        throw std::runtime_error("The device \"" + device.name() + "\" has no images of " + std::to_string(width) +
                                 "x" + std::to_string(height) + " pixels.");
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    target_ = arena_.image(info, VK_IMAGE_VIEW_TYPE_2D, VK_IMAGE_ASPECT_COLOR_BIT);
    readback_ = arena_.hostBuffer(VkDeviceSize(width) * height * channels * sizeof(float),
                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT, true);
}

void OutputImage::recordClear(VkCommandBuffer commands, const glm::vec3& color) const {
    constexpr ImageUse nothing{VK_PIPELINE_STAGE_TRANSFER_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    constexpr ImageUse cleared{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    constexpr ImageUse general{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                               VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
    imageBarrier(commands, image(), VK_IMAGE_ASPECT_COLOR_BIT, nothing, cleared);
    const VkClearColorValue value{{color.r, color.g, color.b, 1}};
    const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, image(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &range);
    imageBarrier(commands, image(), VK_IMAGE_ASPECT_COLOR_BIT, cleared, general);
}

Image OutputImage::read() const {
    device_->runCommands([this](VkCommandBuffer commands) {
        VkBufferImageCopy copy{};
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.imageExtent = {width_, height_, 1};
        vkCmdCopyImageToBuffer(commands, image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback_.buffer.get(), 1,
                               &copy);
        VkMemoryBarrier toHost{};
        toHost.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        toHost.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &toHost, 0,
                             nullptr, 0, nullptr);
    });
    Image result;
    result.width = width_;
    result.height = height_;
    result.rgb.resize(result.pixelCount() * 3);
    for (size_t i = 0; i < result.pixelCount(); ++i)
        std::memcpy(&result.rgb[i * 3], readback_.mapped + i * channels * sizeof(float), 3 * sizeof(float));
    return result;
}

} // namespace harness::vk
