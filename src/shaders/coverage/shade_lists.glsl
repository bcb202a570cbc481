// Shades each fragment of a pixel that shows at a sample, without merging. The includer defines agaa_Surface
// agaa_materialOf(uvec2 pixel, uint record, uvec4 mask, vec2 middle), which returns the material for the samples of the
// mask, whose centroid is `middle`. Needs AGAA_FINDS_LIGHTS, common/output.glsl,
// coverage/list_visibility.glsl and what coverage/pixel_order.glsl needs.
#if !defined(AGAA_FINDS_LIGHTS) || !defined(AGAA_OUTPUT_GLSL) || !defined(AGAA_LIST_VISIBILITY_GLSL)
#error "shade_lists.glsl needs AGAA_FINDS_LIGHTS, output.glsl and list_visibility.glsl."
#endif
#include "common/event_light.glsl"
#include "coverage/listed_tiles.glsl"
#include "coverage/list_box.glsl"
#include "coverage/pixel_order.glsl"

// Returns radiance, or agaa_shownOfEvent(), times the number of samples.
vec3 agaa_shadeFragment(uvec2 pixel, uint record, uvec4 mask) {
    agaa_DepthPlane plane = agaa_keptPlane(record);
    vec2 middle = agaa_coverageMiddle(mask, AGAA_SAMPLES);
    vec3 position = agaa_surfacePosition(pixel, plane, middle);
    agaa_tapSurface(pixel, plane, mask, position);
    float weight = float(agaa_coverageCount(mask));
    agaa_Surface s = agaa_materialOf(pixel, record, mask, middle);
    return agaa_eventLight(0u, 0.0, s, position) * weight;
}

// head: of the resolved list.
void agaa_shadePixel(uvec2 pixel, uint head) {
    agaa_lightPixel(pixel);
    vec3 color = vec3(0.0);
    uint covered = 0u;
    uint events = 0u;
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        uint count = agaa_coverageCount(mask);
        if (count != 0u) {
            color += agaa_shadeFragment(pixel, record, mask);
            covered += count;
            ++events;
        }
        fragment = agaa_nextOf(record);
    }
    agaa_countEvents(events);
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_AGGREGATES, events);
    agaa_count(AGAA_COUNT_PIXELS, events != 0u ? 1u : 0u);
    bool isWhole = AGAA_NORMALISES != 0u && covered != 0u &&
                   agaa_fragments.words[agaa_boundOf(pixel, agaa_frame.size)] != 0u;
    if (isWhole) {
        color *= float(AGAA_SAMPLES) / float(covered);
        covered = AGAA_SAMPLES;
    }
    if (AGAA_DEBUG_VIEW != AGAA_DEBUG_VIEW_NONE)
        agaa_writeOutput(pixel, agaa_shownOfPixel(events, color / float(max(covered, 1u))), AGAA_SAMPLES);
    else
        agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), covered);
}

void main() {
    agaa_countBegin();
    agaa_countDraw();
    bool isListed = agaa_isTileListed();
    agaa_orderPixels(isListed);
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool isInside = all(lessThan(pixel, agaa_frame.size));
    uint head = 0u;
    agaa_beginTileLights();
    if (isInside && isListed) {
        head = agaa_resolveList(pixel);
        agaa_addToTile(agaa_boxOfList(pixel, head));
    }
    agaa_findTileLights();
    if (AGAA_LIGHT_WORDS != 0u)
        barrier();
    if (isInside && isListed)
        agaa_shadePixel(pixel, head);
    else if (isInside)
        agaa_awaitDraw(pixel);
    agaa_countEnd();
}
