// `agaa`: prepass, aggregate definition, AG-buffer generation, shading (Crassin et al. 2016, section 3).
#include "core/techniques/aggregation.h"
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

// With one aggregate there is nothing to define: no metadata, no pass.
template <class Samples>
ResourceId defineAggregates(PlanBuilder& b, const Samples& samples) {
    if (b.plan.aggregates == 1)
        return noResource;
    const ResourceId metadata =
        b.image("metadata", metadataFormat(b.plan.samples, b.plan.aggregates), false);
    Pass& define = b.compute("define aggregates", AGAA_STAGE_DEFINITION, "definition", "mg",
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(define);
    samples.bind(b, define);
    b.bind(define, slot::MetadataOut, BindingType::StorageImage, metadata, true);
    return metadata;
}

AggregateRecord recordOf(const PlanBuilder& b) {
    const AggregatePacking packing = packAggregate(b.plan.layout, b.plan.samples);
    return {b.plan.layout, packing, packing.words};
}

// The papers' way, priced only: additive blending into c samples of colour targets.
void buildNative(PlanBuilder& b) {
    const Prepass prepass = drawPrepass(b, true);
    defineAggregates(b, prepass);
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
    const AggregateRecord record = recordOf(b);
    const Prepass prepass = drawPrepass(b, wantsStencil(b));
    const ResourceId metadata = defineAggregates(b, prepass);
    const ResourceId aggregates = aggregateBuffer(b, record);
    b.fill("clear aggregates", AGAA_STAGE_GENERATION, aggregates, AGAA_SEGMENT_GENERATION);
    drawAggregates(b, prepass, record, metadata, aggregates);
    shadeAggregates(b, record, generationOf(prepass, aggregates), "mscbr0");
}

// One geometry pass into a multisampled G-buffer, from which a compute pass sums.
void buildFromGBuffer(PlanBuilder& b) {
    const AggregateRecord record = recordOf(b);
    const GBuffer gbuffer = drawGBuffer(b);
    const ResourceId metadata = defineAggregates(b, gbuffer);
    const ResourceId aggregates = aggregateBuffer(b, record);
    gatherAggregates(b, gbuffer, record, metadata, aggregates, "mar0");
    shadeAggregates(b, record, generationOf(gbuffer, aggregates), "mscbr0");
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

const Technique agaaTechnique = {"agaa", 4, true, build};

} // namespace agaa
