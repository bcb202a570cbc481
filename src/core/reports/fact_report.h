// The fact report: counts of materials and lights compared with the scene facts of a view.
#pragma once

#include "core/frame/view_state.h"

namespace agaa {

// Returns AGAA_NOT_READY if no frame up to completedFrame was recorded completely. Throws Error for a view without
// AGAA_CONFIG_CHECK_FACTS.
AgaaResult factReport(const ViewState& view, uint64_t completedFrame, AgaaFactReport& out);

// Returns the facts that describe the counted materials, with the fewest effects. Common values that hold are set even
// if other facts imply them. viewFlags: the facts of the view.
uint64_t sufficientFacts(const AgaaFactReport& report, uint64_t viewFlags);

} // namespace agaa
