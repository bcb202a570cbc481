#include "core/plan/techniques/triangle_expansion.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "shaders/tables/layouts.inc"

namespace agaa {

Dispatch dispatchOf(ResourceId buffer, uint32_t word) {
    return {.kind = DispatchKind::Indirect, .arguments = buffer, .argumentsOffset = 4 * word};
}

// The buffer has counts, a sum for each draw, then entries of large triangles
// (src/shaders/coverage/triangle_words.glsl).
static ResourceId makeTriangles(PlanBuilder& b) {
    const uint64_t words =
        AGAA_TRIANGLE_SUMS + uint64_t(b.view().maxDraws) + checkedMultiply(b.view().maxTriangles, AGAA_LARGE_WORDS);
    if (words > b.caps().maxStorageRange / 4)
        fail(AGAA_ERROR_TOO_LARGE,
             format("AgaaFetchFunction::maxTriangles is %u; their list needs %llu bytes, and one storage buffer of the "
                    "device has %llu.",
                    b.view().maxTriangles, static_cast<unsigned long long>(4 * words),
                    static_cast<unsigned long long>(b.caps().maxStorageRange)));
    return b.itemBuffer("triangles", words, 4);
}

Pass& TriangleExpansion::add(PlanBuilder& b, const std::string& name, const char* shader,
                             const Dispatch& dispatch) const {
    Pass& pass = b.compute(name, stage, shader, segment);
    pass.compute().dispatch = dispatch;
    b.bind(pass, slot::Triangles, BindingType::StorageBuffer, triangles, true);
    return pass;
}

void TriangleExpansion::bindFetch(PlanBuilder& b, Pass& pass) const {
    b.bindCommon(pass);
    b.bindHostFetch(pass);
    const bool isMasked = b.hasFact(AGAA_FACT_ALPHA_MASKED) || b.view().config.flags & AGAA_CONFIG_CHECK_FACTS;
    pass.compute().defines +=
        format("#define AGAA_MAX_DRAWS %uu\n#define AGAA_MAX_PRIMITIVES %uu\n#define AGAA_MAX_TRIANGLES %uu\n"
               "#define AGAA_EXPANDS_MASKED %d\n",
               b.view().maxDraws, b.view().maxPrimitives, b.view().maxTriangles, isMasked) +
        defines;
    bind(pass);
}

void TriangleExpansion::count(PlanBuilder& b) {
    triangles = makeTriangles(b);
    bindFetch(b, add(b, "count triangles", "count_triangles", oneGroup));
    b.note("triangles: compute passes fetch and expand them (AgaaFetchFunction::maxTriangles).");
}

void TriangleExpansion::expand(PlanBuilder& b, const Dispatch& groups, const std::string& step) const {
    const auto addExpansion = [&](const std::string& name, const char* shader, const Dispatch& dispatch) {
        Pass& pass = add(b, name, shader, dispatch);
        bindFetch(b, pass);
        bindFragments(pass);
    };
    addExpansion("expand triangles" + step, "expand_triangles", groups);
    add(b, "list large triangles" + step, "list_large", oneGroup);
    addExpansion("expand large triangles" + step, "expand_large", dispatchOf(triangles, AGAA_LARGE_DISPATCH));
}

} // namespace agaa
