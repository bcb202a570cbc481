// All fragments of each pixel in a list in memory (Wang et al., I3D 2016, section 3.1), for techniques that resolve
// visibility from them.
#pragma once

#include "core/plan/plan_builder.h"
#include "core/view/technique.h"

namespace agaa {

struct FragmentLists {
    ResourceId buffer = noResource;
    uint32_t firstPass = 0; // the draw of the scene

    void bind(PlanBuilder& b, Pass& pass) const; // with the host's functions
    void bindAlone(PlanBuilder& b, Pass& pass) const;
};

// A draw of the scene with a fragment for each pixel that a triangle touches.
Pass& drawTriangles(PlanBuilder& b);

// The scene is drawn again where fragments found no room.
bool hasBatches(const ViewSettings& view);
inline constexpr uint64_t predicateOffset = 12; // of the word that ends the repetition, in bytes

// payloadWords: of a fragment, that passes after the draw of the scene write, or the draw with materials.
FragmentLists drawFragments(PlanBuilder& b, uint32_t payloadWords);

extern const TechniqueSettings coverageSettings;

} // namespace agaa
