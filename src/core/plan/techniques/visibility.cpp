// `visibility`: a G-buffer at n samples, of which one per pixel is shaded. The others take their light from the shaded
// samples around (subpixel reconstruction, Chajdas et al. 2011).
#include "core/plan/techniques/gbuffer.h"
#include "core/plan/techniques/techniques.h"

namespace agaa {

namespace {

void resolve(ResolvedView& view) { setSurfaceDefaults(view, 0.95f, 1.5f, 0.08f); }

void build(PlanBuilder& b) {
    const GBuffer gbuffer = makeGBuffer(b);
    b.cullLights([&](Pass& pass) { gbuffer.bindDepth(b, pass); });
    const bool showsNumbers = b.view().measurement.debugView != AGAA_DEBUG_VIEW_NONE;
    const ResourceId shaded = showsNumbers ? noResource : b.image("shaded", Format::RGBA16F, false);
    Pass& shade = b.compute("shade one sample", AGAA_STAGE_SHADING, "shade_one", AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade, shaded);
    gbuffer.bind(b, shade);
    if (showsNumbers)
        return;
    Pass& reconstruct = b.compute("reconstruct", AGAA_STAGE_SHADING, "reconstruct", AGAA_SEGMENT_SHADING);
    b.bindCommon(reconstruct);
    b.bindOutput(reconstruct);
    b.bind(reconstruct, slot::FirstSamples, BindingType::Texture, shaded);
    gbuffer.bind(b, reconstruct);
}

ShadingWork oneEvent(const ViewSettings& view) { return {1, view.samples}; }

} // namespace

const Technique visibilityTechnique = {
    .name = "visibility", .maxSamples = 32, .build = build, .work = oneEvent, .resolve = resolve};

} // namespace agaa
