// Shapes that the built-in scenes are put together from. Front faces are counter-clockwise and
// normals point outwards. Functions that draw random numbers take them in one fixed order: the
// order of a call's arguments is the compiler's choice, that of a braced list is not.
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
    glm::u8vec4 color{255}; // of the vertices added from now on

    size_t triangles() const { return indices.size() / 3; }

    // normal is the direction of edgeU x edgeV; uv spans [0;1] times uvScale.
    void quad(const glm::vec3& corner, const glm::vec3& edgeU, const glm::vec3& edgeV,
              const glm::vec2& uvScale = glm::vec2(1));
    // A convex polygon's corners, counter-clockwise around the normal.
    void polygon(std::span<const glm::vec3> corners, const glm::vec3& normal);
    // uv counts metres times uvPerMetre.
    void box(const glm::vec3& low, const glm::vec3& high, float uvPerMetre = 1);
    // A smooth tube along a polyline with a radius per point; a radius of 0 makes a tip.
    void tube(std::span<const glm::vec3> points, std::span<const float> radii, int sides,
              bool capped);
    void tube(std::span<const glm::vec3> points, float radius, int sides, bool capped);
    void cylinder(const glm::vec3& bottom, const glm::vec3& top, float radius, int sides);
    void sphere(const glm::vec3& centre, float radius, int rings, int sides);
    // A ribbon along a polyline with a width per point, spread along `across` (need not be unit or
    // perpendicular). A last width of 0 makes a tip. For double-sided materials.
    void blade(std::span<const glm::vec3> points, std::span<const float> widths,
               const glm::vec3& across);
    // A square of terrain around the origin, uv in metres times uvPerMetre.
    void ground(float halfSize, int cells, const Height& height, float uvPerMetre = 1);

private:
    uint32_t add(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
    void triangle(uint32_t a, uint32_t b, uint32_t c);
    void cap(const glm::vec3& centre, const glm::vec3& normal, uint32_t firstRing, int sides,
             bool reversed);
};

// Hexadecimal sRGB, as colour pickers show it, to linear.
glm::vec3 linearFromSrgb(uint32_t rgb);
uint8_t srgbByte(float linear);

Material& addMaterial(Scene& scene, std::string name, uint32_t srgbColor, float roughness,
                      float metallic = 0);
// The index of the material added last.
uint32_t lastMaterial(const Scene& scene);

// The index of a new mesh, its tangents made from its uv.
uint32_t addMesh(Scene& scene, const MeshBuilder& builder, uint32_t material);
void place(Scene& scene, uint32_t mesh, const glm::dmat4& transform = glm::dmat4(1));

// A turn around y, a lean around x, a uniform size and a position; the order reads from right.
glm::dmat4 placement(const glm::dvec3& position, double turn, double scale = 1, double lean = 0);

// A Catmull-Rom spline through points, `steps` points per span and the last point.
std::vector<glm::vec3> smoothCurve(std::span<const glm::vec3> points, int steps);
// Uniform over the sphere.
glm::vec3 unitVector(Random& random);
// Smooth lattice noise in [0;1] that repeats after `period` cells.
float tileableNoise(float x, float y, int period, uint32_t seed);

} // namespace harness::builtin
