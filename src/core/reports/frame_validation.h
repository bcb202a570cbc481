// The validation report: whether the geometry passes of the newest finished frame agree with each other and with the
// camera.
#pragma once

#include "core/frame/view_state.h"

namespace agaa {

// Returns AGAA_NOT_READY if no frame up to completedFrame was recorded completely. Throws Error for a view without
// counters.
AgaaResult frameValidation(const ViewState& view, uint64_t completedFrame, AgaaFrameValidation& out);

} // namespace agaa
