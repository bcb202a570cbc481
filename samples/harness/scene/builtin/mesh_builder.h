// Shapes of the built-in scenes. Front faces are counter-clockwise and normals point outwards. Random numbers are drawn
// in a fixed order: in braced lists, whose order of evaluation is defined, and not in arguments of a call.
#pragma once

#include "scene/random.h"
#include "scene/scene.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace harness::builtin {

using Height = std::function<float(float x, float z)>;

// The geometry of one mesh in object space. u runs around or across a shape and v along it.
class MeshBuilder {
public:
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    glm::u8vec4 color{255}; // colour of the vertices that are added next

    size_t triangles() const { return indices.size() / 3; }

    // The normal is the direction of edgeU x edgeV. uv spans [0, 1] times uvScale.
    void quad(const glm::vec3& corner, const glm::vec3& edgeU, const glm::vec3& edgeV,
              const glm::vec2& uvScale = glm::vec2(1));
    // Adds a convex polygon. The corners are counter-clockwise around the normal.
    void polygon(std::span<const glm::vec3> corners, const glm::vec3& normal);
    // uv is in metres times uvPerMetre.
    void box(const glm::vec3& low, const glm::vec3& high, float uvPerMetre = 1);
    // Adds a smooth tube along a polyline with a radius per point. A radius of 0 makes a tip.
    void tube(std::span<const glm::vec3> points, std::span<const float> radii, int sides, bool capped);
    void tube(std::span<const glm::vec3> points, float radius, int sides, bool capped);
    void cylinder(const glm::vec3& bottom, const glm::vec3& top, float radius, int sides);
    void sphere(const glm::vec3& centre, float radius, int rings, int sides);
    // Adds a ribbon along a polyline with a width per point, for double-sided materials. It spreads along `across`,
    // which need not be unit or perpendicular. A last width of 0 makes a tip.
    void blade(std::span<const glm::vec3> points, std::span<const float> widths, const glm::vec3& across);
    // Adds a square of terrain around the origin. uv is in metres times uvPerMetre.
    void ground(float halfSize, int cells, const Height& height, float uvPerMetre = 1);

private:
    uint32_t add(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
    void triangle(uint32_t a, uint32_t b, uint32_t c);
    void cap(const glm::vec3& centre, const glm::vec3& normal, uint32_t firstRing, int sides, bool reversed);
};

// Converts a hexadecimal sRGB colour to linear.
glm::vec3 linearFromSrgb(uint32_t rgb);
uint8_t srgbByte(float linear);

Material& addMaterial(Scene& scene, std::string name, uint32_t srgbColor, float roughness, float metallic = 0);
// Returns the index of the material that was added last.
uint32_t lastMaterial(const Scene& scene);

// Adds a mesh, computes its tangents from its uv, and returns its index.
uint32_t addMesh(Scene& scene, const MeshBuilder& builder, uint32_t material);
void place(Scene& scene, uint32_t mesh, const glm::dmat4& transform = glm::dmat4(1));

// Returns the transform of a turn around y, a lean around x, a uniform size and a position. The rightmost factor
// applies first.
glm::dmat4 placement(const glm::dvec3& position, double turn, double scale = 1, double lean = 0);

// Returns a Catmull-Rom spline through the points: `steps` points per span, and the last point.
std::vector<glm::vec3> smoothCurve(std::span<const glm::vec3> points, int steps);
// Returns a direction that is uniform over the sphere.
glm::vec3 unitVector(Random& random);
// Returns smooth lattice noise in [0, 1] that repeats after `period` cells.
float tileableNoise(float x, float y, int period, uint32_t seed);

} // namespace harness::builtin
