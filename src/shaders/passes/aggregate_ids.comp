// Aggregates of what a pixel's ids name, shaded at once: nothing but the image goes to memory.
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
#include "passes/primitives.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#define AGAA_OWN_TILE
#include "passes/tile.glsl"

agaa_PixelWork agaa_countedWork(uvec2 pixel, uint count, uint covered, uint missed) {
    uint samples = uint(bitCount(covered));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(covered | missed)));
    agaa_count(AGAA_COUNT_ONCE, samples);
#if AGAA_COUNTING
    agaa_count(AGAA_COUNT_MISSED, uint(bitCount(missed)));
    if (missed != 0u)
        agaa_reportPixel(pixel, covered | missed, missed, 0u);
#endif
    agaa_count(AGAA_COUNT_EVENTS, count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_PixelWork((1u << count) - 1u, 0u, samples);
}

uint agaa_laneOf(uvec2 pixel) { return (pixel.y & 7u) * 8u + (pixel.x & 7u); }

float agaa_weightOf(uint i, bool isLit) {
#if AGAA_LIT
    if (isLit)
        return agaa_sampleLight[i];
#endif
    return 1.0;
}

// Sums of places in the pixel and of their products, over samples of the weight scale * agaa_weightOf().
struct agaa_Places {
    float weight;
    vec2 sum;
    vec3 products; // xx, yy, xy
};

agaa_Places agaa_placesOf(uint samples, float scale, bool isLit) {
    agaa_Places p = agaa_Places(0.0, vec2(0.0), vec3(0.0));
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float weight = scale * agaa_weightOf(i, isLit);
        vec2 place = agaa_frame.samplePosition[i].xy;
        p.weight += weight;
        p.sum += weight * place;
        p.products += weight * vec3(place * place, place.x * place.y);
    }
    return p;
}

// Normals of a primitive that grow evenly across the pixel: as one in their middle, with the spread around it.
void agaa_addCurved(inout agaa_Means m, AgaaMaterial material, agaa_Places places) {
    vec2 middle = places.sum / places.weight;
    vec3 n = material.normal + middle.x * material.normalDx + middle.y * material.normalDy;
    float scale = inversesqrt(max(dot(n, n), 1e-6));
    n *= scale;
    vec3 u = scale * material.normalDx;
    vec3 v = scale * material.normalDy;
    vec3 spread = places.products / places.weight - vec3(middle * middle, middle.x * middle.y);
    spread.xy = max(spread.xy, vec2(0.0));
    vec3 squares = spread.x * u * u + spread.y * v * v + 2.0 * spread.z * u * v;
    float total = 1.0 + max(squares.x + squares.y + squares.z, 0.0);
    m.normal += places.weight * inversesqrt(total) * n;
    if (AGAA_HAS_SPECULAR != 0u && AGAA_NDF >= agaa_ndfLean) {
        float share = places.weight / total;
        agaa_addNormalMoments(m.moments, share, n);
        m.moments.squares += share * squares;
        m.moments.mixed += share * (spread.x * u.yzx * u.zxy + spread.y * v.yzx * v.zxy +
                                    spread.z * (u.yzx * v.zxy + u.zxy * v.yzx));
    }
}

// Adds the samples `own` of the primitive that is listed at `at`.
void agaa_addListed(inout agaa_Means m, uint at, uint own, float scale, bool isLit) {
    bool isCurved = agaa_isCurved(at);
    agaa_Places places = agaa_placesOf(isCurved || isLit ? own : 0u, scale, isLit);
    float weight = isCurved || isLit ? places.weight : scale * float(bitCount(own));
    agaa_Surface s = agaa_listedSurface(at);
    agaa_addMaterial(m, weight, s);
    if (!isCurved)
        agaa_addNormal(m, weight, s.normal);
    else if (weight > 0.0)
        agaa_addCurved(m, agaa_listMaterial[at], places);
}

agaa_Means agaa_meansOf(uvec2 pixel, uint mask, float scale, bool isLit) {
    agaa_Means m = agaa_noMeans();
    uint list = agaa_pixelList[agaa_laneOf(pixel)];
    uint end = (list & 0xFFFFu) + (list >> 16u);
    for (uint at = list & 0xFFFFu; at < end; ++at) {
        uint own = agaa_listSamples[at] & mask;
        if (own != 0u)
            agaa_addListed(m, at, own, scale, isLit);
    }
    return m;
}

#if AGAA_LIT
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) { return agaa_meansOf(pixel, mask, scale, true); }
#endif

vec3 agaa_shadeEvent(uvec2 pixel, uint a) {
    uint mask = agaa_masks[agaa_laneOf(pixel) * AGAA_AGGREGATES + a];
    agaa_Means means = agaa_meansOf(pixel, mask, 1.0 / float(bitCount(mask)), false);
    return agaa_shadeMeans(pixel, agaa_placeAggregate(pixel, mask), a, mask, means, false);
}

void agaa_takePixel(bool isHeld, uvec2 corner, uvec2 pixel, uint covered, uint missed) {
    agaa_PixelWork work = agaa_PixelWork(0u, 0u, 0u);
    if (isHeld)
        work = agaa_countedWork(pixel, agaa_aggregateCount[gl_LocalInvocationIndex], covered, missed);
    vec3 color = agaa_shadeWork(work, corner);
    if (isHeld)
        agaa_writePixel(pixel, work, color);
}

void main() {
    agaa_countBegin();
    uvec2 corner = gl_WorkGroupID.xy * 8u;
    uvec2 pixel = corner + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(pixel, agaa_frame.size.xy));
    uint covered = inside ? agaa_loadIds(pixel) : 0u;
    if (inside && covered == 0u)
        agaa_writePixel(pixel, agaa_PixelWork(0u, 0u, 0u), vec3(0.0));
    agaa_takeTile(corner, pixel, covered);
    agaa_countEnd();
}
