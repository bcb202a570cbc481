// The host's geometry pass into a G-buffer at the target's rate, which several techniques begin with.
#pragma once

#include "core/plan_builder.h"

#include <vector>

namespace agaa {

struct GBuffer {
    ResourceId depth = noResource;
    std::vector<ResourceId> attachments;
    GBufferPacking packing;

    // Depth, attachments and where their channels lie, for a pass that reads samples
    // (src/shaders/passes/gbuffer.glsl).
    void bind(PlanBuilder& b, Pass& pass) const;
};

GBuffer drawGBuffer(PlanBuilder& b);

} // namespace agaa
