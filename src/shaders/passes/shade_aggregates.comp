// Shading once per aggregate, weighted by its share of the pixel's samples (AGAA section 3.5), or once per
// surface that one of its samples represents (SBAA).
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
#include "passes/aggregate.glsl"
#include "math/encoding.glsl"
#include "math/records.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "passes/tile.glsl"

#if AGAA_COUNTING
#ifdef AGAA_HOST_GBUFFER
bool agaa_isVisible(uvec2 pixel, uint i) { return agaa_hostShows(pixel, i); }
#else
layout(AGAA_AT_SURFACE0) uniform AGAA_TARGET_TEXTURE agaa_normals;

bool agaa_isVisible(uvec2 pixel, uint i) {
    vec4 texel = AGAA_FETCH(agaa_normals, pixel, i);
    // Of an id, which is not 0, any byte may be.
    return AGAA_COVERAGE_COMPONENT < 4u ? texel[AGAA_COVERAGE_COMPONENT & 3u] > 0.0 : texel != vec4(0.0);
}
#endif
#endif
layout(std430, AGAA_AT_AGGREGATES) readonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

uint agaa_base = 0u;   // first word of the aggregate at hand
uint agaa_count_ = 0u; // its samples

uint agaa_field(uint field) {
    uint bits = field >> 16;
    uint word = agaa_aggregates.words[agaa_base + (field & 0xFFu)];
    return bitfieldExtract(word, int(field >> 8u & 0xFFu), int(bits));
}

#if AGAA_REPRESENTED
uvec2 agaa_record() {
    return uvec2(agaa_aggregates.words[agaa_base + AGAA_WORDS],
                 AGAA_SAMPLES > 16u ? agaa_aggregates.words[agaa_base + AGAA_WORDS + 1u] : 0u);
}

// A surface that no fragment was kept for shows nothing.
uint agaa_coverage() {
    return agaa_field(AGAA_FIELD_COVERAGE) != 0u ? agaa_recordSamples(agaa_record(), AGAA_SAMPLES) : 0u;
}

float agaa_mean(uint field) { return agaa_meanOfSum(agaa_field(field), 1u, field >> 16); }
#else
uint agaa_coverage() { return agaa_field(AGAA_FIELD_COVERAGE); }

// Sums take log2(n) bits more than one fragment's value.
float agaa_mean(uint field) {
    uint growth = uint(findMSB(AGAA_SAMPLES));
    return agaa_meanOfSum(agaa_field(field + (growth << 16)), agaa_count_, field >> 16);
}
#endif

vec3 agaa_mean3(uint r, uint g, uint b) { return vec3(agaa_mean(r), agaa_mean(g), agaa_mean(b)); }

agaa_Means agaa_aggregateMeans() {
    agaa_Means m;
    m.diffuse = agaa_mean3(AGAA_FIELD_DIFFUSE_R, AGAA_FIELD_DIFFUSE_G, AGAA_FIELD_DIFFUSE_B);
    m.normal = agaa_mean3(AGAA_FIELD_NORMAL_X, AGAA_FIELD_NORMAL_Y, AGAA_FIELD_NORMAL_Z) * 2.0 - 1.0;
    m.lengthBound = agaa_storedLengthBound(1u, AGAA_FIELD_NORMAL_X >> 16);
    m.specular = vec3(0.0);
    m.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        m.specular = agaa_mean3(AGAA_FIELD_SPECULAR_R, AGAA_FIELD_SPECULAR_G, AGAA_FIELD_SPECULAR_B);
        if (AGAA_YCBCR_SPECULAR != 0u)
            m.specular = max(agaa_yCbCrToRgb(m.specular), vec3(0.0));
        if (AGAA_FIELD_ROUGHNESS >> 16 != 0u)
            m.alpha2 = agaa_mean(AGAA_FIELD_ROUGHNESS);
    }
    m.emissive = vec3(0.0);
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        m.emissive = agaa_frame.ambient.w *
                     agaa_mean3(AGAA_FIELD_EMISSIVE_R, AGAA_FIELD_EMISSIVE_G, AGAA_FIELD_EMISSIVE_B);
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        m.emissive = agaa_frame.ambient.w * agaa_mean(AGAA_FIELD_EMISSIVE_R) * m.diffuse;
    return m;
}

void agaa_selectAggregate(uvec2 pixel, uint a) {
    agaa_base = ((pixel.y * agaa_frame.size.x + pixel.x) * AGAA_AGGREGATES + a) * AGAA_STRIDE;
}

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_PixelWork work = agaa_PixelWork(0u, 0u, 0u);
    uint coveredMask = 0u;
    uint twice = 0u;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
        agaa_selectAggregate(pixel, a);
        uint mask = agaa_coverage();
        work.events |= mask != 0u ? 1u << a : 0u;
        work.covered += uint(bitCount(mask));
        twice |= coveredMask & mask;
        coveredMask |= mask;
    }
#if AGAA_COUNTING
    uint visible = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isVisible(pixel, i))
            visible |= 1u << i;
    uint once = uint(bitCount(visible & coveredMask));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(visible)));
    agaa_count(AGAA_COUNT_ONCE, once);
    agaa_count(AGAA_COUNT_MISSED, uint(bitCount(visible & ~coveredMask)));
    agaa_count(AGAA_COUNT_MULTI, work.covered - once);
    uint missed = visible & ~coveredMask;
    uint multi = twice | (coveredMask & ~visible);
    if ((missed | multi) != 0u)
        agaa_reportPixel(pixel, visible, missed, multi);
    agaa_count(AGAA_COUNT_EVENTS, uint(bitCount(work.events)));
    agaa_count(AGAA_COUNT_AGGREGATES, uint(bitCount(work.events)));
    agaa_count(AGAA_COUNT_PIXELS, work.events != 0u ? 1u : 0u);
#endif
    return work;
}

vec3 agaa_shadeEvent(uvec2 pixel, uint a) {
    agaa_selectAggregate(pixel, a);
    uint mask = agaa_coverage();
    agaa_count_ = uint(bitCount(mask));
    vec3 position = agaa_placeAggregate(pixel, mask);
#if AGAA_REPRESENTED
    uint shaded = agaa_recordShaded(agaa_record(), AGAA_SAMPLES);
    position = agaa_toShadingSpace(
        agaa_sampleViewPosition(pixel, shaded, agaa_depthOf(pixel, shaded)));
#endif
    return agaa_shadeMeans(pixel, position, a, mask, agaa_aggregateMeans(), AGAA_FOLDED_ROUGHNESS != 0u);
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
