#include "core/plan/techniques/depth_bounds.h"

#include "core/base/error.h"
#include "core/base/names.h"

namespace agaa {

bool hasDepthPrepass(const ViewSettings& view) { return view.coverage.flags & AGAA_COVERAGE_DEPTH_PREPASS; }

void checkDepthPrepass(const ResolvedView& view, bool hasLists) {
    if (!hasDepthPrepass(view))
        return;
    if (!hasLists)
        fail(AGAA_ERROR_UNSUPPORTED,
             format("AGAA_COVERAGE_DEPTH_PREPASS drops fragments before lists keep them; the tier %s has no lists.",
                    tierName(view.generationTier)));
    if (view.maxTriangles > 0 && view.generationTier != AGAA_TIER_MATERIAL_LISTS)
        fail(AGAA_ERROR_UNSUPPORTED,
             "AGAA_COVERAGE_DEPTH_PREPASS needs draws of the host, which do not exist if compute "
             "passes expand triangles (AgaaFetchFunction::maxTriangles).");
}

// Few samples suffice for a bound, and each takes memory for depth.
static uint32_t prepassSamples(const AgaaDeviceCaps& caps) {
    uint32_t samples = 8;
    while (samples > 1 && !(caps.sampleCounts & samples))
        samples /= 2;
    return samples;
}

ResourceId drawDepthPrepass(PlanBuilder& b) {
    if (!hasDepthPrepass(b.view()))
        return noResource;
    const uint32_t samples = prepassSamples(b.caps());
    const ResourceId depth = b.depth(false, samples);
    Pass& pass = b.hostDraw("prepass", AGAA_STAGE_PREPASS, AGAA_DRAW_PASS_VISIBILITY, AGAA_SEGMENT_PREPASS);
    b.bindCommon(pass);
    pass.draw().state.samples = samples;
    pass.draw().state.depthCompare = b.view().reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    pass.draw().state.depthWrite = 1;
    pass.draw().depthTarget = depth;
    pass.draw().clearsDepth = true;
    b.note(
        format("fragments: a depth prepass with %u samples drops hidden ones (AGAA_COVERAGE_DEPTH_PREPASS).", samples));
    return depth;
}

void boundDepths(PlanBuilder& b, ResourceId depth, ResourceId lists, uint64_t segment) {
    if (depth == noResource)
        return;
    const uint32_t samples = b.plan.resources[depth].samples;
    Pass& pass = b.compute("bound depths", AGAA_STAGE_GENERATION, "bound_depths", segment,
                           {{Switch::Multisampled, samples > 1}});
    b.bindCommon(pass);
    b.bind(pass, slot::Depth, BindingType::Texture, depth);
    b.bind(pass, slot::Fragments, BindingType::StorageBuffer, lists, true);
    pass.constants[AGAA_HW_SAMPLES] = samples;
}

} // namespace agaa
