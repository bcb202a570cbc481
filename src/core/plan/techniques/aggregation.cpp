#include "core/plan/techniques/aggregation.h"

#include "core/base/arguments.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/plan/techniques/gbuffer.h"
#include "core/plan/techniques/sample_ids.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <optional>

namespace agaa {

static void readAggregation(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaAggregation> chained = readChained<AgaaAggregation>(&config);
    if (!chained)
        return;
    const AgaaAggregation& a = view.aggregation = *chained;
    view.aggregation.pNext = nullptr;
    checkReserved(a.reserved, "AgaaAggregation::reserved");
    checkRange(double(a.characteristicLength), 0.0, double(std::numeric_limits<float>::max()),
               "AgaaAggregation::characteristicLength");
    checkRange(double(a.characteristicLengthPerDistance), 0.0, 1.0, "AgaaAggregation::characteristicLengthPerDistance");
    // k = 0 divides by zero in equation 1 (hard case 21).
    require(a.characteristicLength > 0 || a.characteristicLengthPerDistance > 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaAggregation::characteristicLength and its share per distance are both 0; k must be > 0.");
    checkRange(double(a.aggregateThreshold), 0.0, 1e6, "AgaaAggregation::aggregateThreshold");
    checkFlags(a.litShadows, (1u << AGAA_MAX_SHADOW_MAPS) - 1, "AgaaAggregation::litShadows");
    checkRange(double(a.glossWeight), 0.0, 16.0, "AgaaAggregation::glossWeight");
}

const TechniqueSettings aggregationSettings = {.sType = AGAA_STRUCTURE_TYPE_AGGREGATION, .read = readAggregation};

ShadingWork workOfAggregates(const ViewSettings& view) { return {view.aggregates, view.samples}; }

Prepass drawDepthPrepass(PlanBuilder& b, bool stencil) {
    const Prepass s{b.depth(stencil)};
    Pass& prepass = b.hostDraw("prepass", AGAA_STAGE_PREPASS, AGAA_DRAW_PASS_VISIBILITY, AGAA_SEGMENT_PREPASS);
    b.bindCommon(prepass);
    prepass.draw().state.depthCompare = b.view().reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    prepass.draw().state.depthWrite = 1;
    prepass.draw().depthTarget = s.depth;
    prepass.draw().clearsDepth = true;
    return s;
}

Prepass drawPrepass(PlanBuilder& b, bool stencil, const char* name, Format format, SampleContent content) {
    Prepass s = drawDepthPrepass(b, stencil);
    s.values = b.image(name, format, true);
    DrawPart& draw = b.plan.passes.back().draw();
    draw.sampleContent = content;
    draw.state.colorAttachmentCount = 1;
    draw.colorTargets = {s.values};
    draw.clearsColor = true;
    return s;
}

Layout surfaceLayout(const ViewSettings& view) {
    Layout layout = view.layout;
    for (AgaaLayoutAttribute& attribute : layout.attributes) {
        attribute.encoding = AGAA_ENCODING_UNORM;
        attribute.aggregateBits = std::max(attribute.sampleBits, 6u);
    }
    for (CustomAttribute& custom : layout.customs)
        if (!isUnfiltered(custom.attribute)) // whose channels must fit a word
            custom.attribute.aggregateBits = std::max(custom.attribute.sampleBits, 6u);
    if (!view.shadingFunction && std::ranges::none_of(view.resolvedOutputs, resolvesCustom))
        layout.customs.clear(); // no shader reads them: agaaGetAggregateGlsl() is for "agaa"
    return layout;
}

void setRecord(Pass& pass, const Aggregation& a) {
    setFields(pass.constants, AGAA_FIELD_DIFFUSE_R, a.packing.fields);
    pass.constants[AGAA_WORDS] = a.packing.words;
    pass.constants[AGAA_UNFILTERED_WORDS] = a.packing.unfilteredWords;
    pass.constants[AGAA_CLASS_WORD] = a.packing.classWord;
    pass.constants[AGAA_STRIDE] = a.stride;
    pass.constants[AGAA_SPREAD_WORDS] = a.spreadWords;
    pass.constants[AGAA_DEPTH_WORDS] = a.depthWords;
    pass.constants[AGAA_FIELD_COVERAGE] = a.packing.coverage.constant();
    pass.constants[AGAA_FOLDED_ROUGHNESS] = a.layout.foldsRoughness();
    pass.constants[AGAA_YCBCR_SPECULAR] = a.layout.specularIsYCbCr();
}

namespace {

// claimBytes: bytes per pixel after all aggregates.
ResourceId aggregateBuffer(PlanBuilder& b, const Aggregation& a, uint64_t claimBytes = 0) {
    b.plan.bytesPerAggregate = 4 * a.stride;
    return b.pixelBuffer("aggregates", checkedMultiply(b.view().aggregates, 4 * a.stride) + claimBytes);
}

// Draws what a second geometry pass needs: depth and, except with one aggregate, the values that tell samples apart.
Prepass drawFirstPass(PlanBuilder& b, const Aggregation& a) {
    // The class is beside the normal.
    const Format values = a.packing.classWord && !a.represented ? Format::RGBA8 : Format::RG8;
    return a.represented || b.view().needsSampleNormals() ? drawPrepass(b, b.wantsStencil(), "normals", values)
                                                          : drawDepthPrepass(b, b.wantsStencil());
}

// Adds the second geometry pass, which needs targets. metadata may be noResource.
Pass& drawAggregates(PlanBuilder& b, const Aggregation& a, const Prepass& prepass, ResourceId metadata) {
    const bool stencil = b.keepsFirst();
    if (b.wantsStencil() && !stencil)
        b.note("no format of depth and stencil: of equal depths the first to come is kept, which is "
               "not repeatable.");
    const bool perSample = b.view().generationTier == AGAA_TIER_PER_SAMPLE && b.view().hwSamples > 1;
    Pass& pass =
        b.hostDraw("generate aggregates", AGAA_STAGE_GENERATION, AGAA_DRAW_PASS_AGGREGATE, AGAA_SEGMENT_GENERATION);
    b.bindCommon(pass);
    pass.draw().state.depthCompare = AGAA_COMPARE_EQUAL;
    pass.draw().state.stencilTest = stencil;
    // A masked fragment may pass the depth and stencil tests at a sample that its mask excludes. If it wrote the
    // stencil, the coplanar fragment that owns the sample would be rejected.
    pass.draw().state.stencilTestMasked = 0;
    pass.draw().state.sampleShading = perSample;
    pass.draw().depthTarget = prepass.depth;
    if (metadata != noResource)
        b.bind(pass, host_slot::Metadata, BindingType::Texture, metadata);
    // Fragments at the far plane equal the cleared depth, although the prepass does not show them. The normals
    // distinguish the two. A reversed depth has no such fragments, because floats reach 0 only at the plane itself.
    if (!a.represented && !b.view().reversedZ && prepass.values != noResource)
        b.bind(pass, host_slot::Normals, BindingType::Texture, prepass.values);
    if (!perSample && b.view().hwSamples > 1)
        pass.draw().extensions.push_back("ARB_post_depth_coverage");
    return pass;
}

// bindDepth: binds the depth of samples and the image that shows where geometry is.
Pass& shadeAggregates(PlanBuilder& b, const Aggregation& a, const std::function<void(Pass&)>& bindDepth) {
    b.cullLights(bindDepth);
    Pass& shade = b.compute("shade aggregates", AGAA_STAGE_SHADING, "shade_aggregates", AGAA_SEGMENT_SHADING,
                            {{Switch::Represented, a.represented}});
    shade.compute().shadesAggregates = true;
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    bindDepth(shade);
    return shade;
}

void shadeAggregates(PlanBuilder& b, const Aggregation& a, ResourceId aggregates,
                     const std::function<void(Pass&)>& bindDepth) {
    Pass& shade = shadeAggregates(b, a, bindDepth);
    b.bind(shade, slot::Aggregates, BindingType::StorageBuffer, aggregates);
    setRecord(shade, a);
}

// Binds what two geometry passes know of samples.
void bindFirstPass(PlanBuilder& b, const Aggregation& a, const Prepass& prepass, Pass& pass) {
    const bool hasNormals = a.layout.has(AGAA_SEMANTIC_NORMAL);
    b.bind(pass, slot::Depth, BindingType::Texture, prepass.depth);
    if (hasNormals)
        bindGeometryMask(b, pass, prepass.values, prepass.depth);
    else
        b.bind(pass, slot::Normals, BindingType::Texture, prepass.values);
    pass.constants[AGAA_COVERAGE_COMPONENT] = 0;
    pass.constants[AGAA_PREPASS_NORMALS] = !hasNormals;
}

// Adds the pass that assigns samples to aggregates.
ResourceId define(PlanBuilder& b, const Aggregation& a, const Prepass& prepass, ResourceId aggregates) {
    return a.define(
        [&](Pass& pass) {
            b.bind(pass, slot::Depth, BindingType::Texture, prepass.depth);
            b.bind(pass, slot::Normals, BindingType::Texture, prepass.values);
        },
        aggregates);
}

} // namespace

void buildTwoPasses(PlanBuilder& b, const Aggregation& a) {
    const Prepass prepass = drawFirstPass(b, a);
    const ResourceId aggregates = aggregateBuffer(b, a, b.view().claimBytes());
    const ResourceId metadata = define(b, a, prepass, aggregates);
    if (!a.definitionClears)
        b.fill("clear aggregates", AGAA_STAGE_GENERATION, aggregates, AGAA_SEGMENT_GENERATION);
    Pass& pass = drawAggregates(b, a, prepass, metadata);
    b.bind(pass, host_slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    setRecord(pass, a);
    shadeAggregates(b, a, aggregates, [&](Pass& shade) { bindFirstPass(b, a, prepass, shade); });
}

namespace {

// Sets the constants that describe sums in attachments. A field has the attachment in place of the word.
void setBlended(Pass& pass, const Aggregation& a, const BlendedPacking& packing) {
    setFields(pass.constants, AGAA_FIELD_DIFFUSE_R, packing.fields);
    pass.constants[AGAA_FIELD_COVERAGE] = packing.coverage.constant();
    pass.constants[AGAA_FOLDED_ROUGHNESS] = a.layout.foldsRoughness();
    pass.constants[AGAA_YCBCR_SPECULAR] = a.layout.specularIsYCbCr();
}

} // namespace

void buildInAttachments(PlanBuilder& b, const Aggregation& a) {
    static constexpr uint32_t slots[] = {slot::Blended0, slot::Blended1, slot::Blended2, slot::Blended3,
                                         slot::Blended4, slot::Blended5, slot::Blended6, slot::Blended7};
    static_assert(std::size(slots) == maxAttachments);
    const BlendedPacking packing = packBlendedAggregate(a.layout, b.view().samples);
    const uint32_t samples = std::bit_ceil(b.view().aggregates); // no device has 3; at most n
    const Prepass prepass = drawFirstPass(b, a);
    const ResourceId metadata = define(b, a, prepass, noResource);
    std::vector<ResourceId> targets;
    for (size_t i = 0; i < packing.attachments.size(); ++i) {
        const bool isBeyond = b.view().samples > 8 && i + 1 == packing.attachments.size();
        targets.push_back(b.multisampledImage(isBeyond ? std::string("aggregate-coverage-beyond-8-bits")
                                                       : "aggregates-" + std::to_string(i),
                                              packing.attachments[i], samples));
        b.plan.bytesPerAggregate += bytesPerTexel(packing.attachments[i]);
    }
    Pass& pass = drawAggregates(b, a, prepass, metadata);
    DrawPart& draw = pass.draw();
    draw.extensions.push_back("NV_sample_mask_override_coverage");
    draw.colorTargets = targets;
    draw.clearsColor = true;
    draw.state.colorAttachmentCount = uint32_t(targets.size());
    draw.state.additive = 1;
    draw.state.colorSamples = samples < b.view().hwSamples ? samples : 0;
    // Sums cannot leave out a sample that they have already. A fragment with a mask takes all samples that it covers at
    // this depth, so that a coplanar fragment drawn later loses those that the mask excludes.
    draw.state.stencilTestMasked = 1;
    setBlended(pass, a, packing);
    Pass& shade = shadeAggregates(b, a, [&](Pass& reader) { bindFirstPass(b, a, prepass, reader); });
    for (size_t i = 0; i < targets.size(); ++i)
        b.bind(shade, slots[i], BindingType::Texture, targets[i]);
    setBlended(shade, a, packing);
    ComputePart& program = shade.compute();
    program.text = "#include \"" + program.file + "\"\n"; // compiled with the view: few devices run it
    program.defines +=
        format("#define AGAA_BLENDED_TARGETS %zu\n#define AGAA_BLENDED_SAMPLES %u\n", targets.size(), samples);
}

void buildFromGBuffer(PlanBuilder& b, const Aggregation& a) {
    const GBuffer gbuffer = makeGBuffer(b);
    const ResourceId aggregates = aggregateBuffer(b, a);
    const ResourceId metadata = a.define([&](Pass& pass) { gbuffer.bind(b, pass); }, aggregates);
    Pass& gather = b.compute("gather aggregates", AGAA_STAGE_GENERATION, "gather", AGAA_SEGMENT_GENERATION,
                             {{Switch::MultipleAggregates, !a.represented && b.view().aggregates > 1},
                              {Switch::Represented, a.represented}});
    b.bindCommon(gather);
    gbuffer.bind(b, gather);
    if (metadata != noResource)
        b.bind(gather, slot::Metadata, BindingType::Texture, metadata);
    b.bind(gather, slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    setRecord(gather, a);
    shadeAggregates(b, a, aggregates, [&](Pass& pass) { gbuffer.bindDepth(b, pass); });
}

namespace {

// samples: an object that binds them.
template <typename Samples>
Pass& shadeAtOnce(PlanBuilder& b, const char* name, const char* shader, const Samples& samples) {
    Pass& shade = b.compute(name, AGAA_STAGE_SHADING, shader, AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    samples.bind(b, shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    return shade;
}

} // namespace

void shadeFromGBuffer(PlanBuilder& b) {
    const GBuffer gbuffer = makeGBuffer(b);
    b.cullLights([&](Pass& pass) { gbuffer.bindDepth(b, pass); });
    shadeAtOnce(b, "aggregate and shade", "aggregate_gbuffer", gbuffer);
}

static Ids findIds(PlanBuilder& b) { return expandsIds(b.view()) ? expandIds(b) : drawIds(b); }

void shadeFromIds(PlanBuilder& b) {
    const Ids ids = findIds(b);
    b.cullLights([&](Pass& pass) { ids.bindDepth(b, pass); });
    const ResourceId complexPixels = b.deferredPixels();
    b.deferPixels(shadeAtOnce(b, "shade single primitives", "single_ids", ids), complexPixels);
    b.consumeDeferred(shadeAtOnce(b, "aggregate and shade", "aggregate_ids", ids), complexPixels);
}

void buildFromIds(PlanBuilder& b, const Aggregation& a) {
    const Ids ids = findIds(b);
    const ResourceId aggregates = aggregateBuffer(b, a);
    Pass& gather = b.compute("gather aggregates", AGAA_STAGE_GENERATION, "gather_ids", AGAA_SEGMENT_GENERATION);
    b.bindCommon(gather);
    ids.bind(b, gather);
    b.bind(gather, slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    setRecord(gather, a);
    shadeAggregates(b, a, aggregates, [&](Pass& pass) { ids.bindGeometry(b, pass); });
}

} // namespace agaa
