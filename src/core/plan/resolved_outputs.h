// Values per pixel beside the image (agaa/outputs.h): the sums that shading events add to, and the last pass.
#pragma once

#include "core/plan/plan_builder.h"

namespace agaa {

// Returns whether outputs of the view are values of surfaces, not of depths only.
bool resolvesSurfaces(const PlanBuilder& b);

// Lets a pass that shades add its events' surfaces to sums, if the view has outputs that need them. The plan's depth
// and samples are known already.
void sumEvents(PlanBuilder& b, Pass& pass);

// Adds the pass that writes the outputs, after those of the technique.
void resolveOutputs(PlanBuilder& b);

} // namespace agaa
