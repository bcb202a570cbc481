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
    // Lets a pass with a workgroup for each tile run only while draws of the scene are needed.
    void dispatchTiles(const PlanBuilder& b, Pass& pass) const;
    // Ends the passes that use the lists. A batch repeats all of them, so that they belong to the segment of the draw.
    void finish(PlanBuilder& b) const;
};

// Adds a draw of the scene with a fragment for each pixel that a triangle touches.
Pass& drawTriangles(PlanBuilder& b, uint64_t segment);

// Returns whether the scene is drawn again if the lists overflow.
bool hasBatches(const ViewSettings& view);
// Returns the segment of draws whose fragments a pass shades without merging: all passes of a batch are in one segment.
uint64_t drawSegment(const ViewSettings& view);
// Sets AgaaDecoupledCoverage::maxBatches to the number of draws that the plan has.
void resolveBatches(ViewSettings& view, bool hasLists);

// payloadWords: words of a fragment that the draw with materials or a later pass writes.
FragmentLists drawFragments(PlanBuilder& b, uint32_t payloadWords, uint64_t segment);

extern const TechniqueSettings coverageSettings;

} // namespace agaa
