// A G-buffer at the rate of the target, the first step of multiple techniques. The host draws into it, or the host has
// one of its own.
#pragma once

#include "core/plan/plan_builder.h"

#include <vector>

namespace agaa {

struct GBuffer {
    ResourceId depth = noResource; // noResource without attachments: the G-buffer of the host
    std::vector<ResourceId> attachments;
    GBufferPacking packing;

    // Binds depth and attachments and sets the positions of channels, for a pass that reads samples
    // (src/shaders/gbuffer/gbuffer.glsl).
    void bind(PlanBuilder& b, Pass& pass) const;
    // Binds the depth only. With counters it also binds the attachment that shows where geometry is.
    void bindDepth(PlanBuilder& b, Pass& pass) const;
};

// Binds the image whose texels are 0 where there is no geometry to a pass that reads it only to count. Without counters
// the depth takes its place, so that the memory of the image is free.
void bindGeometryMask(PlanBuilder& b, Pass& pass, ResourceId mask, ResourceId depth);

GBuffer makeGBuffer(PlanBuilder& b);
// Draws normals and custom attributes of samples in place of a depth prepass, whose fragments no counter counts. A
// later draw pass tests the stencil of the depth.
GBuffer drawNormalsAndDepth(PlanBuilder& b);
// Draws a G-buffer at depths that equal those of an earlier pass.
GBuffer drawGBufferOver(PlanBuilder& b, ResourceId depth);

} // namespace agaa
