#include "cli/temporal_arguments.h"

namespace harness {

void TemporalArguments::addTo(CLI::App& app) {
    app.add_flag("--accumulate", accumulate, "accumulate frames of any technique, as taa does");
    app.add_flag("--last-frame-only", lastFrameOnly, "mix each frame with the one before, not with all");
    app.add_option("--jitter-positions", jitterPositions, "positions of the camera's jitter, with accumulation")
        ->check(CLI::Range(1, 1024));
    app.add_option("--current-share", values.currentShare, "least share of a frame in the accumulated image");
    app.add_option("--clip-deviations", values.clipDeviations,
                   "limit of accumulated colours, in deviations of the pixels around; 0: none");
    app.add_option("--depth-tolerance", values.depthTolerance,
                   "largest change of a surface's distance between frames, as a share of it");
}

void TemporalArguments::apply(TechniqueConfig& config) const {
    const void* next = config.temporal.pNext; // the rest of the chain
    config.temporal = values;
    config.temporal.pNext = next;
    config.temporal.flags = lastFrameOnly ? AGAA_TEMPORAL_LAST_FRAME_ONLY : 0;
    config.flags |= accumulate ? AGAA_CONFIG_ACCUMULATE : 0;
}

} // namespace harness
