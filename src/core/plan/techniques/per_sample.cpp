// `single`, `ssaa` and `simple_complex`: a G-buffer at n samples is shaded per sample. Materials are evaluated once per
// fragment and lighting once per sample, as in multisampled deferred engines.
#include "core/plan/techniques/per_sample.h"

#include "core/plan/techniques/techniques.h"

namespace agaa {

Pass& shadeSamples(PlanBuilder& b, const GBuffer& gbuffer, bool isClassified, ResourceId image) {
    b.cullLights([&](Pass& pass) { gbuffer.bindDepth(b, pass); });
    Pass& shade = b.compute("shade samples", AGAA_STAGE_SHADING, "shade_samples", AGAA_SEGMENT_SHADING,
                            {{Switch::Classified, isClassified}});
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade, image);
    gbuffer.bind(b, shade);
    return shade;
}

void buildPerSample(PlanBuilder& b) { shadeSamples(b, makeGBuffer(b), false); }

ShadingWork workOfSamples(const ViewSettings& view) { return {view.samples, 1}; }

namespace {

// Pixels that show one surface are shaded once (Lauritzen 2010).
void buildSimpleComplex(PlanBuilder& b) { shadeSamples(b, makeGBuffer(b), true); }

void resolveSimpleComplex(ResolvedView& view) { setSurfaceDefaults(view, 0.98f, 1.0f, 0.05f); }

ShadingWork someSamples(const ViewSettings& view) { return {view.samples, view.samples}; }

} // namespace

const Technique singleTechnique = {.name = "single", .maxSamples = 1, .build = buildPerSample, .work = workOfSamples};
const Technique ssaaTechnique = {.name = "ssaa", .maxSamples = 32, .build = buildPerSample, .work = workOfSamples};
const Technique simpleComplexTechnique = {.name = "simple_complex",
                                          .maxSamples = 32,
                                          .build = buildSimpleComplex,
                                          .work = someSamples,
                                          .resolve = resolveSimpleComplex};

} // namespace agaa
