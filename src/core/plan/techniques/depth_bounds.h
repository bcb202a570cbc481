// Depth bounds of pixels by a depth prepass (Wang et al., I3D 2016, section 4.2).
#pragma once

#include "core/plan/plan_builder.h"

namespace agaa {

bool hasDepthPrepass(const ViewSettings& view);

// Throws Error if the view has AGAA_COVERAGE_DEPTH_PREPASS and no draw whose fragments it could bound.
void checkDepthPrepass(const ResolvedView& view, bool hasLists);

// Adds the prepass of a view with AGAA_COVERAGE_DEPTH_PREPASS and returns its depth, otherwise noResource.
ResourceId drawDepthPrepass(PlanBuilder& b);

// Adds a pass that bounds the depths of fragments in the lists. depth may be noResource: nothing is added.
void boundDepths(PlanBuilder& b, ResourceId depth, ResourceId lists, uint64_t segment);

} // namespace agaa
