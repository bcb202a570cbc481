// Shades each fragment of a pixel that shows at a sample, without merging: the depths of all fragments are compared at each
// sample. DCAA's reference.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/debug_view.glsl"
#include "passes/tile_pixels.glsl"
#include "passes/fragments.glsl"
#include "passes/covered_place.glsl"

#define AGAA_PLANE_WORD (2u + AGAA_SAMPLES / 32u)

vec3 agaa_keptPlane(uint record) {
    uint at = record + AGAA_PLANE_WORD;
    return vec3(uintBitsToFloat(agaa_fragments.words[at]), uintBitsToFloat(agaa_fragments.words[at + 1u]),
                uintBitsToFloat(agaa_fragments.words[at + 2u]));
}

void agaa_setMask(uint record, uvec4 mask) {
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_fragments.words[record + 2u + word] = mask[word];
}

uint agaa_nextOf(uint record) { return agaa_fragments.words[record + 1u]; }

// Keeps the planes of all fragments. What is at the far plane covers nothing.
void agaa_keepPlanes(uvec2 pixel, uint head) {
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_DepthPlane plane = agaa_planeOf(agaa_primitive(agaa_fragments.words[record]), pixel);
        vec3 kept = agaa_growingDepth(plane);
        for (uint k = 0u; k < 3u; ++k)
            agaa_fragments.words[record + AGAA_PLANE_WORD + k] = floatBitsToUint(kept[k]);
        if (agaa_isFar(plane))
            agaa_setMask(record, uvec4(0u));
        fragment = agaa_nextOf(record);
    }
}

// Takes from each fragment the samples that another one hides; of equal depths the lower id shows. What a hidden sample hides
// is hidden by a nearer one, too, so that masks may shrink on the way.
void agaa_resolveList(uint head) {
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        vec3 plane = agaa_keptPlane(record);
        uint other = head;
        while (other != 0u) {
            uint otherRecord = agaa_record(other);
            uvec4 both = agaa_maskOf(otherRecord) & mask;
            bool otherFirst = agaa_fragments.words[otherRecord] < agaa_fragments.words[record];
            if (other != fragment && agaa_coverageCount(both) != 0u)
                mask &= ~agaa_samplesBehind(plane, agaa_keptPlane(otherRecord), both, otherFirst, AGAA_SAMPLES);
            other = agaa_nextOf(otherRecord);
        }
        agaa_setMask(record, mask);
        fragment = agaa_nextOf(record);
    }
}

// Radiance, or agaa_shownOfEvent(), times the number of samples.
vec3 agaa_shadeFragment(uvec2 pixel, uint record, uvec4 mask) {
    vec3 plane = agaa_keptPlane(record);
    vec2 middle = agaa_coverageMiddle(mask, AGAA_SAMPLES);
    vec3 position = agaa_surfacePosition(pixel, plane, middle);
    agaa_tapSurface(pixel, plane, mask, position);
    float weight = float(agaa_coverageCount(mask));
    if (agaa_showsEvents())
        return agaa_shownOfEvent(0u, 0.0) * weight;
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    agaa_moveTo(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_fetchMaterialThere(p);
    agaa_widenByCurvature(m, mask);
    return agaa_lightSurface(agaa_surfaceOfMaterial(m), position) * weight;
}

void agaa_shadePixel(uvec2 pixel) {
    uint head = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size.xy)];
    agaa_keepPlanes(pixel, head);
    agaa_resolveList(head);
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
    if (AGAA_DEBUG_VIEW != 0u)
        agaa_writeOutput(pixel, agaa_shownOfPixel(events, color / float(max(covered, 1u))), AGAA_SAMPLES);
    else
        agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), covered);
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (all(lessThan(pixel, agaa_frame.size.xy)))
        agaa_shadePixel(pixel);
    agaa_countEnd();
}
