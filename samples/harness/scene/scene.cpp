#include "scene/scene.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace harness {

namespace {

struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Returns the bounds of the points without outliers that are too far away for single precision. A stray vertex must not
// determine the camera, its depth range and the shadow maps.
Bounds boundsWithoutStrays(const std::vector<glm::dvec3>& points) {
    Bounds bounds;
    if (points.empty())
        return {glm::dvec3(0), glm::dvec3(0)};
    std::vector<double> values(points.size());
    glm::dvec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(points.begin(), points.end(), values.begin(), [&](const glm::dvec3& p) { return p[axis]; });
        middle[axis] = medianOf(values);
    }
    const auto distance = [&](const glm::dvec3& p) { return glm::length(p - middle); };
    std::transform(points.begin(), points.end(), values.begin(), distance);
    const double typical = medianOf(values);
    const double farthest = typical > 0 ? std::ldexp(typical, 24) : std::numeric_limits<double>::infinity();
    for (const glm::dvec3& p : points)
        if (distance(p) <= farthest)
            bounds.add(p);
    return bounds;
}

} // namespace

uint64_t Scene::placedTriangles() const {
    uint64_t triangles = 0;
    for (const Instance& instance : instances)
        triangles += meshes[instance.mesh].indexCount / 3;
    return triangles;
}

static std::vector<glm::dvec3> positionsOf(const Scene& scene, const Mesh& mesh) {
    std::vector<glm::dvec3> points;
    for (uint32_t i = 0; i < mesh.vertexCount; ++i)
        points.emplace_back(scene.vertices[mesh.firstVertex + i].position);
    return points;
}

static void updateMeshBounds(Mesh& mesh, const std::vector<glm::dvec3>& points) {
    Bounds all;
    for (const glm::dvec3& p : points)
        all.add(p);
    mesh.boundsMin = points.empty() ? glm::vec3(0) : glm::vec3(all.low);
    mesh.boundsMax = points.empty() ? glm::vec3(0) : glm::vec3(all.high);
}

void updateBounds(Scene& scene) {
    std::vector<Bounds> meshes;
    for (Mesh& mesh : scene.meshes) {
        const std::vector<glm::dvec3> points = positionsOf(scene, mesh);
        updateMeshBounds(mesh, points);
        meshes.push_back(boundsWithoutStrays(points));
    }
    std::vector<glm::dvec3> corners;
    for (const Instance& instance : scene.instances) {
        const Bounds& mesh = meshes[instance.mesh];
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p(corner & 1 ? mesh.high.x : mesh.low.x, corner & 2 ? mesh.high.y : mesh.low.y,
                               corner & 4 ? mesh.high.z : mesh.low.z);
            corners.emplace_back(instance.transform * glm::dvec4(p, 1.0));
        }
    }
    const Bounds bounds = boundsWithoutStrays(corners);
    scene.boundsMin = bounds.low;
    scene.boundsMax = bounds.high;
}

} // namespace harness
