// The id of the primitive at each sample, by which later passes fetch materials.
#pragma once

#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/gbuffer.h"

#include <optional>

namespace agaa {

// Depth, ids and, if some draws cannot be fetched, their G-buffer.
struct Ids {
    Prepass prepass{noResource, noResource}; // none if the builder has PlanBuilder::visibleSamples
    std::optional<GBuffer> unfetched;

    void bind(PlanBuilder& b, Pass& pass) const;
    void bindDepth(PlanBuilder& b, Pass& pass) const;
    // Binds depth and the mask of geometry, by which shaders count visible samples.
    void bindGeometry(PlanBuilder& b, Pass& pass) const;
};

// Adds a prepass that the host draws.
Ids drawIds(PlanBuilder& b);

// Returns whether compute passes find the ids, so that the host draws nothing.
bool expandsIds(const ResolvedView& view);
// Adds these passes, and sets PlanBuilder::visibleSamples.
Ids expandIds(PlanBuilder& b);

} // namespace agaa
