// The surfaces of plans, which hosts read back.
#pragma once

#include "core/plan/plan.h"

#include <string>
#include <vector>

namespace agaa::test {

// Throws where the plan has none of this name.
ResourceId findResource(const Plan& plan, const std::string& name);
// Index of sample i of a pixel in a surface that was read texel by texel, sample by sample.
size_t sampleIndex(const Plan& plan, uint32_t x, uint32_t y, uint32_t i);
// GLSL after the version: a compute shader in groups of 8 x 8 that writes what the sampler at binding 0 holds, floats
// as their bits, into the buffer at binding 1.
std::string surfaceText(const Resource& resource);
// Words of an image of four whole numbers a texel, from layer by layer to pixel by pixel.
std::vector<uint32_t> byPixels(const Resource& resource, const std::vector<uint32_t>& layers);

} // namespace agaa::test
