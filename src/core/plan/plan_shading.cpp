// Bindings of passes that shade (lights, light masks of tiles, shadows), and the list of effects that a plan uses.
#include "core/plan/plan_builder.h"

#include "core/base/error.h"
#include "core/plan/resolved_outputs.h"
#include "core/view/custom_glsl.h"
#include "core/view/shading_glsl.h"

#include "shaders/tables/lighting.inc"

#include <algorithm>
#include <bit>

namespace agaa {

// The time of whole frames with lit aggregates relative to those without: docs/results/lavapipe/effects/times.json.
constexpr float litCost = 1.09f;

void PlanBuilder::cullLightsWhereShaded() {
    cullsLights_ = plan.view.facts.maxLights >= AGAA_LEAST_CULLED_LIGHTS && !hasFact(AGAA_FACT_NO_LOCAL_LIGHTS) &&
                   !(plan.view.measurement.flags & AGAA_MEASURE_NO_LIGHT_CULLING);
    if (cullsLights_)
        constants_[AGAA_LIGHT_WORDS] = (plan.view.facts.maxLights + 31) / 32;
}

void PlanBuilder::cullLights(const std::function<void(Pass&)>& bindDepth) {
    cullLightsWhereShaded();
    if (!cullsLights_)
        return;
    const uint32_t words = uint32_t(constants_[AGAA_LIGHT_WORDS]);
    lightMasks_ = tileBuffer("light-masks", 8, 4 * (words + 1)); // the last word is for shadows
    Pass& cull = compute("cull lights", AGAA_STAGE_SHADING, "cull_lights", AGAA_SEGMENT_SHADING);
    bind(cull, slot::Frame, BindingType::UniformBuffer, frameConstants(cull.segment));
    bind(cull, slot::Lights, BindingType::StorageBuffer, lights_);
    bind(cull, slot::LightMasks, BindingType::StorageBuffer, lightMasks_, true);
    bindDepth(cull);
}

void PlanBuilder::bindLights(Pass& pass) {
    const bool host = pass.kind() == PassKind::HostDraw;
    bind(pass, host ? uint32_t(host_slot::Lights) : uint32_t(slot::Lights), BindingType::StorageBuffer, lights_);
    // Shaders declare the masks even if there are none, unless they cull lights themselves.
    if (!host && (lightMasks_ != noResource || !cullsLights_))
        bind(pass, slot::LightMasks, BindingType::StorageBuffer, lightMasks_ != noResource ? lightMasks_ : lights_);
}

void PlanBuilder::bindLighting(Pass& pass) {
    const bool host = pass.kind() == PassKind::HostDraw;
    require(
        !host || plan.view.measurement.debugView == AGAA_DEBUG_VIEW_NONE, AGAA_ERROR_UNSUPPORTED,
        "AgaaMeasurement::debugView is for techniques that shade in the SDK's passes; this one shades in the host's.");
    bindLights(pass);
    bindShadows(pass);
    if (!host && plan.view.shadingFunction) {
        addHostCode(pass, *plan.view.shadingFunction, "AgaaShadingFunction");
        std::string& defines = pass.compute().defines;
        defines += shadingFunctionGlsl(plan.view);
        if (defines.find("#define AGAA_CUSTOM_MEMBERS") == std::string::npos) // of other functions of the host
            defines += customGlsl(plan.view.layout);
    }
    sumEvents(*this, pass);
    if (plan.effects.empty())
        listEffects(plan.view.layout.foldsRoughness() && !host && pass.compute().shadesAggregates);
}

// Shaders declare all four maps. If the frame lacks one, another is bound in its place and not read.
void PlanBuilder::bindShadows(Pass& pass) {
    ResourceId anyMap = noResource;
    for (uint32_t i = 0; i < plan.view.facts.shadowMapCount; ++i) {
        if (plan.view.functionShadows >> i & 1)
            continue;
        if (shadowMaps_[i] == noResource)
            shadowMaps_[i] = add({.name = format("shadow-map-%u", i), .kind = ResourceKind::ShadowMap, .hostSlot = i});
        anyMap = shadowMaps_[i];
    }
    const bool host = pass.kind() == PassKind::HostDraw;
    const uint32_t first = host ? uint32_t(host_slot::Shadow0) : uint32_t(slot::Shadow0);
    for (uint32_t i = 0; anyMap != noResource && i < AGAA_MAX_SHADOW_MAPS; ++i)
        bind(pass, first + i, BindingType::ShadowTexture, shadowMaps_[i] != noResource ? shadowMaps_[i] : anyMap);
    if (!plan.view.functionShadows)
        return;
    require(!host, AGAA_ERROR_UNSUPPORTED,
            "AgaaShadowFunction is for techniques that shade in the SDK's passes; this one shades in the "
            "host's.");
    addHostCode(pass, plan.view.shadowFunction, "AgaaShadowFunction");
    // Some compilers reject the suffix `u` in preprocessor conditions.
    pass.compute().defines += format("#define AGAA_HOST_SHADOWS %u\n#define AGAA_HOST_FOOTPRINTS %u\n"
                                     "#define AGAA_SHADOW_TEXTURES %d\n",
                                     plan.view.functionShadows, plan.view.footprintShadows, anyMap != noResource);
}

void PlanBuilder::listEffects(bool readsFolded) {
    if (plan.view.layout.hasSpecularLight)
        effect("specular");
    if (plan.view.layout.has(AGAA_SEMANTIC_EMISSIVE))
        effect("emissive");
    if (hasFact(AGAA_FACT_AMBIENT))
        effect("ambient");
    if (hasFact(AGAA_FACT_ALPHA_MASKED))
        effect("alpha-mask");
    if (cullsLights_)
        effect("light-culling");
    if (plan.view.facts.shadowMapCount)
        effect("shadows");
    if (plan.view.functionShadows)
        effect("shadow-function");
    if (plan.view.shadingFunction)
        effect("shading-function");
    if (plan.view.aggregates) {
        if (plan.view.facts.shadowMapCount && constants_[AGAA_SHADOW_FILTER])
            effect("shadow-filter");
        if (plan.view.aggregation.litShadows) {
            effect("lit-aggregates");
            note(format("lit aggregates: shadows looked up at each sample: %d, up to %u taps a pixel and light; the "
                        "second means are in registers, no bytes in memory; on lavapipe, from a G-buffer, whole frames "
                        "took %.2f of the time of frames without.",
                        std::popcount(plan.view.aggregation.litShadows), plan.view.config.samples, double(litCost)));
        }
        if (constants_[AGAA_FILTER_DIFFUSE] && !readsFolded)
            effect("filtered-diffuse");
        if (readsFolded)
            note("roughness is folded into the normal's length: the length does not tell the spread of normals, so the "
                 "diffuse term is not filtered, and rounding of the sums widens narrow lobes.");
        if (constants_[AGAA_LIGHT_DIRECTIONS])
            effect("light-directions");
        if (constants_[AGAA_NDF] && plan.view.layout.hasSpecularLight)
            effect("ndf-widening");
        if (plan.view.config.ndf > AGAA_NDF_TOKSVIG)
            effect("elliptic-lobes");
        if (constants_[AGAA_GLOSS_WEIGHT] && plan.view.layout.hasSpecularLight)
            effect("gloss-weight");
    }
}

} // namespace agaa
