// Lists of all fragments of each pixel in memory (Wang et al., I3D 2016, section 3.1), for techniques that resolve
// visibility from them.
#pragma once

#include "core/plan/plan_builder.h"
#include "core/view/technique.h"
#include "shaders/tables/layouts.inc"

namespace agaa {

struct FragmentLists {
    ResourceId buffer = noResource;
    uint32_t firstPass = 0; // the draw of the scene

    void bind(PlanBuilder& b, Pass& pass) const; // binds the host's fetch function, too
    void bindAlone(PlanBuilder& b, Pass& pass) const;
};

// Adds a draw of the scene with a fragment for each pixel that a triangle touches.
Pass& drawTriangles(PlanBuilder& b);

// Returns whether the scene is drawn again if the lists overflow.
bool hasBatches(const ViewSettings& view);
inline constexpr uint64_t predicateOffset = 4 * AGAA_LIST_PREDICATE; // of the repetition's predicate, in bytes

// payloadWords: words of a fragment that the draw with materials or a later pass writes.
FragmentLists drawFragments(PlanBuilder& b, uint32_t payloadWords);

extern const TechniqueSettings coverageSettings;

} // namespace agaa
