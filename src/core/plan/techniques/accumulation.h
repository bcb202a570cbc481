// Accumulation of the image over frames, after the passes of a technique.
#pragma once

#include "core/plan/plan_builder.h"

namespace agaa {

extern const TechniqueSettings temporalSettings;

// Adds the pass that mixes the technique's image with that of earlier frames and writes the output. Throws Error if the
// plan has no depth, or no attachment with the motion vectors that the view names.
void accumulateFrames(PlanBuilder& b);

} // namespace agaa
