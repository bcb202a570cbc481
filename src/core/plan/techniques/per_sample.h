// Shading of each sample of a G-buffer: the whole of some techniques, and the first step of filters.
#pragma once

#include "core/plan/techniques/gbuffer.h"

namespace agaa {

// Adds the pass that shades. isClassified: pixels that show one surface are shaded once. image: receives the result;
// noResource: the output does.
Pass& shadeSamples(PlanBuilder& b, const GBuffer& gbuffer, bool isClassified, ResourceId image = noResource);

void buildPerSample(PlanBuilder& b); // a G-buffer, and the pass that shades it into the output
ShadingWork workOfSamples(const ViewSettings& view);

} // namespace agaa
