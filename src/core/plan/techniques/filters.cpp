// `fxaa` and `smaa`: a G-buffer of one sample is shaded; then filters find the edges of the shaded image and soften
// them.
#include "core/plan/techniques/per_sample.h"
#include "core/plan/techniques/techniques.h"
#include "shaders/tables/layouts.inc"

namespace agaa {

namespace {

// Debug views show numbers, which must not be filtered.
bool showsNumbers(const PlanBuilder& b) { return b.view().measurement.debugView != AGAA_DEBUG_VIEW_NONE; }

Pass& filter(PlanBuilder& b, const char* name, const char* shader) {
    Pass& pass = b.compute(name, AGAA_STAGE_OTHER, shader, AGAA_SEGMENT_SHADING);
    b.bindCommon(pass);
    return pass;
}

// Lottes 2009.
void buildFxaa(PlanBuilder& b) {
    if (showsNumbers(b))
        return buildPerSample(b);
    const GBuffer gbuffer = makeGBuffer(b);
    const ResourceId shaded = b.image("shaded", Format::RGBA16F, false);
    shadeSamples(b, gbuffer, false, shaded).constants[AGAA_LUMA_IN_ALPHA] = 1;
    Pass& pass = filter(b, "fxaa", "fxaa");
    b.bind(pass, slot::Color, BindingType::Texture, shaded);
    b.bind(pass, slot::Output, BindingType::StorageImage, b.techniqueImage(), true);
}

// Jimenez et al. 2012, SMAA 1x.
void buildSmaa(PlanBuilder& b) {
    if (showsNumbers(b))
        return buildPerSample(b);
    const GBuffer gbuffer = makeGBuffer(b);
    const ResourceId shaded = b.image("shaded", Format::RGBA16F, false);
    shadeSamples(b, gbuffer, false, shaded);
    const ResourceId edges = b.tileBuffer("edges", AGAA_EDGE_REGION_SIDE, 4 * AGAA_EDGE_REGION_WORDS);
    Pass& find = filter(b, "find edges", "smaa_edges");
    find.compute().dispatch.groupSide = AGAA_EDGE_REGION_SIDE;
    b.bind(find, slot::Color, BindingType::Texture, shaded);
    b.bind(find, slot::Edges, BindingType::StorageBuffer, edges, true);
    const ResourceId shares = b.pixelBuffer("edge-shares", 4);
    Pass& follow = filter(b, "follow edges", "smaa_shares");
    b.bind(follow, slot::Edges, BindingType::StorageBuffer, edges);
    b.bind(follow, slot::Shares, BindingType::StorageBuffer, shares, true);
    Pass& blend = filter(b, "smaa", "smaa_blend");
    b.bind(blend, slot::Color, BindingType::Texture, shaded);
    b.bind(blend, slot::Shares, BindingType::StorageBuffer, shares);
    b.bind(blend, slot::Output, BindingType::StorageImage, b.techniqueImage(), true);
}

} // namespace

const Technique fxaaTechnique = {.name = "fxaa", .maxSamples = 1, .build = buildFxaa, .work = workOfSamples};
const Technique smaaTechnique = {.name = "smaa", .maxSamples = 1, .build = buildSmaa, .work = workOfSamples};

} // namespace agaa
