#include "render/motion_image.h"

#include "render/reference.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace harness {

// Decodes the distance of material.frag.
static float decodedDistance(float emission, double unit) {
    const double share = emission / 16;
    if (!(share > 0)) // the background
        return std::numeric_limits<float>::infinity();
    return float(unit * share / std::max(1 - share, 1e-6));
}

MotionImage renderMotion(Renderer& renderer, RenderSettings settings) {
    if (settings.camera.height > 0)
        throw std::runtime_error("Images of the motion need a perspective camera.");
    settings.config = TechniqueConfig();
    settings.config.technique = "single";
    const AgaaLayout layout = referenceLayout(nullptr);
    settings.config.layout = &layout;
    settings.facts.flags &= AGAA_FACT_ALPHA_MASKED;
    settings.lights.clear();
    settings.ambient = glm::vec3(0);
    settings.background = glm::vec4(0, 0, 0, 1);
    settings.jitter = glm::dvec2(0);
    settings.frames = 1;
    settings.warmup = 0;
    settings.showsMotionSince = settings.firstFrame;
    const Image now = renderer.render(settings).image;
    settings.showsMotionSince = std::max(settings.firstFrame, 1u) - 1;
    const Image before = renderer.render(settings).image;

    const Camera camera =
        settings.motion && settings.motion->camera ? settings.motion->camera(settings.firstFrame) : settings.camera;
    const double unit = glm::length(camera.target - camera.eye);
    MotionImage image{now.width, now.height, {}, {}, {}};
    const glm::vec2 size(now.width, now.height);
    for (size_t i = 0; i < now.pixelCount(); ++i) {
        image.distance.push_back(decodedDistance(now.rgb[3 * i + 2], unit));
        image.previousDistance.push_back(decodedDistance(before.rgb[3 * i + 2], unit));
        const glm::vec2 share = (glm::vec2(before.rgb[3 * i], before.rgb[3 * i + 1]) - 8.0f) / 32.0f;
        image.toPrevious.push_back(before.rgb[3 * i + 2] > 0 ? share * size : glm::vec2(0));
    }
    return image;
}

} // namespace harness
