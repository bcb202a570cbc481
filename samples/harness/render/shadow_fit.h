// The projection of a light's shadow map. It is fitted to the camera without jitter, so that all frames of a view have
// the same map.
#pragma once

#include "render/camera_matrices.h"

#include <vector>

namespace harness {

struct ShadowFit {
    std::vector<glm::dmat4> layers; // shading space to clip space, z in [0, w], y in the direction of the map's rows
    double depthBias = 0;           // bias in units of the map's depth
};

ShadowFit fitShadow(const Light& light, const Scene& scene, const CameraMatrices& camera, const glm::dvec3& worldOffset,
                    uint32_t mapSize);

AgaaShadow toAgaaShadow(const ShadowFit& fit);

// Returns a key of all inputs of the maps: equal keys give equal maps.
//
// placement   Of the instances: equal numbers mean equal transforms.
std::vector<double> shadowKey(const std::vector<Light>& lights, const glm::dvec3& worldOffset,
                              const CameraMatrices& camera, uint64_t placement);

} // namespace harness
