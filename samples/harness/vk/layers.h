// Draws the layer over the anti-aliased image (render/layers.h).
#pragma once

#include "render/layers.h"
#include "vk/arena.h"
#include "vk/descriptor_set.h"
#include "vk/output_image.h"

namespace harness::vk {

class Layers {
public:
    // The images keep their sizes. The layer reads the resolved outputs in SHADER_READ_ONLY_OPTIMAL.
    Layers(const Device& device, const OutputImage& image, const OutputImage& meanDepth, const OutputImage& coverage);
    // The image is in COLOR_ATTACHMENT_OPTIMAL before and after.
    void draw(VkCommandBuffer commands, const LayerConstants& constants) const;

private:
    void makeRenderPass();
    void writeSet(VkImageView meanDepth, VkImageView coverage);

    const Device* device_;
    uint32_t width_, height_;
    Arena arena_;
    BufferResource constants_;
    Sampler sampler_;
    DescriptorSetLayout setLayout_;
    DescriptorSet set_;
    RenderPass renderPass_;
    Framebuffer framebuffer_;
    PipelineLayout layout_;
    Pipeline pipeline_;
};

} // namespace harness::vk
