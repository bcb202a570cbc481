// Plans frames. The functions are pure and need no GPU. A host's description becomes a plan in three steps:
//   AgaaViewDesc -> ViewSettings   resolveView()        checks everything that does not depend on the device
//   ViewSettings -> ResolvedView   resolveForDevice()   strips unused features, chooses tiers, sets defaults
//   ResolvedView -> Plan           Technique::build()   adds resources and passes to a PlanBuilder
#pragma once

#include "core/plan/plan.h"

namespace agaa {

// Returns the rows of all techniques. The functions of view/ get them as an argument.
TechniqueTable techniques();

// Returns a device with all features, including those of the papers' native paths.
AgaaDeviceCaps idealDevice();

// Resolves the settings for the device and builds the plan. Throws Error if the device cannot run the view; the message
// says why.
Plan makePlan(const ViewSettings& settings, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

} // namespace agaa
