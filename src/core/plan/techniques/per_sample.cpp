// `single`, `fxaa`, `ssaa` and `simple_complex`: a G-buffer at n samples is shaded per sample. Materials are evaluated
// once per fragment and lighting once per sample, as in multisampled deferred engines.
#include "core/plan/techniques/gbuffer.h"
#include "core/plan/techniques/techniques.h"

namespace agaa {

namespace {

// isClassified: pixels that show one surface are shaded once. image: receives the result; noResource: the output does.
Pass& shadeSamples(PlanBuilder& b, const GBuffer& gbuffer, bool isClassified, ResourceId image = noResource) {
    b.cullLights([&](Pass& pass) { gbuffer.bindDepth(b, pass); });
    Pass& shade = b.compute("shade samples", AGAA_STAGE_SHADING, "shade_samples", AGAA_SEGMENT_SHADING,
                            {{Switch::Classified, isClassified}});
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade, image);
    gbuffer.bind(b, shade);
    return shade;
}

void buildPerSample(PlanBuilder& b) {
    shadeSamples(b, makeGBuffer(b), false);
    b.copyCounters();
}

// A filter finds and softens the edges of the shaded image (Lottes 2009).
void buildFxaa(PlanBuilder& b) {
    if (b.view().measurement.debugView != AGAA_DEBUG_VIEW_NONE)
        return buildPerSample(b); // the image shows numbers, which must not be filtered
    const GBuffer gbuffer = makeGBuffer(b);
    const ResourceId shaded = b.image("shaded", Format::RGBA16F, false);
    shadeSamples(b, gbuffer, false, shaded).constants[AGAA_LUMA_IN_ALPHA] = 1;
    Pass& filter = b.compute("fxaa", AGAA_STAGE_OTHER, "fxaa", AGAA_SEGMENT_SHADING);
    b.bindCommon(filter);
    b.bind(filter, slot::Color, BindingType::Texture, shaded);
    b.bind(filter, slot::Output, BindingType::StorageImage, b.output(), true);
    b.copyCounters();
}

// Pixels that show one surface are shaded once (Lauritzen 2010).
void buildSimpleComplex(PlanBuilder& b) {
    shadeSamples(b, makeGBuffer(b), true);
    b.copyCounters();
}

void resolveSimpleComplex(ResolvedView& view) { setSurfaceDefaults(view, 0.98f, 1.0f, 0.05f); }

ShadingWork eachSample(const ViewSettings& view) { return {view.samples, 1}; }
ShadingWork someSamples(const ViewSettings& view) { return {view.samples, view.samples}; }

} // namespace

const Technique singleTechnique = {.name = "single", .maxSamples = 1, .build = buildPerSample, .work = eachSample};
const Technique ssaaTechnique = {.name = "ssaa", .maxSamples = 32, .build = buildPerSample, .work = eachSample};
const Technique fxaaTechnique = {.name = "fxaa", .maxSamples = 1, .build = buildFxaa, .work = eachSample};
const Technique simpleComplexTechnique = {.name = "simple_complex",
                                          .maxSamples = 32,
                                          .build = buildSimpleComplex,
                                          .work = someSamples,
                                          .resolve = resolveSimpleComplex};

} // namespace agaa
