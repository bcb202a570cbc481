// What the tests of all scenes ask.
#pragma once

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scene_test {

inline const harness::Vertex& cornerOf(const harness::Scene& scene, const harness::Mesh& mesh, uint32_t i) {
    return scene.vertices[mesh.firstVertex + scene.indices[mesh.firstIndex + i]];
}

// Ranges, indices and bounds fit together; vertices are finite, their frames unit and orthogonal.
inline void expectWellFormed(const harness::Scene& scene, bool checkTangents = true) {
    using namespace harness;
    for (const Vertex& v : scene.vertices) {
        for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(v.position[c]));
        ASSERT_TRUE(std::isfinite(v.uv.x) && std::isfinite(v.uv.y));
        ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
        if (!checkTangents)
            continue;
        ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-3);
        ASSERT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0, 2e-3);
        ASSERT_EQ(std::fabs(v.tangent.w), 1);
    }
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.indexCount % 3, 0u);
        ASSERT_LE(uint64_t(mesh.firstIndex) + mesh.indexCount, scene.indices.size());
        ASSERT_LE(uint64_t(mesh.firstVertex) + mesh.vertexCount, scene.vertices.size());
        ASSERT_LT(mesh.material, scene.materials.size());
        for (uint32_t i = 0; i < mesh.indexCount; ++i)
            ASSERT_LT(scene.indices[mesh.firstIndex + i], mesh.vertexCount);
    }
    for (const Instance& instance : scene.instances) {
        ASSERT_LT(instance.mesh, scene.meshes.size());
        const double determinant = glm::determinant(glm::dmat3(instance.transform));
        ASSERT_TRUE(std::isfinite(determinant));
    }
    for (const Material& material : scene.materials)
        for (const int texture :
             {material.baseColorTexture, material.normalTexture, material.metalRoughTexture, material.emissiveTexture})
            ASSERT_LT(texture, int(scene.textures.size()));
    for (const Texture& texture : scene.textures)
        ASSERT_EQ(texture.rgba.size(), size_t(4) * texture.width * texture.height);
    for (int c = 0; c < 3; ++c)
        ASSERT_LE(scene.boundsMin[c], scene.boundsMax[c]);
}

inline bool inside(const harness::Scene& scene, const glm::dvec3& p) {
    return glm::all(glm::lessThanEqual(scene.boundsMin, p)) && glm::all(glm::lessThanEqual(p, scene.boundsMax));
}

// Share of the placed triangles' first corners that lie in a 16:9 view.
inline double shareInView(const harness::Scene& scene, const harness::Camera& camera) {
    using namespace harness;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double tangent = std::tan(glm::radians(camera.fovDegrees) / 2);
    uint64_t seen = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (uint32_t i = 0; i < mesh.indexCount; i += 3) {
            const glm::vec3& position = cornerOf(scene, mesh, i).position;
            const glm::dvec3 q = glm::dvec3(instance.transform * glm::dvec4(position, 1)) - camera.eye;
            const double depth = glm::dot(q, forward);
            seen += depth > 0 && std::abs(glm::dot(q, up)) < tangent * depth &&
                    std::abs(glm::dot(q, right)) < tangent * depth * 16 / 9;
        }
    }
    return scene.placedTriangles() ? double(seen) / double(scene.placedTriangles()) : 0;
}

} // namespace scene_test
