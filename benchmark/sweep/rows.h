// What a sweep measures: rows of techniques, and effects that are switched off.
#pragma once

#include "render/renderer.h"

#include <string>
#include <vector>

namespace harness {

struct SweepRow {
    std::string technique;
    uint32_t samples = 1;    // n
    uint32_t aggregates = 0; // c or S; 0 where neither
    uint32_t shadingCost = 1;
    uint32_t generationTier = AGAA_TIER_AUTO;
    std::string preset = {}; // that aggregates are of; of dcaa "paper" or "exact"; or none

    // Of files: "agaa-8-2", "agaa-8-accurate"; with the cost and the tier where they are not the usual.
    std::string name() const;
    void apply(TechniqueConfig& config) const; // technique points into the row
};
std::vector<SweepRow> sweepRows(bool quick);
// Rows of a full sweep by their names, in the order given; throws std::invalid_argument.
std::vector<SweepRow> namedSweepRows(const std::vector<std::string>& names);

struct SweepEffect {
    const char* name;
    uint64_t fact = 0; // of the scene, that calls for it
    void (*off)(TechniqueConfig&) = nullptr; // switches it off; null: leaving out the fact, or the normal maps
    bool ofShadows = false;    // called for by shadow maps
    bool ofNormalMaps = false; // called for by normal maps
    SweepRow row = {"agaa", 8, 2}; // that it is an effect of
};
const std::vector<SweepEffect>& sweepEffects();
bool isCalledFor(const SweepEffect& effect, const Scene& scene, const AgaaSceneFacts& facts);

} // namespace harness
