// The choice of a tier for each stage on a device, and its reasons.
#pragma once

#include "agaa_sdk.h"
#include "core/view/technique.h"

#include <string>
#include <vector>

namespace agaa {

struct VisibilityChoice {
    AgaaTier tier = AGAA_TIER_AUTO; // AUTO: the stage cannot run
    uint32_t hwSamples = 1;
    uint32_t scaleX = 1;
    uint32_t scaleY = 1;
    uint32_t layers = 1;
    float relativeCost = 1;
    std::string reason; // one sentence
};
inline constexpr uint32_t maxLayers = 8;
// Returns the texels across a pixel of an ordered grid of n samples, or 0 if there is no such grid.
uint32_t gridSide(uint32_t samples);
VisibilityChoice chooseVisibility(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced,
                                  bool prefersGrid = false);

// Returns the choice for techniques that compute coverage from the edges of triangles. It runs on all devices.
VisibilityChoice coverageByEdges(uint32_t samples);

struct GenerationChoice {
    const GenerationTier* row = nullptr; // null: the stage cannot run
    std::string reason;                  // one sentence
};
// Returns the forced tier of the technique, or with AUTO the first that runs. The function sets query.isForced. If the
// technique lacks the tier, the reason names the techniques of the table that have it.
GenerationChoice chooseGeneration(TechniqueTable table, const Technique& technique, GenerationQuery query,
                                  uint32_t forced);

// Returns the tiers of all techniques of the table that run.
std::vector<AgaaCapability> listCapabilities(TechniqueTable table, const AgaaDeviceCaps& caps);

} // namespace agaa
