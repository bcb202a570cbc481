#include "render/layers.h"

#include "embedded.h"

#include <algorithm>
#include <random>

namespace harness {

LayerConstants layerConstants(const CameraMatrices& camera, const glm::dmat4& rasterised) {
    const double distance = camera.targetDistance;
    const glm::dmat3 toShading = glm::transpose(glm::dmat3(camera.view));
    const auto at = [&](const glm::dvec3& inView, double halfWidth) {
        return glm::vec4(glm::dvec4(toShading * (inView * distance), halfWidth * distance));
    };
    LayerConstants layers{};
    layers.toClip = glm::mat4(rasterised * camera.view);
    layers.right = glm::vec4(glm::dvec4(toShading[0], 0));
    layers.up = glm::vec4(glm::dvec4(toShading[1], 0));
    layers.depth = {float(camera.projection[2][2]), float(camera.projection[3][2]), camera.viewer.w == 0 ? 1.0f : 0.0f,
                    0};
    layers.quads[0] = {at({0.2, 0, -1}, 0.25), {0.1f, 0.3f, 0.35f, 0.5f}, {1.2f, 0, float(0.01 * distance), 0}};
    std::mt19937 random(7); // its sequence is the same everywhere, unlike those of distributions
    const auto between = [&](double from, double to) { return from + (to - from) * double(random()) / 4294967295.0; };
    for (uint32_t i = 1; i < layerQuadCount; ++i) {
        const double side = between(-0.6, 0.6), height = between(-0.4, 0.4), depth = between(-1.5, -0.4);
        const double radius = between(0.02, 0.08);
        const float light = float(between(0.3, 1));
        layers.quads[i] = {at({side, height, depth}, radius),
                           {light, 0.8f * light, 0.6f * light, 0.6f},
                           {1, 1, float(radius * distance), 0}};
    }
    const auto distanceOf = [&](const LayerQuad& quad) {
        return -(camera.view * glm::dvec4(glm::dvec3(quad.centre), 0)).z;
    };
    std::ranges::sort(layers.quads,
                      [&](const LayerQuad& a, const LayerQuad& b) { return distanceOf(a) > distanceOf(b); });
    return layers;
}

std::string layerText(const std::string& head, const char* stage) {
    return head + "#define LAYER_QUADS " + std::to_string(layerQuadCount) + "\n" + embedded::layers_glsl + stage;
}

std::vector<AgaaResolvedValue> resolvedValues(const RenderSettings& settings) {
    std::vector<AgaaResolvedValue> values = settings.resolved;
    if (settings.hasLayers)
        values.insert(values.end(), {AGAA_RESOLVED_MEAN_DEPTH, AGAA_RESOLVED_COVERAGE});
    return values;
}

} // namespace harness
