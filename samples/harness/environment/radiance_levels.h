// Radiance that lobes of growing roughness reflect: the first sum of the split-sum approximation (Karis 2013, "Real
// Shading in Unreal Engine 4"). Each level is the image convolved with a GGX lobe around the mirrored direction, seen
// along the normal.
#pragma once

#include "environment/sphere_image.h"

namespace harness {

// Levels are mip levels of one texture: each has half the width and height of the level before. Rows 0 and height - 1
// are the poles, so that interpolation has no seam there: row y has the colatitude pi y / (height - 1).
struct RadianceLevel {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> texels;

    glm::dvec3 directionOf(uint32_t x, uint32_t y) const;
};

constexpr uint32_t radianceLevelCount = 7; // from 1024 x 512 to 16 x 8
constexpr uint32_t radianceWidth = 1024;

// Returns GGX alpha of a level: roughness grows by equal steps, and alpha is its square. Level 0 is a mirror.
double alphaOfLevel(uint32_t level);

// Returns the levels, in which all texels are finite.
std::vector<RadianceLevel> makeRadianceLevels(const SphereImage& image, uint32_t width = radianceWidth);

} // namespace harness
