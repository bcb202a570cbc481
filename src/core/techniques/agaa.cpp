// `agaa`: prepass, aggregate definition, AG-buffer generation, shading (Crassin et al. 2016, section 3).
#include "core/checked.h"
#include "core/techniques/gbuffer.h"
#include "core/techniques/techniques.h"

#include <bit>

namespace agaa {

namespace {

// Which aggregate each sample belongs to: ceil(log2 c) bit planes of n bits.
Format metadataFormat(uint32_t samples, uint32_t aggregates) {
    const uint32_t bits = samples * uint32_t(std::bit_width(aggregates - 1));
    return bits <= 8    ? Format::R8U
           : bits <= 16 ? Format::R16U
           : bits <= 32 ? Format::R32U
                        : Format::RG32U;
}

struct Surfaces {
    ResourceId depth, normals;
};

Surfaces drawPrepass(PlanBuilder& b, bool stencil) {
    const Surfaces s{b.depth(stencil), b.image("normals", Format::RG8, true)};
    Pass& prepass = b.hostDraw("prepass", AGAA_STAGE_PREPASS, AGAA_DRAW_PASS_VISIBILITY,
                               AGAA_SEGMENT_PREPASS);
    b.bindCommon(prepass);
    prepass.drawState.depthCompare = b.plan.reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    prepass.drawState.depthWrite = 1;
    prepass.drawState.colorAttachmentCount = 1;
    prepass.colorTargets = {s.normals};
    prepass.depthTarget = s.depth;
    prepass.clear = true;
    return s;
}

// With one aggregate there is nothing to define: no metadata, no pass.
template <typename BindSamples>
ResourceId defineAggregates(PlanBuilder& b, BindSamples&& bindSamples) {
    if (b.plan.aggregates == 1)
        return noResource;
    const ResourceId metadata =
        b.image("metadata", metadataFormat(b.plan.samples, b.plan.aggregates), false);
    Pass& define = b.compute("define aggregates", AGAA_STAGE_DEFINITION, "definition", "mg",
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(define);
    bindSamples(define);
    b.bind(define, slot::MetadataOut, BindingType::StorageImage, metadata, true);
    return metadata;
}

void setPacking(const PlanBuilder& b, Pass& pass, const AggregatePacking& packing) {
    setFields(pass.constants, AGAA_FIELD_DIFFUSE_R, packing.fields);
    pass.constants[AGAA_WORDS] = packing.words;
    pass.constants[AGAA_FIELD_COVERAGE] = packing.coverage.constant();
    pass.constants[AGAA_FOLDED_ROUGHNESS] = b.plan.layout.foldsRoughness();
    pass.constants[AGAA_YCBCR_SPECULAR] = b.plan.layout.specularIsYCbCr();
}

ResourceId aggregateBuffer(PlanBuilder& b, const AggregatePacking& packing) {
    b.plan.bytesPerAggregate = packing.bytes();
    return b.pixelBuffer("aggregates", checkedMultiply(b.plan.aggregates, packing.bytes()));
}

// coverage: a surface whose component is not 0 where a sample shows geometry, to count what generation
// missed.
void shadeAggregates(PlanBuilder& b, const AggregatePacking& packing, ResourceId depth,
                     ResourceId aggregates, ResourceId coverage, uint32_t component) {
    Pass& shade = b.compute("shade aggregates", AGAA_STAGE_SHADING, "shade_aggregates", "mscb",
                            AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bind(shade, slot::Depth, BindingType::Texture, depth);
    b.bind(shade, slot::Aggregates, BindingType::StorageBuffer, aggregates);
    if (b.counts())
        b.bind(shade, slot::Surface0, BindingType::Texture, coverage);
    shade.constants[AGAA_COVERAGE_COMPONENT] = component;
    setPacking(b, shade, packing);
    b.copyCounters();
}

// The papers' way, priced only: additive blending into c samples of colour targets.
void buildNative(PlanBuilder& b) {
    const Surfaces s = drawPrepass(b, true);
    defineAggregates(b, [&](Pass& define) {
        b.bind(define, slot::Depth, BindingType::Texture, s.depth);
        b.bind(define, slot::Surface0, BindingType::Texture, s.normals);
    });
    const uint32_t slots = std::bit_ceil(b.plan.aggregates); // no device has 3 samples
    uint64_t bytes = 0;
    const auto surface = [&](const char* name, Format format) {
        b.modelSurface(name, format, slots);
        bytes += bytesPerTexel(format);
    };
    for (const NativeSurface& native : packNativeAggregate(b.plan.layout))
        surface(native.name, native.format);
    surface("aggregate-coverage", Format::R8U);
    if (b.plan.samples > 8)
        surface("aggregate-coverage-beyond-8-bits",
                b.plan.samples > 16 ? Format::R32U : Format::R8U);
    b.plan.bytesPerAggregate = uint32_t(bytes);
}

// A second geometry pass adds fragments to aggregates by integer atomics.
void buildAtomics(PlanBuilder& b) {
    const bool perSample = b.plan.generationTier == AGAA_TIER_PER_SAMPLE && b.plan.hwSamples > 1;
    const bool wantsStencil = !(b.config().flags & AGAA_CONFIG_NO_STENCIL);
    const AggregatePacking packing = packAggregate(b.plan.layout, b.plan.samples);
    const Surfaces s = drawPrepass(b, wantsStencil);
    const bool stencil = wantsStencil && hasStencil(b.plan.depthFormat);
    if (wantsStencil && !stencil)
        b.note("no format of depth and stencil: of equal depths the first to come is kept, which is "
               "not repeatable.");
    const ResourceId metadata = defineAggregates(b, [&](Pass& define) {
        b.bind(define, slot::Depth, BindingType::Texture, s.depth);
        b.bind(define, slot::Surface0, BindingType::Texture, s.normals);
    });
    const ResourceId aggregates = aggregateBuffer(b, packing);
    b.fill("clear aggregates", AGAA_STAGE_GENERATION, aggregates, AGAA_SEGMENT_GENERATION);
    Pass& draw = b.hostDraw("generate aggregates", AGAA_STAGE_GENERATION,
                            AGAA_DRAW_PASS_AGGREGATE, AGAA_SEGMENT_GENERATION);
    b.bindCommon(draw);
    draw.drawState.depthCompare = AGAA_COMPARE_EQUAL;
    draw.drawState.stencilTest = stencil;
    // A masked fragment may pass depth and stencil where its mask has no sample; were it to take the
    // stencil, the coplanar fragment that owns the sample would be refused.
    draw.drawState.stencilTestMasked = 0;
    draw.drawState.sampleShading = perSample;
    draw.depthTarget = s.depth;
    if (metadata != noResource)
        b.bind(draw, host_slot::Metadata, BindingType::Texture, metadata);
    b.bind(draw, host_slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    if (!perSample && b.plan.hwSamples > 1)
        draw.extensions.push_back("post_depth_coverage");
    setPacking(b, draw, packing);
    shadeAggregates(b, packing, s.depth, aggregates, s.normals, 0);
}

// One geometry pass into a multisampled G-buffer, from which a compute pass sums.
void buildFromGBuffer(PlanBuilder& b) {
    const AggregatePacking packing = packAggregate(b.plan.layout, b.plan.samples);
    const GBuffer gbuffer = drawGBuffer(b);
    const ResourceId metadata =
        defineAggregates(b, [&](Pass& define) { gbuffer.bind(b, define); });
    const ResourceId aggregates = aggregateBuffer(b, packing);
    Pass& gather = b.compute("gather aggregates", AGAA_STAGE_GENERATION, "gather", "ma",
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(gather);
    gbuffer.bind(b, gather);
    if (metadata != noResource)
        b.bind(gather, slot::Metadata, BindingType::Texture, metadata);
    b.bind(gather, slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    setPacking(b, gather, packing);
    const Field& normal = gbuffer.packing.fields[ChannelNormalX];
    shadeAggregates(b, packing, gbuffer.depth, aggregates, gbuffer.attachments[normal.word],
                    normal.shift);
}

void build(PlanBuilder& b) {
    switch (b.plan.generationTier) {
    case AGAA_TIER_NV_MIXED_SAMPLES:
        return buildNative(b);
    case AGAA_TIER_GBUFFER:
        return buildFromGBuffer(b);
    default:
        return buildAtomics(b);
    }
}

} // namespace

const Technique agaaTechnique = {"agaa", true, true, build};

} // namespace agaa
