// `msaa`: forward shading once per fragment into a multisampled target, which is resolved. A depth
// prepass avoids the shading of hidden fragments.
#include "core/plan/plan_builder.h"
#include "core/plan/resolved_outputs.h"
#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/gbuffer.h"
#include "core/plan/techniques/techniques.h"

namespace agaa {

// Adds the prepass. Returns its depth.
static ResourceId drawDepth(PlanBuilder& b) {
    if (resolvesSurfaces(b)) // the forward pass keeps colours only
        return drawNormalsAndDepth(b).depth;
    return drawDepthPrepass(b, b.wantsStencil()).depth;
}

static void build(PlanBuilder& b) {
    const ResourceId depth = drawDepth(b);
    const ResourceId color = b.image("color", Format::RGBA16F, true);
    Pass& forward = b.hostDraw("forward", AGAA_STAGE_SHADING, AGAA_DRAW_PASS_FORWARD, AGAA_SEGMENT_SHADING);
    b.bindCommon(forward);
    b.bindLighting(forward);
    forward.draw().state.depthCompare = AGAA_COMPARE_EQUAL;
    forward.draw().state.stencilTest = b.keepsFirst();
    // The stencil test precedes the mask of a masked material. It would reject the coplanar fragment that owns the
    // sample, so that blending keeps the first fragment instead. Each coplanar masked fragment is still shaded.
    forward.draw().state.stencilTestMasked = 0;
    forward.draw().state.keepFirst = b.hasFact(AGAA_FACT_ALPHA_MASKED) || !b.keepsFirst();
    forward.draw().state.colorAttachmentCount = 1;
    forward.draw().colorTargets = {color};
    forward.draw().clearsColor = true;
    forward.draw().depthTarget = depth;
    Pass& resolve = b.compute("resolve", AGAA_STAGE_OTHER, "resolve", AGAA_SEGMENT_SHADING);
    b.bindCommon(resolve);
    b.bind(resolve, slot::Color, BindingType::Texture, color);
    b.bind(resolve, slot::Depth, BindingType::Texture, depth);
    b.bindOutput(resolve);
}

// There is no bound, because each visible primitive of a pixel is shaded.
static ShadingWork work(const ViewSettings&) { return {}; }

const Technique msaaTechnique = {
    .name = "msaa", .maxSamples = 32, .build = build, .work = work, .facts = knownCoverageFacts};

} // namespace agaa
