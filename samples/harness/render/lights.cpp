#include "render/lights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace harness {

namespace {

uint32_t agaaType(LightType type) {
    switch (type) {
    case LightType::Directional:
        return AGAA_LIGHT_DIRECTIONAL;
    case LightType::Point:
        return AGAA_LIGHT_POINT;
    case LightType::Spot:
        return AGAA_LIGHT_SPOT;
    }
    throw std::runtime_error("A light has an unknown type.");
}

glm::dvec3 unitDirection(const Light& light) {
    const double length = glm::length(light.direction);
    if (length > 0)
        return light.direction / length;
    if (light.type == LightType::Point)
        return {0, -1, 0}; // not used, but the SDK requires a unit vector
    throw std::runtime_error("A light has no direction.");
}

} // namespace

std::vector<size_t> shadowedLights(const std::vector<Light>& lights) {
    std::vector<size_t> result;
    for (size_t i = 0; i < lights.size() && result.size() < AGAA_MAX_SHADOW_MAPS; ++i) {
        if (lights[i].castsShadow)
            result.push_back(i);
    }
    return result;
}

std::vector<AgaaLight> toAgaaLights(const std::vector<Light>& lights, const glm::dvec3& worldOffset,
                                    const glm::dvec3& eye) {
    const std::vector<size_t> shadowed = shadowedLights(lights);
    std::vector<AgaaLight> result;
    for (size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i];
        AgaaLight out{};
        out.type = agaaType(light.type);
        const auto map = std::find(shadowed.begin(), shadowed.end(), i);
        out.shadowMap = map == shadowed.end() ? AGAA_NO_SHADOW : uint32_t(map - shadowed.begin());
        const glm::dvec3 position = light.position + worldOffset - eye;
        const glm::dvec3 direction = unitDirection(light);
        for (int c = 0; c < 3; ++c) {
            // A directional light has no position, so it gets 0 instead of a large offset.
            out.position[c] = light.type == LightType::Directional ? 0.0f : float(position[c]);
            out.direction[c] = float(direction[c]);
            out.color[c] = light.color[c];
        }
        out.range = light.type == LightType::Directional ? 0.0f : light.range;
        out.radius = light.radius;
        if (light.type == LightType::Spot) {
            out.cosOuter = std::cos(light.outerCone);
            out.cosInner = std::max(std::cos(light.innerCone), out.cosOuter);
        } else {
            out.cosInner = out.cosOuter = -1.0f;
        }
        result.push_back(out);
    }
    return result;
}

} // namespace harness
