// What techniques share that keep a few aggregates or surfaces of a pixel's samples: a prepass, what tells samples
// their aggregate, a second geometry pass or a G-buffer that fills the aggregates, shading once each.
#pragma once

#include "core/plan/plan_builder.h"

#include <functional>

namespace agaa {

extern const TechniqueSettings aggregationSettings; // AgaaAggregation

ShadingWork workOfAggregates(const ViewSettings& view);

struct Prepass {
    ResourceId depth = noResource;
    ResourceId normals = noResource; // or ids
};
// Depth of every sample and, by name and format, what tells samples apart.
Prepass drawPrepass(PlanBuilder& b, bool stencil, const char* name = "normals", Format format = Format::RG8,
                    SampleContent content = SampleContent::Normal);

struct Aggregation {
    Layout layout; // of an aggregate
    AggregatePacking packing;
    uint32_t stride = 0; // words from one aggregate to the next
    uint32_t spreadWords = 0; // for how normals spread, of elliptic lobes
    // One sample's attributes stand for all, in place of the sums of all of them.
    bool represented = false;
    // Adds the pass that tells samples their aggregate. bindSamples: binds what it reads. Returns the image that
    // generation reads, or noResource. It clears the aggregates itself, or leaves that to a fill.
    std::function<ResourceId(const std::function<void(Pass&)>& bindSamples, ResourceId aggregates)> define;
    bool definitionClears = false;
};

// Layout of surfaces, whose attributes keep the precision of samples.
Layout surfaceLayout(Layout layout);

// Constants by which shaders find an aggregate's words.
void setRecord(Pass& pass, const Aggregation& aggregation);

// Prepass, definition, a second geometry pass whose fragments go to the aggregates of their visible samples.
void buildTwoPasses(PlanBuilder& b, const Aggregation& aggregation);
// One geometry pass into a multisampled G-buffer, from which a compute pass fills the aggregates.
void buildFromGBuffer(PlanBuilder& b, const Aggregation& aggregation);
// The same of samples that are grouped by what they show, in one compute pass that shades at once.
void shadeFromGBuffer(PlanBuilder& b);
// One geometry pass into depth and ids; a compute pass that fetches materials, groups samples and fills the aggregates.
void buildFromIds(PlanBuilder& b, const Aggregation& aggregation);
// The same with a compute pass that shades at once.
void shadeFromIds(PlanBuilder& b);

} // namespace agaa
