#include "render/fragment_capacity.h"

#include <algorithm>

namespace harness {

float capacityForFragments(uint64_t fragments, uint32_t width, uint32_t height) {
    const double perPixel = double(fragments) / (double(width) * double(height));
    return float(std::clamp(1.125 * perPixel, 1.0, 256.0));
}

void fitFragmentCapacity(Renderer& renderer, RenderSettings& settings) {
    if (!settings.config.keepsLists())
        return;
    RenderSettings counting = settings;
    counting.config.flags |= AGAA_CONFIG_COUNTERS;
    counting.config.coverage.fragmentsPerPixel = 1;
    counting.config.coverage.maxBatches = 1;
    counting.frames = 1;
    counting.warmup = 0;
    const RenderResult counted = renderer.render(counting);
    settings.config.coverage.fragmentsPerPixel =
        capacityForFragments(counted.statistics.back().counters.fragments, settings.width, settings.height);
}

} // namespace harness
