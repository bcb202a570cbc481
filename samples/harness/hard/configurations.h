// The configurations in which frames of hard cases are rendered: every technique with each n, c and tier.
#pragma once

#include "render/renderer.h"

#include <string>
#include <vector>

namespace harness::hard {

// The parts of a pixel that a configuration shades. The bounds of errors depend on them.
enum class Shading {
    One,        // one sample per pixel
    Few,        // anything of fewer than 8 samples
    Samples,    // every sample
    Surfaces,   // fragments, at least two surfaces, or samples that differ
    Aggregates, // at least two aggregates
    Mean,       // one aggregate or surface
    Event,      // one sample, whose light all have
};
constexpr size_t kShadings = 7;
const char* nameOf(Shading shading);

struct HardConfiguration {
    std::string technique;
    uint32_t samples = 1;
    uint32_t aggregates = 0; // c or S; 0: the technique has none
    uint32_t generationTier = AGAA_TIER_AUTO;
    bool isAccurate = false; // the preset "accurate"

    Shading shading() const;
    std::string name() const; // "agaa n=8 c=2 ids"
    // Writes the configuration. config.technique points into this object afterwards.
    void apply(TechniqueConfig& config) const;
};

const std::vector<HardConfiguration>& hardConfigurations();

} // namespace harness::hard
