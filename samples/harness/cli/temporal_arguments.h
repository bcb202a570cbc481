// Options of the accumulation over frames.
#pragma once

#include "render/technique_config.h"

#include <CLI/CLI.hpp>

namespace harness {

struct TemporalArguments {
    bool accumulate = false;
    bool lastFrameOnly = false;
    uint32_t jitterPositions = 16;
    AgaaTemporal values = AGAA_TEMPORAL_INIT; // members that options set directly

    void addTo(CLI::App& app);
    void apply(TechniqueConfig& config) const;
};

} // namespace harness
