// The rows of techniques that a sweep measures, and the effects that it switches off.
#pragma once

#include "render/renderer.h"

#include <string>
#include <vector>

namespace harness {

struct SweepRow {
    std::string technique;
    uint32_t samples = 1;    // n
    uint32_t aggregates = 0; // c or S; 0: the technique has none
    uint32_t shadingCost = 1;
    uint32_t generationTier = AGAA_TIER_AUTO;
    // A preset of the aggregation; with dcaa "lean", "paper" or "exact"; with adaptive "device"; or empty.
    std::string preset = {};

    // The name in files, such as "agaa-8-2" or "agaa-8-accurate". It includes the cost and the tier if they are not the
    // default.
    std::string name() const;
    // Writes the row to the configuration, whose technique then points into the row.
    void apply(TechniqueConfig& config) const;
};
std::vector<SweepRow> sweepRows(bool quick);
// Returns the rows of a full sweep with these names, in this order. Throws std::invalid_argument for a wrong name.
std::vector<SweepRow> namedSweepRows(const std::vector<std::string>& names);

struct SweepEffect {
    const char* name;
    uint64_t fact = 0;                       // the scene's fact that needs the effect
    void (*off)(TechniqueConfig&) = nullptr; // switches it off; null: removing the fact, or the normal maps, does
    bool ofShadows = false;                  // needed by scenes with shadow maps
    bool ofNormalMaps = false;               // needed by scenes with normal maps
    SweepRow row = {"agaa", 8, 2};           // the row that has the effect
};
const std::vector<SweepEffect>& sweepEffects();
// Returns whether the scene needs the effect.
bool isCalledFor(const SweepEffect& effect, const Scene& scene, const AgaaSceneFacts& facts);

} // namespace harness
