// What techniques share that keep a few aggregates or surfaces of a pixel's samples.
#pragma once

#include "core/plan_builder.h"
#include "core/techniques/gbuffer.h"

namespace agaa {

struct Prepass {
    ResourceId depth = noResource;
    ResourceId normals = noResource;

    void bind(PlanBuilder& b, Pass& pass) const;
};
// Depth and geometric normals of every sample.
Prepass drawPrepass(PlanBuilder& b, bool stencil);

// Where a buffer of aggregates keeps what, in words; the shaders' constants follow.
struct AggregateRecord {
    Layout layout;
    AggregatePacking packing;
    uint32_t stride = 0; // words from one to the next
};

ResourceId aggregateBuffer(PlanBuilder& b, const AggregateRecord& record);
void setRecord(Pass& pass, const AggregateRecord& record);

// The second geometry pass: fragments go to the aggregates of their visible samples. define writes what
// tells them which.
struct Generation {
    ResourceId depth = noResource;
    ResourceId aggregates = noResource;
    ResourceId coverage = noResource; // not 0 in this component where a sample shows geometry
    uint32_t coverageComponent = 0;
};
// Whether the generation of this plan wants the stencil, to keep the first of equal depths.
bool wantsStencil(const PlanBuilder& b);
// metadata: or noResource.
void drawAggregates(PlanBuilder& b, const Prepass& prepass, const AggregateRecord& record, ResourceId metadata,
                    ResourceId aggregates);
// From a G-buffer in place of that pass. permutation: of the shader.
void gatherAggregates(PlanBuilder& b, const GBuffer& gbuffer, const AggregateRecord& record,
                      ResourceId metadata, ResourceId aggregates, const char* permutation);
void shadeAggregates(PlanBuilder& b, const AggregateRecord& record, const Generation& generation,
                     const char* permutation);
Generation generationOf(const Prepass& prepass, ResourceId aggregates);
Generation generationOf(const GBuffer& gbuffer, ResourceId aggregates);

} // namespace agaa
