// Radiance by direction, in an image of longitude and latitude. The top row is up (+y), the middle of the image is the
// direction -z, and +x is to the right of it. Rows of this class are bands of equal height in latitude; the levels that
// shaders read have other rows (radiance_levels.h).
#pragma once

#include "image/image.h"

#include <glm/glm.hpp>

#include <vector>

namespace harness {

// Returns the place of a unit vector in an image, in [0, 1].
glm::vec2 spherePlace(const glm::vec3& direction);

struct SphereImage {
    uint32_t width = 0; // twice the height
    uint32_t height = 0;
    std::vector<glm::vec3> texels; // rows from top to bottom

    glm::vec3& at(uint32_t x, uint32_t y) { return texels[size_t(y) * width + x]; }
    const glm::vec3& at(uint32_t x, uint32_t y) const { return texels[size_t(y) * width + x]; }
    // Returns the unit vector to the middle of a texel.
    glm::vec3 directionOf(uint32_t x, uint32_t y) const;
    // Returns the solid angle of each texel of a row.
    double solidAngle(uint32_t y) const;
    // Returns the radiance from a unit vector, interpolated across the poles and the back, too.
    glm::vec3 lookup(const glm::vec3& direction) const { return lookup(spherePlace(direction)); }
    // Returns the radiance at a place of the image: x in [-1, 2), which repeats, and y in [0, 1].
    glm::vec3 lookup(const glm::vec2& place) const;
};

// Returns the unit vector at a longitude and a colatitude, which is 0 at the upper pole.
glm::dvec3 sphereDirection(double longitude, double colatitude);

// Returns the image between 128 and maxWidth wide. Its width is a power of two; texels are means over solid angle.
// Values that are not finite, or below 0, count as 0. Those above 1e9 are clamped, so that no sum overflows. `replaced`
// receives the number of such values.
SphereImage makeSphereImage(const Image& image, uint32_t maxWidth, uint64_t& replaced);

// Returns the image at half the size. The width must be at least 4.
SphereImage halved(const SphereImage& image);

} // namespace harness
