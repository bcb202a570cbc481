// The SDK's surfaces on the CPU. They must be in the layout in which shaders read them.
#pragma once

#include "core/plan/plan.h"
#include "vk/device.h"

#include <glm/glm.hpp>

#include <vector>

namespace agaa::test {

// Rows of texels, of each its samples in order; floats as their bits.
std::vector<glm::uvec4> readTexels(const harness::vk::Device& device, const Resource& resource, VkImageView view);
// Of an image with AGAA_CONFIG_READBACK: its words, layer by layer.
std::vector<uint32_t> readImage(const harness::vk::Device& device, const Resource& resource, VkImage image);
std::vector<uint32_t> readWords(const harness::vk::Device& device, VkBuffer buffer, uint64_t bytes);

} // namespace agaa::test
