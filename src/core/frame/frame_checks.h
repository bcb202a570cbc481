// Checks of a frame's description. They run before anything is recorded or changed.
#pragma once

#include "core/plan/plan.h"

namespace agaa {

// Returns the facts of the frame, or those of the view if it has none. Throws Error if they are not valid or not within
// the facts of the view.
AgaaSceneFacts factsOf(const AgaaFrame& frame, const Plan& plan);
// Checks the frame against the plan of its view. frame.facts must be set.
void checkFrame(const AgaaFrame& frame, const Plan& plan);
// Returns the frame's pixels: those of the view, if it names none.
FrameExtent extentOf(const AgaaFrame& frame, const Plan& plan);
// Throws if the frame composites over the output and the view lacks AGAA_VIEW_COMPOSITE.
void checkComposite(const AgaaFrame& frame, const Plan& plan);
// Throw Error if the upper left of a matrix is not orthonormal, or if the matrix is not a projection as
// AgaaFrame::projection. name: of the member.
void checkRotation(const float* matrix, const char* name);
void checkProjection(const float (&matrix)[16], const char* name);
// Return elements of the frame's arrays, which checkFrame() has accepted.
AgaaLight lightOf(const AgaaFrame& frame, uint32_t index);
AgaaShadow shadowOf(const AgaaFrame& frame, uint32_t index);

} // namespace agaa
