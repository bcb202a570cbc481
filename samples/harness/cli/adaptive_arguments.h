// Options of the technique "adaptive".
#pragma once

#include "render/technique_config.h"

#include <CLI/CLI.hpp>

#include <string>

namespace harness {

struct AdaptiveArguments {
    std::string metrics = "geometry,shading";
    std::string pattern = "grid";
    bool printedMetric = false;
    bool inOrder = false;
    bool equalWeights = false;
    bool loop = false;
    bool buckets = false;
    bool sorted = false;
    bool tileMaximum = false;
    bool sampleFootprints = false;
    bool countBackground = false;
    bool compareLight = false;
    AgaaAdaptiveSampling values = AGAA_ADAPTIVE_SAMPLING_INIT; // members that options set directly

    void addTo(CLI::App& app);
    void apply(TechniqueConfig& config) const; // throws BadArgument
};

} // namespace harness
