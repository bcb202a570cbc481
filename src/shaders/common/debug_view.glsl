// Debug views: values that the output shows in place of radiance (AgaaDebugView). Needs common/lighting.glsl before it
// if AGAA_SHADOWS is 1.
#ifndef AGAA_DEBUG_VIEW_GLSL
#define AGAA_DEBUG_VIEW_GLSL
#include "common/api_values.glsl"

#ifndef AGAA_SHADOWS
#define AGAA_SHADOWS 0
#endif
#if AGAA_SHADOWS && !defined(AGAA_LIGHTING_GLSL)
#error "debug_view.glsl needs lighting.glsl."
#endif

// Values of the current pixel, which passes set that know them.
uint agaa_shownPrimitives = 0u;
bool agaa_shownUnfetched = false; // some samples have a G-buffer in place of ids

// Colours that people with colour blindness distinguish (Okabe and Ito 2008).
vec3 agaa_clusterColor(uint aggregate) {
    const vec3 colors[6] = vec3[6](vec3(0.0, 0.17, 0.45), vec3(0.79, 0.35, 0.0), vec3(0.0, 0.34, 0.17),
                                   vec3(0.87, 0.78, 0.05), vec3(0.6, 0.19, 0.39), vec3(0.09, 0.46, 0.81));
    return colors[min(aggregate, 5u)];
}

vec3 agaa_tierColor(uint tier) {
    if (tier == AGAA_TIER_AUTO)
        return vec3(0.5);
    if (tier == AGAA_TIER_GBUFFER)
        return vec3(0.0, 0.17, 0.9);
    if (tier >= AGAA_TIER_FRAGMENT_LISTS)
        return vec3(0.8, 0.7, 0.0);
    return tier == AGAA_TIER_IDS ? vec3(0.0, 0.6, 0.2) : vec3(0.9, 0.4, 0.0);
}

bool agaa_showsEvents() { return AGAA_DEBUG_VIEW != AGAA_DEBUG_VIEW_NONE; }

// Returns the event's term of the mean that agaa_shownOfPixel() takes. diffuse: of its material.
vec3 agaa_shownOfEvent(uint aggregate, float widening, vec3 diffuse) {
    if (AGAA_DEBUG_VIEW == AGAA_DEBUG_VIEW_FACTS)
        return diffuse; // 1 if the material contradicts the facts (common/scene_facts.glsl)
    if (AGAA_DEBUG_VIEW == AGAA_DEBUG_VIEW_CLUSTERS)
        return agaa_clusterColor(aggregate);
    if (AGAA_DEBUG_VIEW == AGAA_DEBUG_VIEW_WIDENED)
        return vec3(widening);
#if AGAA_SHADOWS
    return vec3(agaa_visibility[0]);
#else
    return vec3(1.0);
#endif
}

vec3 agaa_shownOfPixel(uint events, vec3 mean) {
    switch (AGAA_DEBUG_VIEW) {
    case AGAA_DEBUG_VIEW_EVENTS:
    case AGAA_DEBUG_VIEW_AGGREGATES:
        return vec3(events);
    case AGAA_DEBUG_VIEW_PRIMITIVES:
        return vec3(agaa_shownPrimitives);
    case AGAA_DEBUG_VIEW_CLUSTERS:
    case AGAA_DEBUG_VIEW_LIT:
    case AGAA_DEBUG_VIEW_WIDENED:
    case AGAA_DEBUG_VIEW_FACTS:
        return mean;
    default:
        return agaa_tierColor(agaa_shownUnfetched ? AGAA_TIER_GBUFFER : AGAA_GENERATION_TIER) * (events == 0u   ? 0.0
                                                                                                 : events == 1u ? 0.5
                                                                                                                : 1.0);
    }
}
#endif
