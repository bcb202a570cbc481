// `agaa`: prepass, aggregate definition, AG-buffer generation, shading (Crassin et al. 2016, section 3).
#include "core/base/error.h"
#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/fragment_lists.h"
#include "core/plan/techniques/generation_tiers.h"
#include "core/plan/techniques/techniques.h"
#include "shaders/tables/layouts.inc"

#include <bit>

namespace agaa {

namespace {

// Returns the format of the metadata, the aggregate of each sample: ceil(log2 c) bit planes of n bits.
Format metadataFormat(uint32_t samples, uint32_t aggregates) {
    const uint32_t bits = samples * uint32_t(std::bit_width(aggregates - 1));
    return bits <= 8 ? Format::R8U : bits <= 16 ? Format::R16U : bits <= 32 ? Format::R32U : Format::RG32U;
}

// Adds the definition pass and returns its metadata. A single aggregate needs neither.
ResourceId defineAggregates(PlanBuilder& b, const std::function<void(Pass&)>& bindSamples) {
    if (b.view().aggregates == 1)
        return noResource;
    const ResourceId metadata = b.image("metadata", metadataFormat(b.view().samples, b.view().aggregates), false);
    Pass& define = b.compute("define aggregates", AGAA_STAGE_DEFINITION, "definition", AGAA_SEGMENT_GENERATION);
    b.bindCommon(define);
    bindSamples(define);
    b.bind(define, slot::MetadataOut, BindingType::StorageImage, metadata, true);
    return metadata;
}

// One compute pass clusters and shades the fragments that are visible at coverage samples.
void shadeFromFragments(PlanBuilder& b) {
    const FragmentLists lists = drawFragments(b, AGAA_KEPT_PLANE_WORDS + 1, drawSegment(b.view())); // and the aggregate
    b.cullLightsWhereShaded();
    Pass& shade = b.compute("aggregate and shade", AGAA_STAGE_SHADING, "aggregate_fragments", AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    lists.bind(b, shade);
    lists.dispatchTiles(b, shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    lists.finish(b);
}

void resolve(ResolvedView& view) {
    setSurfaceDefaults(view, 0.98f, 1.0f, 1.0f);
    if (view.config.flags & AGAA_CONFIG_SPLIT_SURFACES)
        view.config.surfaceCosine = 2.0f; // no two normals have it
    resolveBatches(view, view.generationTier == AGAA_TIER_FRAGMENTS);
    // Shading would have to normalise with a prepass. All fragments of a list are grouped at once, in any order.
    view.coverage.flags &= ~(AGAA_COVERAGE_DEPTH_PREPASS | AGAA_COVERAGE_DRAW_ORDER | AGAA_COVERAGE_REVERSE_ORDER);
    if (view.generationTier != AGAA_TIER_FRAGMENTS)
        return;
    require(!(view.config.flags & AGAA_CONFIG_BUFFERED), AGAA_ERROR_UNSUPPORTED,
            "AGAA_CONFIG_BUFFERED is not for the tier fragments, which shades aggregates at once.");
}

void build(PlanBuilder& b) {
    if (b.view().generationTier == AGAA_TIER_FRAGMENTS)
        return shadeFromFragments(b);
    const bool byIds = b.view().generationTier == AGAA_TIER_IDS;
    const bool fromGBuffer = b.view().generationTier == AGAA_TIER_GBUFFER;
    if ((byIds || fromGBuffer) && !(b.view().config.flags & AGAA_CONFIG_BUFFERED))
        return byIds ? shadeFromIds(b) : shadeFromGBuffer(b);
    Aggregation sums;
    const bool hasSampleNormals = !byIds && !fromGBuffer && b.view().needsSampleNormals();
    sums.layout = hasSampleNormals ? twoPassLayout(b.view().layout, b.view().facts.flags) : b.view().layout;
    sums.packing = packAggregate(sums.layout, b.view().samples);
    sums.spreadWords = b.view().keepsNormalMoments() ? AGAA_MOMENT_WORDS : 0;
    sums.depthWords = b.view().storesDepth() ? AGAA_DEPTH_MOMENT_WORDS : 0;
    sums.stride = sums.packing.words + sums.spreadWords + sums.depthWords;
    sums.define = [&](const auto& bindSamples, ResourceId) { return defineAggregates(b, bindSamples); };
    if (b.view().generationTier == AGAA_TIER_NV_MIXED_SAMPLES)
        return buildInAttachments(b, sums);
    byIds ? buildFromIds(b, sums) : fromGBuffer ? buildFromGBuffer(b, sums) : buildTwoPasses(b, sums);
}

} // namespace

static constexpr const GenerationTier* tiers[] = {&idsTier,     &postDepthTier,    &perSampleTier,
                                                  &gbufferTier, &mixedSamplesTier, &fragmentsTier};
static constexpr const TechniqueSettings* settings[] = {&aggregationSettings, &coverageSettings};
const Technique agaaTechnique = {.name = "agaa",
                                 .maxSamples = 32,
                                 .maxAggregates = 4,
                                 .groupsSamples = true,
                                 .tiers = tiers,
                                 .settings = settings,
                                 .build = build,
                                 .work = workOfAggregates,
                                 .resolve = resolve};

} // namespace agaa
