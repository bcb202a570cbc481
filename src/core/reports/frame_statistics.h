// Statistics of the newest finished frame of a view.
#pragma once

#include "core/frame/view_state.h"

namespace agaa {

AgaaCounters countersOf(const CounterBuffer& source);

// Returns AGAA_NOT_READY if no frame up to completedFrame was recorded completely. Memory and compilation are written
// in any case.
AgaaResult frameStatistics(const ViewState& view, uint64_t completedFrame, AgaaFrameStatistics& out);

} // namespace agaa
