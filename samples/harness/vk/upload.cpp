#include "vk/upload.h"

#include "vk/barrier.h"

#include <algorithm>
#include <cstring>

namespace harness::vk {

namespace {

constexpr VkDeviceSize chunkSize = VkDeviceSize(16) << 20;

std::vector<const std::vector<MipLevel>*> pointersTo(const std::vector<std::vector<MipLevel>>& layers) {
    std::vector<const std::vector<MipLevel>*> pointers;
    for (const std::vector<MipLevel>& layer : layers)
        pointers.push_back(&layer);
    return pointers;
}

VkFormat rgba8(bool srgb) { return srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM; }

} // namespace

Uploader::Uploader(const Device& device) : device_(&device), arena_(device) {}

// Each copy is waited for, so all copies share one staging buffer. It grows to the size of the largest texture.
const BufferResource& Uploader::staging(VkDeviceSize size) {
    if (staging_.size < size) {
        staging_ = {};
        arena_ = Arena(*device_);
        staging_ = arena_.hostBuffer(std::max(size, chunkSize), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    }
    return staging_;
}

void Uploader::fill(const BufferResource& buffer, std::span<const std::byte> bytes) {
    const BufferResource& source = staging(1);
    for (size_t offset = 0; offset < bytes.size();) {
        const size_t size = std::min(bytes.size() - offset, size_t(source.size));
        std::memcpy(source.mapped, bytes.data() + offset, size);
        device_->runCommands([&](VkCommandBuffer commands) {
            const VkBufferCopy copy{0, offset, size};
            vkCmdCopyBuffer(commands, source.buffer.get(), buffer.buffer.get(), 1, &copy);
        });
        offset += size;
    }
}

ImageResource Uploader::texture(Arena& arena, const std::vector<MipLevel>& levels, bool srgb) {
    return sampledImage(arena, {&levels}, rgba8(srgb), VK_IMAGE_VIEW_TYPE_2D);
}

ImageResource Uploader::halfTexture(Arena& arena, const std::vector<MipLevel>& levels) {
    return sampledImage(arena, {&levels}, VK_FORMAT_R16G16B16A16_SFLOAT, VK_IMAGE_VIEW_TYPE_2D);
}

ImageResource Uploader::momentArray(Arena& arena, const std::vector<std::vector<MipLevel>>& layers) {
    return sampledImage(arena, pointersTo(layers), VK_FORMAT_R32G32_SFLOAT, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
}

ImageResource Uploader::textureArray(Arena& arena, const std::vector<std::vector<MipLevel>>& layers, bool srgb) {
    return sampledImage(arena, pointersTo(layers), rgba8(srgb), VK_IMAGE_VIEW_TYPE_2D_ARRAY);
}

ImageResource Uploader::sampledImage(Arena& arena, const std::vector<const std::vector<MipLevel>*>& layers,
                                     VkFormat format, VkImageViewType viewType) {
    const std::vector<MipLevel>& first = *layers.at(0);
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {first[0].width, first[0].height, 1};
    info.mipLevels = uint32_t(first.size());
    info.arrayLayers = uint32_t(layers.size());
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    ImageResource image = arena.image(info, viewType, VK_IMAGE_ASPECT_COLOR_BIT);

    constexpr ImageUse nothing{VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    constexpr ImageUse written{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    constexpr ImageUse sampled{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                               VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    device_->runCommands([&](VkCommandBuffer commands) {
        imageBarrier(commands, image.image.get(), VK_IMAGE_ASPECT_COLOR_BIT, nothing, written);
    });
    for (uint32_t layer = 0; layer < layers.size(); ++layer) {
        VkDeviceSize total = 0;
        for (const MipLevel& level : *layers[layer])
            total += level.rgba.size();
        const BufferResource& source = staging(total);
        std::vector<VkBufferImageCopy> copies;
        VkDeviceSize offset = 0;
        for (uint32_t i = 0; i < layers[layer]->size(); ++i) {
            const MipLevel& level = (*layers[layer])[i];
            std::memcpy(source.mapped + offset, level.rgba.data(), level.rgba.size());
            VkBufferImageCopy copy{};
            copy.bufferOffset = offset;
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, i, layer, 1};
            copy.imageExtent = {level.width, level.height, 1};
            copies.push_back(copy);
            offset += level.rgba.size();
        }
        device_->runCommands([&](VkCommandBuffer commands) {
            vkCmdCopyBufferToImage(commands, source.buffer.get(), image.image.get(),
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, uint32_t(copies.size()), copies.data());
        });
    }
    device_->runCommands([&](VkCommandBuffer commands) {
        imageBarrier(commands, image.image.get(), VK_IMAGE_ASPECT_COLOR_BIT, written, sampled);
    });
    return image;
}

} // namespace harness::vk
