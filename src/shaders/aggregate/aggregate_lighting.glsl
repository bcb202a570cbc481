// Shading of an aggregate, wherever its sums are stored: its position, its shadows, and its means as a surface. Needs
// common/target.glsl and common/lighting.glsl.
#ifndef AGAA_AGGREGATE_LIGHTING_GLSL
#define AGAA_AGGREGATE_LIGHTING_GLSL
#if !defined(AGAA_TARGET_GLSL) || !defined(AGAA_LIGHTING_GLSL)
#error "aggregate_lighting.glsl needs target.glsl and lighting.glsl."
#endif
#ifndef AGAA_SAMPLE_LANES
#define AGAA_SAMPLE_LANES 0
#endif
#include "aggregate/lane_words.glsl"
#include "aggregate/shadow_taps.glsl"
#include "aggregate/mean_surface.glsl"
#include "common/event_light.glsl"
#include "common/sample_depth.glsl"
#include "math/encoding.glsl"
#include "math/statistics.glsl"

vec3 agaa_viewPositionOf(uvec2 pixel, uint i) {
    return agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
}

// Adds shadow taps at up to AGAA_SHADOW_TAPS of these samples, evenly chosen. Returns the number of taps.
uint agaa_tapSomeSamples(uvec2 pixel, uint mask) {
    uint taps = min(uint(bitCount(mask)), AGAA_SHADOW_TAPS);
    agaa_Choice choice = agaa_chooseFrom(mask, taps);
    for (uint j = 0u; j < taps; ++j)
        agaa_addTaps(agaa_toShadingSpace(agaa_viewPositionOf(pixel, agaa_nextSample(choice, j))));
    return taps;
}

// Adds shadow taps along the view ray, by the spread of the samples' depths. Returns the number of taps.
uint agaa_tapAlongDepth(vec3 mean, float sigma, float lowest, float highest) {
    uint taps = sigma > 0.0 ? 4u : 1u;
    for (uint j = 0u; j < taps; ++j) {
        float z = taps > 1u ? agaa_depthTap(j, mean.z, sigma, lowest, highest) : mean.z;
        float along = abs(mean.z) > 0.0 ? z / mean.z : 1.0;
        agaa_addTaps(agaa_toShadingSpace(agaa_isOrthographic() != 0u ? vec3(mean.xy, z) : mean * along));
    }
    return taps;
}

// Adds shadow taps along the longest axis of the aggregate, by the covariance of its samples' positions. Returns the
// number of taps.
uint agaa_tapLongestAxis(vec3 mean) {
    vec3 axis;
    float sigma = sqrt(agaa_longestAxis(agaa_footprint, axis));
    uint taps = sigma > 0.0 ? 4u : 1u;
    for (uint j = 0u; j < taps; ++j)
        agaa_addTaps(mean + agaa_depthTap(j, 0.0, sigma, -2.0 * sigma, 2.0 * sigma) * axis);
    return taps;
}

// Returns the mean position of all samples. Finds their spread around it, and the aggregate's share of each shadow
// map's light: at some of its samples, at all of them, along the view ray or at the mean position.
vec3 agaa_locateAggregate(uvec2 pixel, uint mask) {
    agaa_lightPixel(pixel);
    agaa_setEvent(pixel, uvec4(mask, 0u, 0u, 0u));
    uint count = uint(bitCount(mask));
    vec3 mean = vec3(0.0);
    vec3 first = vec3(0.0);
    float squares = 0.0;
    agaa_beginFootprint();
    float lowest = 0.0;
    float highest = 0.0;
    agaa_Moments depthMoments = agaa_momentsInit(0.0);
#if AGAA_SHADOWS
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] = 0.0;
#endif
    const bool tapsAll = AGAA_SHADOW_FILTER == AGAA_SHADOW_AT_SAMPLES && AGAA_SAMPLES <= AGAA_SHADOW_TAPS;
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        vec3 position = agaa_viewPositionOf(pixel, uint(findLSB(rest)));
        if (rest == mask) { // sums are relative to the first sample (hard case 14)
            first = position;
            lowest = highest = position.z;
            depthMoments = agaa_momentsInit(position.z);
        }
        mean += position - first;
        squares += dot(position - first, position - first);
        agaa_addToFootprint(1.0, position - first);
        if (AGAA_SHADOW_FILTER == AGAA_SHADOW_ALONG_DEPTH) {
            agaa_momentsAdd(depthMoments, position.z);
            lowest = min(lowest, position.z);
            highest = max(highest, position.z);
        }
        if (tapsAll)
            agaa_addTaps(agaa_toShadingSpace(position));
    }
    mean /= float(count);
    float spread = max(squares / float(count) - dot(mean, mean), 0.0);
    agaa_endFootprintAroundMean(float(count), mean);
    mean += first;
    vec3 position = agaa_toShadingSpace(mean);
#if AGAA_SHADOWS
    uint taps = count;
    if (AGAA_SHADOW_FILTER == AGAA_SHADOW_COVARIANCE) {
        taps = agaa_tapLongestAxis(position);
    } else if (AGAA_SHADOW_FILTER != AGAA_SHADOW_AT_SAMPLES) {
        float sigma = AGAA_SHADOW_FILTER == AGAA_SHADOW_ALONG_DEPTH ? sqrt(agaa_momentsVariance(depthMoments)) : 0.0;
        taps = agaa_tapAlongDepth(mean, sigma, lowest, highest);
    } else if (!tapsAll) {
        taps = agaa_tapSomeSamples(pixel, mask);
    }
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] /= float(taps);
    agaa_lookUpFootprint(position);
#endif
    agaa_setSpread(spread, position);
    return position;
}

#if AGAA_LIT
// The share of a shadow's light that reaches each sample of the current aggregate.
#if AGAA_SAMPLE_LANES
void agaa_setLight(uint i, float light) {
    AGAA_LANE_WORD(gl_LocalInvocationIndex, i) = floatBitsToUint(light);
}
float agaa_lightOf(uint i) { return uintBitsToFloat(AGAA_LANE_WORD(gl_LocalInvocationIndex, i)); }
#else
float agaa_sampleLight[AGAA_SAMPLES];
void agaa_setLight(uint i, float light) { agaa_sampleLight[i] = light; }
float agaa_lightOf(uint i) { return agaa_sampleLight[i]; }
#endif

// Looks the shadow up at samples, without counting the taps. Returns the sum of agaa_lightOf() over them.
float agaa_lightSamples(uvec2 pixel, uint map, uint mask) {
    float sum = 0.0;
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float light = agaa_uncountedTap(map, agaa_toShadingSpace(agaa_viewPositionOf(pixel, i)));
        agaa_setLight(i, light);
        sum += light;
    }
    return sum;
}

// Returns the samples of a mask that lights with the shadow reach.
uint agaa_reachedSamples(uint map, uint mask) { return (agaa_reachingShadows >> map & 1u) != 0u ? mask : 0u; }

// Returns the scale of weights whose sum becomes 1, or 0 without light.
float agaa_lightScale(float sum) { return sum > 1e-6 ? 1.0 / sum : 0.0; }

// The part of an aggregate that the light of a shadow reaches.
struct agaa_LitPart {
    float light;      // sum over the samples
    agaa_Means means; // over the samples, weighted by their light
};

// An includer that defines AGAA_HAS_LIT_PART defines agaa_litPart(). Others define agaa_litMeans(), which returns sums
// over a pixel's samples, each weighted by scale * agaa_lightOf().
// mask   Samples that the light reaches.
#ifdef AGAA_HAS_LIT_PART
agaa_LitPart agaa_litPart(uvec2 pixel, uint map, uint mask);
#else
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale);

agaa_LitPart agaa_litPart(uvec2 pixel, uint map, uint mask) {
    float light = agaa_lightSamples(pixel, map, mask);
    return agaa_LitPart(light, agaa_litMeans(pixel, mask, agaa_lightScale(light)));
}
#endif

// Finds, for the shadow of each key light, the share of the samples that the light reaches and the means over these
// samples.
void agaa_findLitSurfaces(uvec2 pixel, uint mask, vec3 toEye) {
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map) {
        if (!agaa_isLitShadow(map))
            continue;
        const uint reached = agaa_reachedSamples(map, mask);
        agaa_LitPart lit = agaa_litPart(pixel, map, reached);
        agaa_countTaps(map, uint(bitCount(reached)));
        agaa_setLitSurface(map, lit.light / float(bitCount(mask)), agaa_surfaceOfMeans(lit.means, false, toEye));
    }
}
#endif

// Returns the radiance of an aggregate, times the number of its samples. Call agaa_locateAggregate() first.
vec3 agaa_shadeMeans(uvec2 pixel, vec3 position, uint a, uint mask, agaa_Means means, bool folded) {
    vec3 toEye = agaa_toEye(position);
    agaa_Surface s = agaa_surfaceOfMeans(means, folded, toEye);
    agaa_setEventMeans(means);
#ifdef AGAA_HOST_SHADING
    agaa_eventAlpha2 = folded ? s.alpha2 : agaa_eventAlpha2;
#endif
    agaa_countWidening(means, s);
#if AGAA_LIT
    agaa_findLitSurfaces(pixel, mask, toEye);
#endif
    return agaa_eventLight(a, agaa_widening(means, s), s, position) * float(bitCount(mask));
}
#endif
