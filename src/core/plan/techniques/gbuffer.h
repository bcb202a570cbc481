// A G-buffer at the target's rate, which several techniques begin with: the host's geometry pass into it, or the
// host's own.
#pragma once

#include "core/plan/plan_builder.h"

#include <vector>

namespace agaa {

struct GBuffer {
    ResourceId depth = noResource; // and no attachments: the host's own
    std::vector<ResourceId> attachments;
    GBufferPacking packing;

    // Depth, attachments and where their channels lie, for a pass that reads samples
    // (src/shaders/gbuffer/gbuffer.glsl).
    void bind(PlanBuilder& b, Pass& pass) const;
    // The depth alone, and to count what a pass misses, the attachment that tells where geometry is.
    void bindDepth(PlanBuilder& b, Pass& pass) const;
};

GBuffer makeGBuffer(PlanBuilder& b);
// Over a depth that an earlier pass left, where it is equal.
GBuffer drawGBufferOver(PlanBuilder& b, ResourceId depth);

} // namespace agaa
