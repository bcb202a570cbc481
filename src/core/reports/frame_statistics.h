// Statistics of the newest finished frame of a view.
#pragma once

#include "core/frame/view_state.h"

namespace agaa {

AgaaCounters countersOf(const CounterBuffer& source);

// Returns AGAA_NOT_READY where no frame up to completedFrame was recorded whole; memory and compilation are written all the same.
AgaaResult frameStatistics(const ViewState& view, uint64_t completedFrame, AgaaFrameStatistics& out);

} // namespace agaa
