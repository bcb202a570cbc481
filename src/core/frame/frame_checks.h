// Checks of a frame's description, before anything is recorded or changed.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

struct Plan;

// The frame's own facts, or those that the view announced. Throws where they are not valid or not within these.
AgaaSceneFacts factsOf(const AgaaFrame& frame, const Plan& plan);
// Against what the view was made for. The frame has its facts.
void checkFrame(const AgaaFrame& frame, const Plan& plan);
// Throws if the frame composites over the output and the view lacks AGAA_VIEW_COMPOSITE.
void checkComposite(const AgaaFrame& frame, const Plan& plan);
// Elements of the frame's arrays, which checkFrame() has accepted.
AgaaLight lightOf(const AgaaFrame& frame, uint32_t index);
AgaaShadow shadowOf(const AgaaFrame& frame, uint32_t index);

} // namespace agaa
