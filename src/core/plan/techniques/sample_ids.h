// A prepass that leaves the id of the primitive at each sample, by which materials are fetched.
#pragma once

#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/gbuffer.h"

#include <optional>

namespace agaa {

// Depth, ids and, where some draws cannot be fetched, their G-buffer.
struct Ids {
    Prepass prepass;
    std::optional<GBuffer> unfetched;

    void bind(PlanBuilder& b, Pass& pass) const;
};

Ids drawIds(PlanBuilder& b);

} // namespace agaa
