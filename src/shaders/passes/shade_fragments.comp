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

// Of each sample at hand, the nearest depth and its fragment.
float agaa_nearestDepth[AGAA_SAMPLES];
uint agaa_nearestFragment[AGAA_SAMPLES];

// Lets samples of a fragment take it where it is the nearest, or, where they are decided, takes from it all others. Loops are
// over samples that fragments cover, not over pairs of fragments: software rasterisers of Mesa end all loops of an invocation
// once they have turned 65535 times together.
void agaa_resolveFragment(uint fragment, uint record, bool isDecided) {
    uvec4 mask = agaa_maskOf(record);
    vec3 plane = agaa_keptPlane(record);
    uint id = agaa_fragments.words[record];
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word) {
        uint left = mask[word];
        while (left != 0u) {
            uint bit = left & (~left + 1u);
            uint i = word * 32u + uint(findLSB(left));
            vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES);
            float depth = plane.x + (plane.y * at.x + plane.z * at.y);
            uint other = agaa_nearestFragment[i];
            if (isDecided) {
                mask[word] ^= other != fragment ? bit : 0u;
            } else if (other == 0u || depth < agaa_nearestDepth[i] ||
                       (depth == agaa_nearestDepth[i] && id < agaa_fragments.words[agaa_record(max(other, 1u))])) {
                agaa_nearestDepth[i] = depth;
                agaa_nearestFragment[i] = fragment;
            }
            left ^= bit;
        }
    }
    if (isDecided)
        agaa_setMask(record, mask);
}

// Leaves each fragment the samples that show it; of equal depths the lower id shows.
void agaa_resolveList(uint head) {
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        agaa_nearestFragment[i] = 0u;
    for (uint turn = 0u; turn < 2u; ++turn) {
        uint fragment = head;
        while (fragment != 0u) {
            uint record = agaa_record(fragment);
            agaa_resolveFragment(fragment, record, turn == 1u);
            fragment = agaa_nextOf(record);
        }
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
