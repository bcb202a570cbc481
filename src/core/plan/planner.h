// layout + config + capabilities + scene facts -> Plan. Pure: no GPU, no graphics header.
#pragma once

#include "core/plan/plan.h"

namespace agaa {

// A device that has every feature and the papers' native paths.
AgaaDeviceCaps idealDevice();

// Throws Error where the device cannot run the view; the message says why.
Plan makePlan(const ViewSettings& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

} // namespace agaa
