#include "render/shadow_fit.h"

#include "render/lights.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace harness {

namespace {

// The bias avoids self-shadowing within half a texel of the map and the width of a tap.
constexpr double biasTexels = 1.5;

struct Axes {
    glm::dvec3 right, up, forward;
};

Axes axesAlong(const glm::dvec3& direction) {
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 hint = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, hint));
    return {right, glm::cross(right, forward), forward};
}

glm::dmat4 fromRows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
    return glm::transpose(glm::dmat4(x, y, z, w));
}

struct Sphere {
    glm::dvec3 center;
    double radius;
};

// Returns the whole scene, or the part around the camera's target if the scene is much larger.
Sphere directionalFocus(const Scene& scene, const CameraMatrices& camera, const glm::dvec3& worldOffset) {
    const glm::dvec3 center = (scene.boundsMin + scene.boundsMax) / 2.0 + worldOffset;
    const double whole = std::max(glm::length(scene.boundsMax - scene.boundsMin) / 2, 1e-6);
    // A camera's target may be an arbitrary point close in front of it.
    const double wanted = std::max(2.5 * camera.targetDistance, whole / 10);
    if (whole <= wanted)
        return {center, whole};
    return {camera.eye + camera.forward * (0.8 * wanted), wanted};
}

ShadowFit fitDirectional(const Light& light, const Scene& scene, const CameraMatrices& camera,
                         const glm::dvec3& worldOffset, uint32_t mapSize) {
    const Axes axes = axesAlong(light.direction);
    Sphere focus = directionalFocus(scene, camera, worldOffset);
    focus.radius *= 1.0 + 4.0 / mapSize; // margin for the snap below and the taps at the border

    // Moving by whole texels against the scene keeps the shadows of a moving camera still.
    const double texel = 2 * focus.radius / mapSize;
    const glm::dvec3 anchor = scene.boundsMin + worldOffset;
    const auto snap = [&](const glm::dvec3& axis) {
        return std::round(glm::dot(focus.center - anchor, axis) / texel) * texel + glm::dot(anchor - camera.eye, axis);
    };
    const double x = snap(axes.right);
    const double y = snap(axes.up);

    // Casters between the light and the focus are included at any distance.
    double zMin = std::numeric_limits<double>::infinity();
    double zMax = -zMin;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) ? scene.boundsMax.x : scene.boundsMin.x,
                           (corner & 2) ? scene.boundsMax.y : scene.boundsMin.y,
                           (corner & 4) ? scene.boundsMax.z : scene.boundsMin.z);
        const double z = glm::dot(p + worldOffset - camera.eye, axes.forward);
        zMin = std::min(zMin, z);
        zMax = std::max(zMax, z);
    }
    zMin -= 2 * texel;
    zMax += 2 * texel;
    const double depth = zMax - zMin;

    ShadowFit fit;
    fit.layers.push_back(fromRows(glm::dvec4(axes.right, -x) / focus.radius, glm::dvec4(axes.up, -y) / focus.radius,
                                  glm::dvec4(axes.forward, -zMin) / depth, {0, 0, 0, 1}));
    fit.depthBias = biasTexels * texel / depth;
    return fit;
}

struct Cone {
    glm::dvec3 position; // shading space
    double nearPlane, farPlane, tanHalf;
};

glm::dmat4 perspectiveLayer(const Axes& axes, const Cone& cone) {
    const auto row = [&](const glm::dvec3& axis, double scale) {
        return glm::dvec4(axis, -glm::dot(axis, cone.position)) * scale;
    };
    const double range = cone.farPlane - cone.nearPlane;
    glm::dvec4 z = row(axes.forward, cone.farPlane / range);
    z.w -= cone.nearPlane * cone.farPlane / range;
    return fromRows(row(axes.right, 1 / cone.tanHalf), row(axes.up, 1 / cone.tanHalf), z, row(axes.forward, 1));
}

// A texel grows with the distance, while a step of the map's depth shrinks with its square. One bias fits one distance
// only: the geometric mean of the range.
double perspectiveBias(const Cone& cone, uint32_t mapSize) {
    const double middle = std::sqrt(cone.nearPlane * cone.farPlane);
    const double texel = 2 * cone.tanHalf * middle / mapSize;
    const double depthPerLength = cone.nearPlane * cone.farPlane / ((cone.farPlane - cone.nearPlane) * middle * middle);
    return biasTexels * texel * depthPerLength;
}

Cone coneOf(const Light& light, const Scene& scene, const CameraMatrices& camera, const glm::dvec3& worldOffset,
            double halfAngle) {
    Cone cone;
    cone.position = light.position + worldOffset - camera.eye;
    const glm::dvec3 reach =
        glm::max(glm::abs(scene.boundsMin - light.position), glm::abs(scene.boundsMax - light.position));
    cone.farPlane = std::max(1.01 * glm::length(reach), 1e-6);
    if (light.range > 0)
        cone.farPlane = std::min(cone.farPlane, double(light.range));
    cone.nearPlane = 0.005 * cone.farPlane;
    cone.tanHalf = std::tan(halfAngle);
    return cone;
}

} // namespace

ShadowFit fitShadow(const Light& light, const Scene& scene, const CameraMatrices& camera, const glm::dvec3& worldOffset,
                    uint32_t mapSize) {
    ShadowFit fit;
    if (light.type == LightType::Directional)
        return fitDirectional(light, scene, camera, worldOffset, mapSize);
    if (light.type == LightType::Spot) {
        const double half = std::clamp(double(light.outerCone) * 1.02, 0.01, 1.5);
        const Cone cone = coneOf(light, scene, camera, worldOffset, half);
        fit.layers.push_back(perspectiveLayer(axesAlong(light.direction), cone));
        fit.depthBias = perspectiveBias(cone, mapSize);
        return fit;
    }
    const Cone cone = coneOf(light, scene, camera, worldOffset, std::numbers::pi / 4);
    for (int face = 0; face < 6; ++face) {
        glm::dvec3 direction(0);
        direction[face / 2] = face % 2 == 0 ? 1 : -1;
        fit.layers.push_back(perspectiveLayer(axesAlong(direction), cone));
    }
    fit.depthBias = perspectiveBias(cone, mapSize);
    return fit;
}

AgaaShadow toAgaaShadow(const ShadowFit& fit) {
    AgaaShadow shadow{};
    shadow.layerCount = uint32_t(fit.layers.size());
    shadow.depthBias = float(fit.depthBias);
    for (size_t layer = 0; layer < fit.layers.size(); ++layer) {
        const glm::mat4 matrix(fit.layers[layer]);
        std::memcpy(shadow.matrices[layer], glm::value_ptr(matrix), sizeof shadow.matrices[layer]);
    }
    return shadow;
}

std::vector<double> shadowKey(const std::vector<Light>& lights, const glm::dvec3& worldOffset,
                              const CameraMatrices& camera, uint64_t placement) {
    std::vector<double> key = {double(placement)};
    const auto add = [&key](const glm::dvec3& v) {
        for (int i = 0; i < 3; ++i)
            key.push_back(v[i]);
    };
    add(worldOffset);
    add(camera.eye);
    add(camera.forward);
    key.push_back(camera.targetDistance);
    for (const size_t i : shadowedLights(lights)) {
        const Light& light = lights[i];
        key.push_back(double(light.type));
        add(light.position);
        add(light.direction);
        key.push_back(light.range);
        key.push_back(light.outerCone);
    }
    return key;
}

} // namespace harness
