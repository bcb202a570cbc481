// Writes the values of AgaaResolvedOutputs. The plan defines where they come from:
//   AGAA_RESOLVES_SAMPLES   materials of samples (gbuffer/gbuffer.glsl)
//   AGAA_RESOLVES_SUMS      sums of shading events (common/resolve_event.glsl)
//   AGAA_RESOLVES_DEPTHS    depths of samples
// Besides the macros of common/resolved_values.glsl it writes
//   AGAA_RESOLVED_IMAGES     declares the images
//   AGAA_STORE_VALUES(at)    stores the values of the pixel into them
//   AGAA_SUMMED_DEPTHS       arguments of agaa_setDepths(), if no depth buffer has depths
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/output_place.glsl"
#include "common/target.glsl"
#define AGAA_COUNTING 0 // materials are evaluated again, for no event
#include "common/counters.glsl"
#include "math/encoding.glsl"
#include "math/ordered_bits.glsl"
#include "math/pixel_sums.glsl"
#if AGAA_RESOLVES_DEPTHS
#include "common/sample_depth.glsl"
#endif
#if AGAA_RESOLVES_SAMPLES
#include "gbuffer/gbuffer.glsl"
#endif

AGAA_RESOLVED_IMAGES

uint agaa_sums[AGAA_RESOLVED_WORDS];
void agaa_addToSum(uint word, uint amount) { agaa_sums[word] += amount; }
void agaa_raiseSum(uint word, uint least) { agaa_sums[word] = max(agaa_sums[word], least); }
#include "common/resolved_values.glsl"

float agaa_nearestDepth = float(AGAA_FAR_DEPTH);
float agaa_meanDepth = float(AGAA_FAR_DEPTH);

// AGAA_STORE_VALUES calls these functions.
float agaa_resolvedMean(uint word) { return agaa_meanOfTerms(agaa_sums[word], agaa_sums[0]); }
float agaa_resolvedCode(uint word, uint shift, uint bits) {
    return agaa_meanOfSum(bitfieldExtract(agaa_sums[word], int(shift), int(bits)), 1u, bits);
}
float agaa_resolvedCoverage() { return float(agaa_sums[0]) / float(AGAA_SAMPLES); }

void agaa_setDepths(uint nearness, float mean) {
    agaa_nearestDepth = agaa_depthOfNearness(nearness);
    agaa_meanDepth = mean;
}

#if AGAA_RESOLVES_SUMS
layout(std430, AGAA_BINDING_RESOLVED_SUMS) readonly buffer agaa_ResolvedBlock { uint words[]; } agaa_resolved;

void agaa_loadSums(uvec2 pixel) {
    uint first = (pixel.y * agaa_frame.size.x + pixel.x) * AGAA_RESOLVED_WORDS;
    for (uint word = 0u; word < AGAA_RESOLVED_WORDS; ++word)
        agaa_sums[word] = agaa_resolved.words[first + word];
}
#endif

#if AGAA_RESOLVES_SAMPLES
// Returns those of these samples whose material is that of sample i.
uint agaa_samplesOfMaterial(uvec2 pixel, uint i, uint samples) {
#ifdef AGAA_SAMPLE_IDS_GLSL
    return agaa_samplesOfPrimitive(pixel, i, samples);
#else
    return 1u << i;
#endif
}

void agaa_addMaterials(uvec2 pixel, uint shown) {
    for (uint rest = shown; rest != 0u;) {
        uint i = uint(findLSB(rest));
        uint samples = agaa_samplesOfMaterial(pixel, i, rest);
        agaa_fetchEvent(pixel, i, samples);
        AGAA_ADD_VALUES(float(bitCount(samples)), agaa_fetchedNormal(), agaa_fetchedCustom().custom)
        rest &= ~samples;
    }
}
#endif

#if AGAA_RESOLVES_DEPTHS
bool agaa_isShown(uvec2 pixel, uint i) {
#if AGAA_RESOLVES_SAMPLES
    return agaa_isCovered(pixel, i);
#else
    return agaa_depthOf(pixel, i) != float(AGAA_FAR_DEPTH);
#endif
}

void agaa_resolveSamples(uvec2 pixel) {
    uint shown = 0u;
    uint nearness = 0u;
    float sum = 0.0;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isShown(pixel, i)) {
            float depth = agaa_depthOf(pixel, i);
            shown |= 1u << i;
            nearness = max(nearness, agaa_nearness(depth));
            sum += depth;
        }
    uint count = uint(bitCount(shown));
    if (AGAA_RESOLVES_SUMS == 0)
        agaa_sums[0] = count;
    if (count != 0u)
        agaa_setDepths(nearness, sum / float(count));
#if AGAA_RESOLVES_SAMPLES
    agaa_addMaterials(pixel, shown);
#endif
}
#endif

void agaa_resolvePixel(uvec2 pixel) {
    for (uint word = 0u; word < AGAA_RESOLVED_WORDS; ++word)
        agaa_sums[word] = 0u;
#if AGAA_RESOLVES_SUMS
    agaa_loadSums(pixel);
#endif
#if AGAA_RESOLVES_DEPTHS
    agaa_resolveSamples(pixel);
#elif defined(AGAA_SUMMED_DEPTHS)
    if (agaa_sums[0] != 0u)
        agaa_setDepths(AGAA_SUMMED_DEPTHS);
#endif
    AGAA_STORE_VALUES(agaa_placeInWritten(ivec2(pixel)))
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, agaa_frame.size)))
        agaa_resolvePixel(pixel);
}
