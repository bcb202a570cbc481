// Where a light's shadow map looks, fitted to the camera without its jitter, so that all frames of
// one view see the same map.
#pragma once

#include "render/camera_matrices.h"

#include <vector>

namespace harness {

struct ShadowFit {
    std::vector<glm::dmat4> layers; // shading space to clip space, z in [0,w], y as the map's rows
    double depthBias = 0;           // in the map's depth
};

ShadowFit fitShadow(const Light& light, const Scene& scene, const CameraMatrices& camera,
                    const glm::dvec3& worldOffset, uint32_t mapSize);

AgaaShadow toAgaaShadow(const ShadowFit& fit);

// What the maps of a scene depend on: equal keys, equal maps.
std::vector<double> shadowKey(const std::vector<Light>& lights, const glm::dvec3& worldOffset,
                              const CameraMatrices& camera);

} // namespace harness
