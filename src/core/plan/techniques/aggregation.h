// Steps shared by techniques with a few aggregates or surfaces per pixel: a prepass, the assignment of samples to
// aggregates, a second geometry pass or a G-buffer that fills the aggregates, and shading once per aggregate.
#pragma once

#include "core/plan/plan_builder.h"

#include <functional>

namespace agaa {

extern const TechniqueSettings aggregationSettings; // AgaaAggregation

ShadingWork workOfAggregates(const ViewSettings& view);

struct Prepass {
    ResourceId depth = noResource;
    ResourceId values = noResource; // normals or ids by which samples are distinguished; 0 where there is no geometry
};
// Draws the depth of every sample.
Prepass drawDepthPrepass(PlanBuilder& b, bool stencil);
// Draws the depth and the value of every sample.
Prepass drawPrepass(PlanBuilder& b, bool stencil, const char* name = "normals", Format format = Format::RG8,
                    SampleContent content = SampleContent::Normal);

struct Aggregation {
    Layout layout; // of an aggregate
    AggregatePacking packing;
    uint32_t stride = 0;      // words from one aggregate to the next
    uint32_t spreadWords = 0; // for the spread of normals of elliptic lobes
    uint32_t depthWords = 0;  // for the moments of depth
    // The attributes of one sample represent the aggregate, in place of sums.
    bool represented = false;
    // Adds the pass that assigns samples to aggregates. bindSamples binds its inputs. Returns the image that generation
    // reads, or noResource.
    std::function<ResourceId(const std::function<void(Pass&)>& bindSamples, ResourceId aggregates)> define;
    bool definitionClears = false; // the pass clears the aggregates; otherwise a fill does
};

// Returns the layout of surfaces, whose attributes have the precision of samples.
Layout surfaceLayout(const ViewSettings& view);

// Sets the constants that describe the words of an aggregate.
void setRecord(Pass& pass, const Aggregation& aggregation);

// Adds a prepass, the definition and a second geometry pass, whose fragments go to the aggregates of their visible
// samples.
void buildTwoPasses(PlanBuilder& b, const Aggregation& aggregation);
// Adds the same passes with sums in attachments: the second geometry pass blends fragments additively into a colour
// sample for each aggregate, of attachments with fewer samples than the depth has.
void buildInAttachments(PlanBuilder& b, const Aggregation& aggregation);
// Adds one geometry pass into a multisampled G-buffer, from which a compute pass fills the aggregates.
void buildFromGBuffer(PlanBuilder& b, const Aggregation& aggregation);
// Adds one geometry pass into a multisampled G-buffer and a compute pass that groups samples and shades.
void shadeFromGBuffer(PlanBuilder& b);
// Adds one geometry pass into depth and ids and a compute pass that fetches materials, groups samples and fills the
// aggregates.
void buildFromIds(PlanBuilder& b, const Aggregation& aggregation);
// Adds one geometry pass into depth and ids and compute passes that fetch materials, group samples and shade.
void shadeFromIds(PlanBuilder& b);

} // namespace agaa
