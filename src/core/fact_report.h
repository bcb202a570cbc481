// What counts of materials and lights say of a view's scene facts.
#pragma once

#include "agaa_sdk.h"
#include "core/frame_sequence.h"
#include "core/gpu_layout.h"
#include "core/plan.h"

namespace agaa {

// The members frameIndex and explanation included.
AgaaFactReport factReport(const Plan& plan, const FrameSequence::Slot& frame, const CounterBuffer& counts);

} // namespace agaa
