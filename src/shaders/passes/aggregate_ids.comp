// Aggregates of what a pixel's ids name, shaded at once: samples are grouped, each primitive's material is evaluated
// once an aggregate, in the middle of the samples that it has there, and nothing but the image goes to memory.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES 32
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/aggregate.glsl"
#include "passes/samples.glsl"
#include "math/surfaces.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "passes/tile.glsl"

shared uint agaa_masks[64u * AGAA_AGGREGATES]; // samples of each aggregate of the tile's pixels

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    uint count = samples.covered != 0u ? 1u : 0u;
    if (AGAA_AGGREGATES > 1u && count != 0u &&
        !agaa_areAllOneSurface(agaa_sampleCount(), samples.covered, agaa_frame.surface.x,
                               agaa_surfaceWidth(samples)))
        count = agaa_defineAggregates(agaa_sampleCount(), samples.covered, AGAA_AGGREGATES,
                                      agaa_pixelCharacteristicLength(samples), agaa_frame.cluster.z,
                                      AGAA_SEEDS);
    uint base = gl_LocalInvocationIndex * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
    uint covered = uint(bitCount(samples.covered));
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_EVENTS, count);
    agaa_count(AGAA_COUNT_PIXELS, count != 0u ? 1u : 0u);
    return agaa_PixelWork((1u << count) - 1u, 0u, covered);
}

// The means over samples: of each primitive as often as it has samples.
agaa_Means agaa_meansOf(uvec2 pixel, uint mask) {
    agaa_Means m = agaa_Means(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 1e-6);
    for (uint left = mask; left != 0u;) {
        uint id = agaa_idOf(pixel, uint(findLSB(left)));
        vec2 middle = vec2(0.0);
        float count = 0.0;
        for (uint rest = left; rest != 0u; rest &= rest - 1u) {
            uint i = uint(findLSB(rest));
            if (agaa_idOf(pixel, i) == id) {
                left &= ~(1u << i);
                middle += agaa_frame.samplePosition[i].xy;
                count += 1.0;
            }
        }
        AgaaMaterial one = agaa_fetchMaterial(pixel, id, middle / count);
        m.diffuse += count * one.diffuse;
        m.specular += count * one.specular;
        m.emissive += count * one.emissive;
        m.normal += count * one.normal;
        m.alpha2 += count * one.alpha2;
    }
    float share = 1.0 / float(bitCount(mask));
    m.diffuse *= share;
    m.specular *= share;
    m.emissive *= share;
    m.normal *= share;
    m.alpha2 *= share;
    if (AGAA_HAS_SPECULAR == 0u)
        m.specular = vec3(0.0);
    if (AGAA_EMISSIVE_CHANNELS == 0u)
        m.emissive = vec3(0.0);
    return m;
}

vec3 agaa_shadeEvent(uvec2 pixel, uint a) {
    uvec2 place = pixel & 7u;
    uint mask = agaa_masks[(place.y * 8u + place.x) * AGAA_AGGREGATES + a];
    vec3 position = agaa_placeAggregate(pixel, mask);
    agaa_Surface s = agaa_surfaceOfMeans(agaa_meansOf(pixel, mask), false, agaa_toEye(position));
    return agaa_lightSurface(s, position) * float(bitCount(mask));
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
