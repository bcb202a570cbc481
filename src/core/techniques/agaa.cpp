// `agaa`: prepass, aggregate definition, AG-buffer generation, shading (Crassin et al. 2016, section 3).
#include "core/checked.h"
#include "core/techniques/techniques.h"

#include <bit>

namespace agaa {

// Which aggregate each sample belongs to: ceil(log2 c) bit planes of n bits.
static Format metadataFormat(uint32_t samples, uint32_t aggregates) {
    const uint32_t bits = samples * uint32_t(std::bit_width(aggregates - 1));
    return bits <= 8 ? Format::R8U : bits <= 16 ? Format::R16U : bits <= 32 ? Format::R32U
                                                                              : Format::RG32U;
}

struct Surfaces {
    ResourceId depth, normals, metadata = noResource;
};

static Surfaces prepassAndDefinition(PlanBuilder& b, bool stencil) {
    const uint32_t c = b.plan.aggregates;
    Surfaces s;
    s.depth = b.depth(stencil);
    s.normals = b.image("normals", Format::RG8, true);
    Pass& prepass = b.hostDraw("prepass", AGAA_STAGE_PREPASS, AGAA_DRAW_PASS_VISIBILITY,
                               AGAA_SEGMENT_PREPASS);
    b.bindCommon(prepass);
    prepass.drawState.depthCompare = b.plan.reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    prepass.drawState.depthWrite = 1;
    prepass.drawState.colorAttachmentCount = 1;
    prepass.colorTargets = {s.normals};
    prepass.depthTarget = s.depth;
    prepass.clear = true;
    if (c == 1)
        return s; // nothing to define: no metadata, no pass
    s.metadata = b.image("metadata", metadataFormat(b.plan.samples, c), false);
    Pass& define = b.compute("define aggregates", AGAA_STAGE_DEFINITION, "definition", "m",
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(define);
    b.bind(define, slot::Depth, BindingType::Texture, s.depth);
    b.bind(define, slot::Surface0, BindingType::Texture, s.normals);
    b.bind(define, slot::MetadataOut, BindingType::StorageImage, s.metadata, true);
    return s;
}

// The papers' way, priced only: additive blending into c samples of colour targets.
static void buildNative(PlanBuilder& b) {
    const Surfaces s = prepassAndDefinition(b, true);
    (void)s;
    const uint32_t slots = std::bit_ceil(b.plan.aggregates); // no device has 3 samples
    uint64_t bytes = 0;
    const auto surface = [&](const char* name, Format format) {
        const ResourceId id = b.modelSurface(name, format, slots);
        bytes += bytesPerTexel(format);
        return id;
    };
    for (const NativeSurface& native : packNativeAggregate(b.plan.layout))
        surface(native.name, native.format);
    surface("aggregate-coverage", Format::R8U);
    if (b.plan.samples > 8)
        surface("aggregate-coverage-beyond-8-bits",
                b.plan.samples > 16 ? Format::R32U : Format::R8U);
    b.plan.bytesPerAggregate = uint32_t(bytes);
}

static void buildAtomics(PlanBuilder& b) {
    const AgaaConfig& config = b.config();
    const uint32_t c = b.plan.aggregates;
    const bool perSample = b.plan.generationTier == AGAA_TIER_PER_SAMPLE && b.plan.hwSamples > 1;
    const bool hasStencilFormat = b.caps().flags & (AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8);
    // Counting ties needs to see the fragments that the stencil test would refuse.
    const bool stencil = !(config.flags & AGAA_CONFIG_NO_STENCIL) && hasStencilFormat;

    const AggregatePacking packing = packAggregate(b.plan.layout, b.plan.samples);
    const Surfaces s = prepassAndDefinition(b, stencil);
    const ResourceId aggregates =
        b.pixelBuffer("aggregates", checkedMultiply(c, packing.bytes()));
    b.plan.bytesPerAggregate = packing.bytes();

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
    if (c > 1)
        b.bind(draw, host_slot::Metadata, BindingType::Texture, s.metadata);
    b.bind(draw, host_slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    if (!perSample && b.plan.hwSamples > 1)
        draw.extensions.push_back("VK_EXT_post_depth_coverage");

    const auto setPacking = [&](Pass& pass) {
        setFields(pass.constants, packing.fields);
        pass.constants[AGAA_WORDS] = packing.words;
        pass.constants[AGAA_FIELD_COVERAGE] = packing.coverage.constant();
        pass.constants[AGAA_FOLDED_ROUGHNESS] = b.plan.layout.foldsRoughness();
        pass.constants[AGAA_YCBCR_SPECULAR] = b.plan.layout.specularIsYCbCr();
    };
    setPacking(draw);

    Pass& shade = b.compute("shade aggregates", AGAA_STAGE_SHADING, "shade_aggregates", "mscb",
                            AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bind(shade, slot::Depth, BindingType::Texture, s.depth);
    b.bind(shade, slot::Aggregates, BindingType::StorageBuffer, aggregates);
    // The prepass's own coverage, to count what generation missed.
    if (b.counts())
        b.bind(shade, slot::Surface0, BindingType::Texture, s.normals);
    setPacking(shade);
    b.copyCounters();
}

static void build(PlanBuilder& b) {
    if (b.plan.generationTier == AGAA_TIER_NV_MIXED_SAMPLES)
        buildNative(b);
    else
        buildAtomics(b);
}

const Technique agaaTechnique = {"agaa", true, true, build};

} // namespace agaa
