// What a plan is built for: tiers, options, constants.
#include "core/plan/plan_builder.h"

#include "core/base/checked.h"
#include "core/base/embedded.h"
#include "core/base/error.h"

#include "shaders/tables/lighting.inc"

#include <algorithm>
#include <bit>

namespace agaa {

void PlanBuilder::chooseGenerationTier(const Technique& technique) {
    const AgaaConfig& config = plan.view.config;
    GenerationQuery query{.caps = caps_,
                          .hwSamples = plan.view.hwSamples,
                          .customDepth = hasFact(AGAA_FACT_CUSTOM_DEPTH),
                          .hostGBuffer = plan.view.hostGBuffer,
                          .fetches = plan.view.maxDraws > 0,
                          .someUnfetched = plan.view.someUnfetched,
                          .vertexPulling = plan.view.vertexPulling,
                          .coverageSamples = technique.countsCoverage(config.generationTier, plan.view.samples),
                          .needsMaterials = plan.view.aggregation.litShadows || plan.view.aggregation.glossWeight > 0 || config.ndf > AGAA_NDF_TOKSVIG};
    // Other tiers shade at once, without aggregates in memory.
    if (technique.groupsSamples && !query.coverageSamples && !(config.flags & AGAA_CONFIG_BUFFERED))
        query.aggregateBytes = aggregateBytes();
    const GenerationChoice choice = chooseGeneration(technique, query, config.generationTier);
    if (!choice.row)
        fail(AGAA_ERROR_UNSUPPORTED, "generation cannot run: " + choice.reason);
    generation_ = choice.row;
    plan.view.generationTier = choice.row->tier;
    plan.runnable = plan.runnable && !choice.row->isModel;
    note("generation: " + choice.reason);
}

// In memory, as two geometry passes leave them.
uint64_t PlanBuilder::aggregateBytes() const {
    const uint64_t words = packAggregate(twoPassLayout(plan.view.layout, plan.view.facts.flags), plan.view.samples).words;
    return checkedMultiply(uint64_t(plan.view.width) * plan.view.height, 4 * words * plan.view.aggregates + claimBytes());
}

// What neither the scene nor the technique calls for.
void PlanBuilder::stripUnusedFeatures(const Technique& technique) {
    AgaaConfig& config = plan.view.config;
    const bool showsFacts = plan.view.measurement.debugView == AGAA_DEBUG_VIEW_FACTS;
    config.flags |= showsFacts ? AGAA_CONFIG_CHECK_FACTS : 0;
    config.flags |= config.flags & AGAA_CONFIG_CHECK_FACTS ? AGAA_CONFIG_COUNTERS : 0;
    // What it shows is stored as diffuse albedo.
    plan.view.layout = reduceLayout(plan.view.layout, plan.view.facts.flags & ~(showsFacts ? AGAA_FACT_NO_DIFFUSE : 0),
                               technique.storesWidenedLobes);
    if (!technique.groupsSamples) { // settings of "agaa" may stay where another is measured
        plan.view.aggregation.litShadows = 0;
        config.flags &= ~(AGAA_CONFIG_BUFFERED | AGAA_CONFIG_FINE_MATERIALS);
        plan.view.measurement.flags &= ~AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
    }
    if (plan.view.aggregates < 2) // one place to go to
        plan.view.measurement.flags &= ~AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
    // No lobe: elliptic, or narrow.
    if (!(technique.groupsSamples || technique.keepsSpread) || !plan.view.layout.hasSpecularLight)
        config.ndf = std::min<uint32_t>(config.ndf, AGAA_NDF_TOKSVIG);
    if (!technique.groupsSamples || !plan.view.layout.hasSpecularLight)
        plan.view.aggregation.glossWeight = 0;
    const uint32_t lit = plan.view.aggregation.litShadows & ((1u << plan.view.facts.shadowMapCount) - 1);
    if (lit != plan.view.aggregation.litShadows)
        note("lit aggregates: AgaaAggregation::litShadows names shadows that AgaaSceneFacts does not declare; they are "
             "left out.");
    plan.view.aggregation.litShadows = lit;
}

// After the tier is known.
void PlanBuilder::checkTierOptions(const Technique& technique) const {
    const AgaaConfig& config = plan.view.config;
    const bool knowsMaterials = generation_ && generation_->knowsMaterials;
    const bool buffered = config.flags & AGAA_CONFIG_BUFFERED;
    require(plan.view.aggregation.glossWeight == 0 || knowsMaterials, AGAA_ERROR_UNSUPPORTED,
            "AgaaAggregation::glossWeight needs the tier ids, fragments or gbuffer, which know materials when they group "
            "samples.");
    require(plan.view.aggregation.litShadows == 0 || (knowsMaterials && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaAggregation::litShadows needs the tier fragments, or ids or gbuffer without AGAA_CONFIG_BUFFERED, which know "
            "materials and shadows in one pass.");
    require(config.ndf <= AGAA_NDF_TOKSVIG || (knowsMaterials && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::ndf needs the tier fragments, or ids or gbuffer without AGAA_CONFIG_BUFFERED for elliptic lobes, "
            "whose spread is not kept in memory.");
    const uint32_t view = plan.view.measurement.debugView;
    const bool ofAggregates = view == AGAA_DEBUG_VIEW_AGGREGATES || view == AGAA_DEBUG_VIEW_CLUSTERS ||
                              view == AGAA_DEBUG_VIEW_WIDENED;
    require(!ofAggregates || technique.maxAggregates, AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows aggregates, of which this technique makes none.");
    require(view != AGAA_DEBUG_VIEW_WIDENED || !plan.view.layout.foldsRoughness(), AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows widened lobes, which a layout with folded roughness cannot tell.");
    const bool countsPrimitives = generation_ && generation_->countsPrimitives;
    require(view != AGAA_DEBUG_VIEW_PRIMITIVES || (countsPrimitives && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows primitives, which only the tiers fragments, and ids without "
            "AGAA_CONFIG_BUFFERED, count.");
}

void PlanBuilder::checkFacts(const Technique& technique) const {
    const uint64_t refused = plan.view.facts.flags & ~technique.facts;
    if (refused & AGAA_FACT_CUSTOM_DEPTH)
        fail(AGAA_ERROR_UNSUPPORTED, format("\"%s\" does not take materials that write depth or discard on their own "
                                            "(AGAA_FACT_CUSTOM_DEPTH).", technique.name));
    if (refused)
        fail(AGAA_ERROR_UNSUPPORTED, format("\"%s\" does not take the bits 0x%llx of AgaaSceneFacts::flags.", technique.name,
                                            static_cast<unsigned long long>(refused)));
}

void PlanBuilder::chooseVisibilityTier(const Technique& technique) {
    if (technique.countsCoverage(plan.view.config.generationTier, plan.view.samples)) {
        const uint32_t forced = plan.view.config.visibilityTier;
        if (forced != AGAA_TIER_AUTO && forced != AGAA_TIER_NATIVE)
            fail(AGAA_ERROR_UNSUPPORTED, format("visibility cannot run: coverage samples of \"%s\" are found by edges, so that "
                                                "the tier %s is not for them.", technique.name, agaaTierName(forced)));
        plan.view.visibilityTier = AGAA_TIER_NATIVE;
        note("visibility: " + coverageByEdges(plan.view.samples).reason);
        return;
    }
    if (!plan.view.samplePositions.empty()) {
        plan.view.visibilityTier = AGAA_TIER_NATIVE;
        plan.view.hwSamples = plan.view.samples;
        note("visibility: the host says where the samples of its G-buffer lie.");
        return;
    }
    // Other tiers may have smaller targets.
    const bool fits = uint64_t(std::max(plan.view.width, plan.view.height)) * gridSide(plan.view.samples) <= caps_.maxImageSize;
    const VisibilityChoice choice =
        chooseVisibility(caps_, plan.view.samples, plan.view.config.visibilityTier,
                         fits && technique.prefersOrderedGrid && technique.prefersOrderedGrid(plan.view));
    if (choice.tier == AGAA_TIER_AUTO)
        fail(AGAA_ERROR_UNSUPPORTED, "visibility cannot run: " + choice.reason);
    plan.view.visibilityTier = choice.tier;
    plan.view.hwSamples = choice.hwSamples;
    plan.view.scaleX = choice.scaleX;
    plan.view.scaleY = choice.scaleY;
    note("visibility: " + choice.reason);
}

void PlanBuilder::setConstants() {
    const AgaaConfig& config = plan.view.config;
    const AgaaMeasurement& measurement = plan.view.measurement;
    Constants& c = constants_;
    c[AGAA_SAMPLES] = plan.view.samples;
    c[AGAA_HW_SAMPLES] = plan.view.hwSamples;
    c[AGAA_SCALE_X] = plan.view.scaleX;
    c[AGAA_SCALE_Y] = plan.view.scaleY;
    c[AGAA_AGGREGATES] = std::max(plan.view.aggregates, 1u);
    c[AGAA_BRDF] = config.brdf;
    c[AGAA_NDF] = config.ndf;
    c[AGAA_FILTER_DIFFUSE] = !(measurement.flags & AGAA_MEASURE_NO_DIFFUSE_FILTER);
    c[AGAA_SHADOW_MAPS] = plan.view.facts.shadowMapCount;
    // Eight taps at n = 8 are every sample of the pixel, so that visibility is exact; at higher n
    // eight of an aggregate's samples still span it.
    c[AGAA_SHADOW_TAPS] = config.shadowTaps ? config.shadowTaps : 8;
    c[AGAA_SHADOW_FILTER] = measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER     ? AGAA_SHADOW_AT_MEAN
                            : measurement.flags & AGAA_MEASURE_SHADOW_ALONG_DEPTH ? AGAA_SHADOW_ALONG_DEPTH
                                                                                  : AGAA_SHADOW_AT_SAMPLES;
    c[AGAA_COUNTERS] = counts();
    c[AGAA_SEEDS] = measurement.seeds;
    c[AGAA_EMISSIVE_CHANNELS] = plan.view.layout[AGAA_SEMANTIC_EMISSIVE].channels;
    c[AGAA_HAS_SPECULAR] = plan.view.layout.hasSpecularLight;
    c[AGAA_HAS_AMBIENT] = hasFact(AGAA_FACT_AMBIENT);
    c[AGAA_FACTS] = uint32_t(plan.view.facts.flags);
    c[AGAA_CHECK_FACTS] = (config.flags & AGAA_CONFIG_CHECK_FACTS) != 0;
    c[AGAA_ONE_ALPHA2] = std::bit_cast<uint32_t>(plan.view.facts.alpha2);
    c[AGAA_ONE_SPECULAR] = std::bit_cast<uint32_t>(plan.view.facts.specular);
    c[AGAA_SHADING_COST] = measurement.shadingCost;
    c[AGAA_GLOSS_WEIGHT] = plan.view.aggregation.glossWeight > 0 ? std::bit_cast<uint32_t>(plan.view.aggregation.glossWeight) : 0; // not -0
    c[AGAA_LIT_SHADOWS] = plan.view.aggregation.litShadows;
    c[AGAA_DEBUG_VIEW] = measurement.debugView;
    c[AGAA_FAR_DEPTH] = !plan.view.reversedZ;
    c[AGAA_GENERATION_TIER] = plan.view.generationTier;
    // The samples of a texel share a fragment, for which a G-buffer has one material.
    c[AGAA_FINE_MATERIALS] = (config.flags & AGAA_CONFIG_FINE_MATERIALS) != 0;
    c[AGAA_MATERIAL_SAMPLES] = c[AGAA_FINE_MATERIALS] ? plan.view.hwSamples : plan.view.samples;
}

uint32_t PlanBuilder::variantLitShadows() const {
    return plan.view.aggregation.litShadows & ((1u << plan.view.variantFacts.shadowMapCount) - 1);
}

// Of the compute passes' constants. Those that a shader does not read stay, so that variants share its pipeline.
void PlanBuilder::specialiseForVariant() {
    const uint32_t shadows = plan.view.variantFacts.shadowMapCount;
    if (plan.view.variantFacts.flags == plan.view.facts.flags && shadows == plan.view.facts.shadowMapCount)
        return;
    for (Pass& pass : plan.passes) {
        if (pass.kind != PassKind::Compute)
            continue;
        // Passes with text that is compiled with the view may read any.
        const std::span<const uint32_t> spirv =
            pass.compute.hostCode.empty() && pass.compute.text.empty() ? embeddedSpirv(pass.compute.shader) : std::span<const uint32_t>();
        const auto limit = [&](Constant constant, uint32_t value) {
            uint32_t& own = pass.constants[constant];
            if (own != value && (spirv.empty() || readsConstant(spirv, constant)))
                own = value;
        };
        if (!variantHas(AGAA_FACT_SPECULAR))
            limit(AGAA_HAS_SPECULAR, 0);
        if (!variantHas(AGAA_FACT_EMISSIVE))
            limit(AGAA_EMISSIVE_CHANNELS, 0);
        if (!variantHas(AGAA_FACT_AMBIENT))
            limit(AGAA_HAS_AMBIENT, 0);
        limit(AGAA_SHADOW_MAPS, shadows);
        limit(AGAA_LIT_SHADOWS, variantLitShadows());
    }
}

} // namespace agaa
