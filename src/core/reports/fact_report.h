// What counts of materials and lights say of a view's scene facts.
#pragma once

#include "core/frame/view_state.h"

namespace agaa {

// Returns AGAA_NOT_READY where no frame up to completedFrame was recorded whole. Throws Error for a view without
// AGAA_CONFIG_CHECK_FACTS.
AgaaResult factReport(const ViewState& view, uint64_t completedFrame, AgaaFactReport& out);

} // namespace agaa
