// layout + config + capabilities + scene facts -> Plan. Pure: no GPU, no graphics header.
#pragma once

#include "core/plan.h"

#include <string_view>

namespace agaa {

class PlanBuilder;

// A technique is a row of this table; see src/core/techniques/.
struct Technique {
    const char* name;
    uint32_t maxAggregates; // c or S, of techniques with a generation stage; 0: none
    bool multisampled;      // runs at more than one sample per pixel
    bool groupsSamples;     // by where they lie and what they show: tier IDS, lit shadows, gloss, elliptic lobes
    void (*build)(PlanBuilder& builder);
};
const std::vector<const Technique*>& techniques();
const Technique* findTechnique(std::string_view name);

// A device that has every feature and the papers' native paths.
AgaaDeviceCaps idealDevice();

// Throws Error where the view is not valid or the device cannot run it; the message says why.
Plan makePlan(const AgaaViewDesc& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

} // namespace agaa
