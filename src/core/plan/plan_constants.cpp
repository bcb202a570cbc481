// Specialisation constants of a plan's passes, and those of its variants.
#include "core/plan/plan_builder.h"

#include "core/base/embedded.h"
#include "core/plan/sample_patterns.h"

#include "shaders/tables/lighting.inc"

#include <algorithm>
#include <bit>

namespace agaa {

Constants constantsOf(const ResolvedView& view) {
    const AgaaConfig& config = view.config;
    const AgaaMeasurement& measurement = view.measurement;
    Constants c{};
    c[AGAA_SAMPLES] = view.samples;
    c[AGAA_HW_SAMPLES] = view.hwSamples;
    c[AGAA_SCALE_X] = view.scaleX;
    c[AGAA_SCALE_Y] = view.scaleY;
    c[AGAA_LAYERS] = view.layers;
    const SamplePosition firstLayer = layerCentres(view)[0];
    c[AGAA_LAYER_X] = view.layers > 1 ? std::bit_cast<uint32_t>(firstLayer.x) : 0;
    c[AGAA_LAYER_Y] = view.layers > 1 ? std::bit_cast<uint32_t>(firstLayer.y) : 0;
    c[AGAA_AGGREGATES] = std::max(view.aggregates, 1u);
    c[AGAA_BRDF] = config.brdf;
    c[AGAA_NDF] = config.ndf;
    c[AGAA_FILTER_DIFFUSE] = measurement.flags & AGAA_MEASURE_NO_DIFFUSE_FILTER ? 0 : 1 + measurement.diffuseFilter;
    c[AGAA_LIGHT_DIRECTIONS] = (measurement.flags & AGAA_MEASURE_LIGHT_DIRECTIONS) != 0;
    c[AGAA_SHADOW_MAPS] = view.facts.shadowMapCount;
    c[AGAA_SHADOW_TAPS] = config.shadowTaps;
    c[AGAA_SHADOW_FILTER] = measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER    ? AGAA_SHADOW_AT_MEAN
                            : measurement.flags & AGAA_MEASURE_SHADOW_COVARIANCE ? AGAA_SHADOW_COVARIANCE
                            : measurement.flags & (AGAA_MEASURE_SHADOW_ALONG_DEPTH | AGAA_MEASURE_STORED_DEPTH)
                                ? AGAA_SHADOW_ALONG_DEPTH
                                : AGAA_SHADOW_AT_SAMPLES;
    c[AGAA_DEPTH_PLANES] = (measurement.flags & AGAA_MEASURE_DEPTH_PLANES) != 0;
    c[AGAA_COUNTERS] = view.hasCounters();
    c[AGAA_SEEDS] = measurement.seeds;
    c[AGAA_EMISSIVE_CHANNELS] = view.layout[AGAA_SEMANTIC_EMISSIVE].channels;
    c[AGAA_UNFILTERED_CHANNELS] = view.layout.unfilteredChannels();
    c[AGAA_CLASS_CHANNEL] = view.layout.classChannel();
    c[AGAA_HAS_SPECULAR] = view.layout.hasSpecularLight;
    c[AGAA_HAS_AMBIENT] = (view.facts.flags & AGAA_FACT_AMBIENT) != 0;
    c[AGAA_FACTS] = uint32_t(view.facts.flags);
    c[AGAA_CHECK_FACTS] = (config.flags & AGAA_CONFIG_CHECK_FACTS) != 0;
    c[AGAA_ONE_ALPHA2] = std::bit_cast<uint32_t>(view.facts.alpha2);
    c[AGAA_ONE_SPECULAR] = std::bit_cast<uint32_t>(view.facts.specular);
    c[AGAA_SHADING_COST] = measurement.shadingCost;
    c[AGAA_GLOSS_WEIGHT] =
        view.aggregation.glossWeight > 0 ? std::bit_cast<uint32_t>(view.aggregation.glossWeight) : 0; // not -0
    c[AGAA_LIT_SHADOWS] = view.aggregation.litShadows;
    c[AGAA_DEBUG_VIEW] = measurement.debugView;
    c[AGAA_HDR_RESOLVE] =
        (config.flags & AGAA_CONFIG_HDR_RESOLVE) && view.samples > 1 && measurement.debugView == AGAA_DEBUG_VIEW_NONE;
    c[AGAA_FAR_DEPTH] = !view.reversedZ;
    c[AGAA_GENERATION_TIER] = view.generationTier;
    // The samples of a texel share a fragment, for which a G-buffer has one material.
    c[AGAA_FINE_MATERIALS] = (config.flags & AGAA_CONFIG_FINE_MATERIALS) != 0;
    c[AGAA_MATERIAL_SAMPLES] = c[AGAA_FINE_MATERIALS] ? view.hwSamples : view.samples;
    return c;
}

uint32_t PlanBuilder::variantLitShadows() const {
    return plan.view.aggregation.litShadows & ((1u << plan.view.variantFacts.shadowMapCount) - 1);
}

// Changes constants of compute passes. Constants that a shader does not read keep their values, so that variants share
// its pipeline.
void PlanBuilder::specialiseForVariant() {
    static_assert(ConstantCount <= 128, "core/base/embedded.cpp has 128 bits for each module.");
    const uint32_t shadows = plan.view.variantFacts.shadowMapCount;
    if (plan.view.variantFacts.flags == plan.view.facts.flags && shadows == plan.view.facts.shadowMapCount)
        return;
    for (Pass& pass : plan.passes) {
        if (pass.kind() != PassKind::Compute)
            continue;
        // A pass that is compiled with the view may read any constant.
        const bool isEmbedded = pass.compute().hostCode.empty() && pass.compute().text.empty();
        const auto limit = [&](Constant constant, uint32_t value) {
            uint32_t& current = pass.constants[constant];
            if (current != value && (!isEmbedded || readsConstant(pass.compute().shader, constant)))
                current = value;
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
