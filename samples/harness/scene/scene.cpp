#include "scene/scene.h"

#include <glm/gtc/type_ptr.hpp>

#include <limits>

namespace harness {

uint64_t Scene::placedTriangles() const {
    uint64_t triangles = 0;
    for (const Instance& instance : instances)
        triangles += meshes[instance.mesh].indexCount / 3;
    return triangles;
}

static void updateMeshBounds(const Scene& scene, Mesh& mesh) {
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (uint32_t i = 0; i < mesh.vertexCount; ++i) {
        low = glm::min(low, scene.vertices[mesh.firstVertex + i].position);
        high = glm::max(high, scene.vertices[mesh.firstVertex + i].position);
    }
    mesh.boundsMin = mesh.vertexCount ? low : glm::vec3(0);
    mesh.boundsMax = mesh.vertexCount ? high : glm::vec3(0);
}

void updateBounds(Scene& scene) {
    for (Mesh& mesh : scene.meshes)
        updateMeshBounds(scene, mesh);
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p(corner & 1 ? mesh.boundsMax.x : mesh.boundsMin.x,
                               corner & 2 ? mesh.boundsMax.y : mesh.boundsMin.y,
                               corner & 4 ? mesh.boundsMax.z : mesh.boundsMin.z);
            const glm::dvec3 world(instance.transform * glm::dvec4(p, 1.0));
            low = glm::min(low, world);
            high = glm::max(high, world);
        }
    }
    scene.boundsMin = scene.instances.empty() ? glm::dvec3(0) : low;
    scene.boundsMax = scene.instances.empty() ? glm::dvec3(0) : high;
}

} // namespace harness
