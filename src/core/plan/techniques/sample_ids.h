// A prepass that stores the id of the primitive at each sample. Later passes fetch materials by it.
#pragma once

#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/gbuffer.h"

#include <optional>

namespace agaa {

// Depth, ids and, if some draws cannot be fetched, their G-buffer.
struct Ids {
    Prepass prepass;
    std::optional<GBuffer> unfetched;

    void bind(PlanBuilder& b, Pass& pass) const;
};

Ids drawIds(PlanBuilder& b);

} // namespace agaa
