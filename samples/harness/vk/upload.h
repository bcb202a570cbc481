// Copies vertices, indices, constants and textures to the device through a staging buffer.
#pragma once

#include "render/mip_chain.h"
#include "vk/arena.h"

#include <span>

namespace harness::vk {

class Uploader {
public:
    explicit Uploader(const Device& device);

    // The buffer needs VK_BUFFER_USAGE_TRANSFER_DST_BIT.
    void fill(const BufferResource& buffer, std::span<const std::byte> bytes);
    // Returns a sampled RGBA8 image in SHADER_READ_ONLY_OPTIMAL.
    ImageResource texture(Arena& arena, const std::vector<MipLevel>& levels, bool srgb);
    // Returns such an image of half floats; MipLevel::rgba holds 8 bytes per texel.
    ImageResource halfTexture(Arena& arena, const std::vector<MipLevel>& levels);
    // Returns such an image of two floats a texel, with layers of one size; MipLevel::rgba holds 8 bytes per texel.
    ImageResource momentArray(Arena& arena, const std::vector<std::vector<MipLevel>>& layers);
    // Returns an RGBA8 image with layers of one size, for compute shaders.
    ImageResource textureArray(Arena& arena, const std::vector<std::vector<MipLevel>>& layers, bool srgb);

private:
    const BufferResource& staging(VkDeviceSize size);
    ImageResource sampledImage(Arena& arena, const std::vector<const std::vector<MipLevel>*>& layers, VkFormat format,
                               VkImageViewType viewType);

    const Device* device_;
    Arena arena_;
    BufferResource staging_;
};

} // namespace harness::vk
