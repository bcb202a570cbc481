#include "core/view/effects.h"

#include <algorithm>

namespace agaa {

namespace {

// An effect that is on if a flag of a part of the description equals `means`.
template <auto part, uint64_t flag, bool means = true> constexpr Effect flagEffect(const char* name, const char* need) {
    return {.name = name,
            .need = need,
            .isOn = [](const ViewSettings& view) { return (((view.*part).flags & flag) != 0) == means; },
            .set =
                [](ViewSettings& view, bool on) {
                    uint64_t& flags = (view.*part).flags;
                    flags = on == means ? flags | flag : flags & ~flag;
                }};
}

template <uint64_t flag> constexpr Effect fact(const char* name, const char* need) {
    return flagEffect<&ViewSettings::facts, flag>(name, need);
}

// An effect that is on unless a fact says that all materials or lights share a property.
template <uint64_t flag> constexpr Effect unlessFact(const char* name, const char* need) {
    return flagEffect<&ViewSettings::facts, flag, false>(name, need);
}

template <uint64_t flag> constexpr Effect option(const char* name, const char* need) {
    return flagEffect<&ViewSettings::config, flag>(name, need);
}

// An effect that is on unless a flag of AgaaMeasurement disables it.
template <uint64_t flag> constexpr Effect usual(const char* name, const char* need) {
    return flagEffect<&ViewSettings::measurement, flag, false>(name, need);
}

// Shadow map number `index`. All lower ones are on, too.
template <uint32_t index> constexpr Effect shadowMap(const char* name, const char* need) {
    return {.name = name,
            .need = need,
            .isOn = [](const ViewSettings& view) { return view.facts.shadowMapCount > index; },
            .set =
                [](ViewSettings& view, bool on) {
                    view.facts.shadowMapCount = on ? index + 1 : index;
                    view.functionShadows &= (1u << view.facts.shadowMapCount) - 1;
                    view.footprintShadows &= view.functionShadows;
                }};
}

// Sets a strength that is 0 without the effect. If the description has none, the usual strength is set.
template <class T> void setStrength(T& strength, bool on, T usual) {
    strength = !on ? T(0) : strength > T(0) ? strength : usual;
}

constexpr Effect table[] = {
    fact<AGAA_FACT_SPECULAR>("specular", "Materials have specular highlights."),
    unlessFact<AGAA_FACT_ONE_ROUGHNESS>("varied-roughness", "Materials differ in roughness."),
    unlessFact<AGAA_FACT_GREY_SPECULAR>("coloured-specular", "Highlights have colours, as those of gold and copper."),
    unlessFact<AGAA_FACT_ONE_SPECULAR>("varied-specular",
                                       "Materials differ in specular reflectance, as metals and plastics."),
    unlessFact<AGAA_FACT_NO_DIFFUSE>("diffuse", "Materials reflect light diffusely, as all but metals do."),
    unlessFact<AGAA_FACT_PLANE_NORMALS>("shading-normals",
                                        "Normal maps, or normals between vertices, change the shading."),
    fact<AGAA_FACT_EMISSIVE>("emissive", "Materials emit light."),
    fact<AGAA_FACT_AMBIENT>("ambient", "Ambient light reaches the surfaces."),
    fact<AGAA_FACT_ALPHA_MASKED>("alpha-mask", "Materials have cut-outs, for example leaves."),
    unlessFact<AGAA_FACT_NO_TRANSLUCENCY>("translucency", "Alpha-masked materials are translucent, for example glass."),
    unlessFact<AGAA_FACT_NO_CUTOUTS>("cut-outs", "Alpha-masked materials have cut-outs beside translucent ones."),
    fact<AGAA_FACT_CUSTOM_DEPTH>("custom-depth", "Materials write depth or discard fragments by code of their own."),
    {.name = "lights",
     .need = "The scene has lights.",
     .isOn = [](const ViewSettings& view) { return view.facts.maxLights > 0; },
     .set = [](ViewSettings& view, bool on) { setStrength(view.facts.maxLights, on, 64u); }},
    unlessFact<AGAA_FACT_NO_LOCAL_LIGHTS>("local-lights", "Point or spot lights light the scene."),
    usual<AGAA_MEASURE_NO_LIGHT_CULLING>("light-culling", "The scene has many lights that each reach few surfaces."),
    shadowMap<0>("shadow-map-0", "One light casts shadows."),
    shadowMap<1>("shadow-map-1", "A second light casts shadows."),
    shadowMap<2>("shadow-map-2", "A third light casts shadows."),
    shadowMap<3>("shadow-map-3", "A fourth light casts shadows."),
    usual<AGAA_MEASURE_NO_SHADOW_FILTER>("shadow-filter", "Shadows end between samples that are shaded together."),
    {.name = "lit-aggregates",
     .need = "Edges of shadows cross aggregates whose samples differ in normal or colour.",
     .isOn = [](const ViewSettings& view) { return view.aggregation.litShadows != 0; },
     .set = [](ViewSettings& view, bool on) { setStrength(view.aggregation.litShadows, on, 1u); }},
    usual<AGAA_MEASURE_NO_DIFFUSE_FILTER>("filtered-diffuse",
                                          "Normals differ within an aggregate of a diffuse surface."),
    flagEffect<&ViewSettings::measurement, AGAA_MEASURE_LIGHT_DIRECTIONS>(
        "light-directions", "Lights are nearer than the surfaces of an aggregate are to each other."),
    {.name = "ndf-widening",
     .need = "Normals differ within an aggregate of a glossy surface.",
     .isOn = [](const ViewSettings& view) { return view.config.ndf != AGAA_NDF_NONE; },
     .set = [](ViewSettings& view, bool on) { setStrength(view.config.ndf, on, uint32_t(AGAA_NDF_TOKSVIG)); }},
    {.name = "elliptic-lobes",
     .need = "Thin geometry has sharp highlights.",
     .isOn = [](const ViewSettings& view) { return view.config.ndf > AGAA_NDF_TOKSVIG; },
     .set =
         [](ViewSettings& view, bool on) {
             uint32_t& ndf = view.config.ndf;
             ndf = on ? std::max<uint32_t>(ndf, AGAA_NDF_LEAN) : std::min<uint32_t>(ndf, AGAA_NDF_TOKSVIG);
         }},
    {.name = "gloss-weight",
     .need = "Glossy surfaces of different directions share a pixel.",
     .isOn = [](const ViewSettings& view) { return view.aggregation.glossWeight > 0; },
     .set = [](ViewSettings& view, bool on) { setStrength(view.aggregation.glossWeight, on, 0.5f); }},
    option<AGAA_CONFIG_BUFFERED>("buffered", "Shaders of the host read aggregates."),
    option<AGAA_CONFIG_FINE_MATERIALS>("fine-materials",
                                       "Textures change within the part of a primitive that a pixel shows."),
    {.name = "unfetched-draws",
     .need = "The materials of some draws cannot be fetched by id.",
     .isOn = [](const ViewSettings& view) { return view.someUnfetched; },
     .set = [](ViewSettings& view, bool on) { view.someUnfetched = on && view.maxDraws > 0; }},
    option<AGAA_CONFIG_HDR_RESOLVE>("hdr-resolve", "Surfaces of very different brightness share a pixel."),
    {.name = "resolved-outputs",
     .need = "Passes after the image read the depth, normal or coverage of pixels.",
     .isOn = [](const ViewSettings& view) { return !view.resolvedOutputs.empty(); },
     .set =
         [](ViewSettings& view, bool on) {
             if (!on)
                 view.resolvedOutputs.clear();
             else if (view.resolvedOutputs.empty())
                 view.resolvedOutputs = {{.value = AGAA_RESOLVED_MEAN_DEPTH}, {.value = AGAA_RESOLVED_NORMAL}};
         }},
    {.name = "composite",
     .need = "Frames are drawn over an image that exists.",
     .isOn = [](const ViewSettings& view) { return view.composite; },
     .set = [](ViewSettings& view, bool on) { view.composite = on; }},
    option<AGAA_CONFIG_COUNTERS>("counters", "The host measures shading events and errors."),
    option<AGAA_CONFIG_CHECK_FACTS>("fact-checks", "The host tests whether the facts of the scene hold."),
};

} // namespace

std::span<const Effect> effects() { return table; }

} // namespace agaa
