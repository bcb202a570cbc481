// The light of a shading event in the sum of its pixel. Needs common/lighting.glsl and common/output.glsl.
#ifndef AGAA_EVENT_LIGHT_GLSL
#define AGAA_EVENT_LIGHT_GLSL
#if !defined(AGAA_LIGHTING_GLSL) || !defined(AGAA_OUTPUT_GLSL)
#error "event_light.glsl needs lighting.glsl and output.glsl."
#endif
#include "common/debug_view.glsl"
#include "common/resolve_event.glsl"

// Returns agaa_weightedLight(), or with a debug view agaa_shownOfEvent().
vec3 agaa_eventLight(uint aggregate, float widening, agaa_Surface s, vec3 position) {
    agaa_resolveEvent(s.normal * s.meanLength, position);
    return agaa_showsEvents() ? agaa_shownOfEvent(aggregate, widening, s.diffuse)
                              : agaa_weightedLight(agaa_lightSurface(s, position));
}
#endif
