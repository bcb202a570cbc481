// Which way each stage runs on a device, and why.
#pragma once

#include "agaa_sdk.h"
#include "core/view/technique.h"

#include <string>
#include <vector>

namespace agaa {

struct VisibilityChoice {
    AgaaTier tier = AGAA_TIER_AUTO; // AUTO: cannot run
    uint32_t hwSamples = 1;
    uint32_t scaleX = 1;
    uint32_t scaleY = 1;
    float relativeCost = 1;
    std::string reason; // one sentence
};
// Texels across a pixel of an ordered grid of n samples; 0: there is none.
uint32_t gridSide(uint32_t samples);
VisibilityChoice chooseVisibility(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced, bool prefersGrid = false);

// Of techniques that find coverage by themselves, on any device.
VisibilityChoice coverageByEdges(uint32_t samples);

struct GenerationChoice {
    const GenerationTier* row = nullptr; // null: cannot run
    std::string reason;                  // one sentence
};
// Of the technique's tiers the forced one, or with AUTO the first that runs. The query's isForced is set here.
GenerationChoice chooseGeneration(const Technique& technique, GenerationQuery query, uint32_t forced);

std::vector<AgaaCapability> listCapabilities(const AgaaDeviceCaps& caps);

} // namespace agaa
