// Which way each stage runs on a device, and why.
#pragma once

#include "agaa_sdk.h"

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
VisibilityChoice chooseVisibility(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced);

struct GenerationChoice {
    AgaaTier tier = AGAA_TIER_AUTO; // AUTO: cannot run
    bool runnable = true;           // false: a model only
    float relativeCost = 1;
    std::string reason;
};
// customDepth: some materials write depth or discard on their own, so that no pass can compare with the
// depth of an earlier one before it runs them.
GenerationChoice chooseGeneration(const AgaaDeviceCaps& caps, uint32_t hwSamples, uint32_t forced,
                                  bool customDepth);

std::vector<AgaaCapability> listCapabilities(const AgaaDeviceCaps& caps);

} // namespace agaa
