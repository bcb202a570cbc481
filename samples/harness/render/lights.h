// The scene's lights in the SDK's terms.
#pragma once

#include "render/renderer.h"

#include <vector>

namespace harness {

// Returns the indices of the lights with a shadow map, in the order of the maps, up to the SDK's limit.
std::vector<size_t> shadowedLights(const std::vector<Light>& lights);

// Positions become relative to the eye in double precision.
std::vector<AgaaLight> toAgaaLights(const std::vector<Light>& lights, const glm::dvec3& worldOffset,
                                    const glm::dvec3& eye);

} // namespace harness
