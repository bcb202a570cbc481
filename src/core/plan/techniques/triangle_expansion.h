// Compute passes that fetch triangles and find the pixels that they touch (AgaaFetchFunction::maxTriangles).
#pragma once

#include "core/plan/plan_builder.h"

#include <functional>
#include <string>

namespace agaa {

// A dispatch whose groups are three words of a buffer.
Dispatch dispatchOf(ResourceId buffer, uint32_t word);
inline const Dispatch oneGroup = {.kind = DispatchKind::Items, .items = 1};

struct TriangleExpansion {
    AgaaStage stage = AGAA_STAGE_GENERATION;
    uint64_t segment = 0;
    std::string defines = {};                      // of all passes; they select where fragments are kept
    std::function<void(Pass&)> bind = {};          // to all passes, besides the triangles
    std::function<void(Pass&)> bindFragments = {}; // to the passes that find fragments
    ResourceId triangles = noResource;             // set by count()

    // Adds the pass that sums the triangles of draws.
    void count(PlanBuilder& b);
    // Adds passes that find the fragments of all triangles. It may be called several times.
    // step   Follows the names of the passes.
    void expand(PlanBuilder& b, const Dispatch& groups, const std::string& step = {}) const;

private:
    Pass& add(PlanBuilder& b, const std::string& name, const char* shader, const Dispatch& dispatch) const;
    void bindFetch(PlanBuilder& b, Pass& pass) const;
};

} // namespace agaa
