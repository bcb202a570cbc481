// Triangles whose attributes are constant and known, so that a test can say what every sample holds.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <random>
#include <vector>

namespace agaa::test {

// As the host's shader reads it (std430).
struct Material {
    glm::vec4 diffuse{0.5f, 0.5f, 0.5f, 1.0f}; // w: alpha of masked triangles
    glm::vec4 specular{0.04f};                 // w: unused
    glm::vec4 emissive{0};
    glm::vec4 normal{0, 0, 1, 0.5f}; // shading normal, w: alpha2
    glm::vec4 geometricNormal{0, 0, 1, 0};
};

struct Triangle {
    glm::vec3 position[3]{}; // shading space
    glm::vec2 uv[3]{};
    Material material;
    bool isMasked = false;
    uint32_t seed = 0; // of the alpha mask; 0: the triangle's place in the list
};

// The plane's unit normal, turned to the eye at the origin.
glm::vec3 planeNormal(const Triangle& triangle);

// A camera at the origin looking down -z with this projection; the y axis of clip space points down.
glm::mat4 perspective(float fovYDegrees, float aspect, float near, float far);
glm::mat4 reversedInfinite(float fovYDegrees, float aspect, float near);
// Pixels of a width x height view as units, z in [0, depth] in front of the eye.
glm::mat4 pixelOrthographic(float width, float height, float depth);

struct RandomScene {
    uint32_t triangles = 300;
    float duplicates = 0; // share of triangles that repeat an earlier one's positions
    float masked = 0;     // share of alpha-masked triangles
};
// Triangles of all sizes in view of perspective(60, 3/2, ...), between 1 and 20 units away.
std::vector<Triangle> randomTriangles(const RandomScene& scene, uint32_t seed);

// A material whose channels lie so far from the rounding steps of every layout in use that GPU and CPU
// cannot round differently.
Material randomMaterial(std::mt19937& random);

// A rectangle in pixels at a depth, for pixelOrthographic.
std::vector<Triangle> rectangle(float x0, float y0, float x1, float y1, float depth, const Material& material);

} // namespace agaa::test
