// `sbaa`: a prepass, the selection of the surfaces that cover most samples, their attributes, and shading once per
// surface (Salvi and Vidimce 2012, merge mode).
#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/generation_tiers.h"
#include "core/plan/techniques/techniques.h"

#include <algorithm>

namespace agaa {

namespace {

// The memory of the papers (AGAA section 5.4 and its slides): nine bytes per sample; per surface the G-buffer of a
// sample and two bytes.
void buildNative(PlanBuilder& b) {
    drawPrepass(b, true);
    b.image("primitive-ids", Format::R8, true);
    b.image("depth-slopes", Format::RG8, true);
    uint64_t bytes = bytesPerTexel(Format::R16U);
    const GBufferPacking packing = packGBuffer(b.view().layout);
    for (size_t i = 0; i < packing.attachments.size(); ++i) {
        b.multisampledImage("surface-gbuffer-" + std::to_string(i), packing.attachments[i], b.view().aggregates);
        bytes += bytesPerTexel(packing.attachments[i]);
    }
    b.multisampledImage("surface-data", Format::R16U, b.view().aggregates);
    b.plan.bytesPerAggregate = uint32_t(bytes);
}

void resolve(ResolvedView& view) { setSurfaceDefaults(view, 0.9f, 1.0f, 1.0f); }

void build(PlanBuilder& b) {
    if (b.view().generationTier == AGAA_TIER_NV_MIXED_SAMPLES)
        return buildNative(b);
    Aggregation surfaces;
    const bool fromGBuffer = b.view().generationTier == AGAA_TIER_GBUFFER;
    surfaces.layout = surfaceLayout(b.view());
    if (!fromGBuffer)
        surfaces.layout = twoPassLayout(surfaces.layout, b.view().facts.flags);
    surfaces.packing = packAggregate(surfaces.layout, 1);
    const uint32_t payloadWords = b.view().samples > 16 ? 2 : 1; // of src/shaders/math/sbaa_records.glsl
    surfaces.stride = surfaces.packing.words + payloadWords;
    surfaces.represented = true;
    surfaces.definitionClears = true;
    surfaces.define = [&](const auto& bindSamples, ResourceId aggregates) {
        Pass& select = b.compute("select surfaces", AGAA_STAGE_DEFINITION, "select", AGAA_SEGMENT_GENERATION);
        b.bindCommon(select);
        bindSamples(select);
        b.bind(select, slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
        setRecord(select, surfaces);
        return noResource;
    };
    fromGBuffer ? buildFromGBuffer(b, surfaces) : buildTwoPasses(b, surfaces);
}

} // namespace

static constexpr const GenerationTier* tiers[] = {&postDepthTier, &perSampleTier, &gbufferTier,
                                                  &pricedMixedSamplesTier};
static constexpr const TechniqueSettings* settings[] = {&aggregationSettings};
const Technique sbaaTechnique = {.name = "sbaa",
                                 .maxSamples = 32,
                                 .maxAggregates = 6,
                                 .tiers = tiers,
                                 .settings = settings,
                                 .build = build,
                                 .work = workOfAggregates,
                                 .resolve = resolve};

} // namespace agaa
