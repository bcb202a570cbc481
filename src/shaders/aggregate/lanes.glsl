// Operations on the lanes of a pixel, in passes with one lane per sample. Neighbouring lanes have the samples of one
// pixel. All lanes of the workgroup must call each function. Values are exchanged by subgroup operations with
// AGAA_SUBGROUPS, otherwise through shared memory.
//
// With AGAA_SUBGROUPS all subgroups must be full, and a subgroup must have at least as many lanes as a pixel.
#ifndef AGAA_LANES_GLSL
#define AGAA_LANES_GLSL
#include "aggregate/lane_words.glsl"

// The number of lanes of a pixel: n, rounded up to a power of two.
const uint agaa_pixelLanes = AGAA_SAMPLES <= 1u    ? 1u
                             : AGAA_SAMPLES <= 2u  ? 2u
                             : AGAA_SAMPLES <= 4u  ? 4u
                             : AGAA_SAMPLES <= 8u  ? 8u
                             : AGAA_SAMPLES <= 16u ? 16u
                                                   : 32u;
// The number of pixels that a workgroup processes at a time.
const uint agaa_pixelsAtOnce = 64u / agaa_pixelLanes;

#if AGAA_SUBGROUPS
// APIs do not define how gl_LocalInvocationIndex maps to subgroups.
uint agaa_laneIndex() { return gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID; }
#else
uint agaa_laneIndex() { return gl_LocalInvocationIndex; }
#endif

// Returns the first lane of this lane's pixel.
uint agaa_firstLane() { return agaa_laneIndex() & ~(agaa_pixelLanes - 1u); }

// Returns the sample of this lane; it may be n or more.
uint agaa_laneSample() { return agaa_laneIndex() & (agaa_pixelLanes - 1u); }

// Returns the index of this lane's pixel in an iteration, [0, 63].
uint agaa_lanePixel(uint iteration) { return iteration * agaa_pixelsAtOnce + agaa_laneIndex() / agaa_pixelLanes; }

#if AGAA_SUBGROUPS
// Separates writes to the words of lanes from reads by other lanes of the pixel, and reads from later writes.
void agaa_syncLanes() {
    subgroupMemoryBarrierShared();
    subgroupBarrier();
}

// Returns whether the condition holds in any lane of those that run together, which include the lanes of the pixel.
bool agaa_anyLane(bool condition) { return subgroupAny(condition); }

// Returns a mask of the pixel's samples: bit i is the condition of its lane i.
uint agaa_samplesWhere(bool condition) {
    uvec4 lanes = subgroupBallot(condition);
    uint first = gl_SubgroupInvocationID & ~(agaa_pixelLanes - 1u);
    uint word = first < 32u ? lanes.x : lanes.y;
    return word >> (first & 31u) & (0xFFFFFFFFu >> (32u - agaa_pixelLanes));
}

#define AGAA_OF_PIXEL(type, name, both)               \
    type name(type v) {                               \
        if (agaa_pixelLanes > 1u)                     \
            v = both(v, subgroupShuffleXor(v, 1u));   \
        if (agaa_pixelLanes > 2u)                     \
            v = both(v, subgroupShuffleXor(v, 2u));   \
        if (agaa_pixelLanes > 4u)                     \
            v = both(v, subgroupShuffleXor(v, 4u));   \
        if (agaa_pixelLanes > 8u)                     \
            v = both(v, subgroupShuffleXor(v, 8u));   \
        if (agaa_pixelLanes > 16u)                    \
            v = both(v, subgroupShuffleXor(v, 16u));  \
        return v;                                     \
    }
#else
shared uint agaa_anyFlag;

void agaa_syncLanes() { barrier(); }

bool agaa_anyLane(bool condition) {
    if (gl_LocalInvocationIndex == 0u)
        agaa_anyFlag = 0u;
    barrier();
    if (condition)
        agaa_anyFlag = 1u;
    barrier();
    bool any = agaa_anyFlag != 0u;
    barrier();
    return any;
}

#define AGAA_EXCHANGED(lane, k) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS - 3u + (k))

uint agaa_samplesWhere(bool condition) {
    AGAA_EXCHANGED(gl_LocalInvocationIndex, 0u) = condition ? 1u : 0u;
    barrier();
    const uint first = agaa_firstLane();
    uint samples = 0u;
    for (uint i = 0u; i < agaa_pixelLanes; ++i)
        samples |= AGAA_EXCHANGED(first + i, 0u) << i;
    barrier();
    return samples;
}

void agaa_exchange(uint v) { AGAA_EXCHANGED(gl_LocalInvocationIndex, 0u) = v; }
void agaa_exchange(float v) { agaa_exchange(floatBitsToUint(v)); }
void agaa_exchange(uvec3 v) {
    AGAA_EXCHANGED(gl_LocalInvocationIndex, 0u) = v.x;
    AGAA_EXCHANGED(gl_LocalInvocationIndex, 1u) = v.y;
    AGAA_EXCHANGED(gl_LocalInvocationIndex, 2u) = v.z;
}
void agaa_exchange(vec3 v) { agaa_exchange(floatBitsToUint(v)); }
void agaa_exchanged(uint lane, out uint v) { v = AGAA_EXCHANGED(lane, 0u); }
void agaa_exchanged(uint lane, out float v) { v = uintBitsToFloat(AGAA_EXCHANGED(lane, 0u)); }
void agaa_exchanged(uint lane, out uvec3 v) {
    v = uvec3(AGAA_EXCHANGED(lane, 0u), AGAA_EXCHANGED(lane, 1u), AGAA_EXCHANGED(lane, 2u));
}
void agaa_exchanged(uint lane, out vec3 v) {
    uvec3 words;
    agaa_exchanged(lane, words);
    v = uintBitsToFloat(words);
}

#define AGAA_OF_PIXEL(type, name, both)               \
    type name(type v) {                               \
        agaa_exchange(v);                             \
        barrier();                                    \
        const uint first = agaa_firstLane();          \
        type result;                                  \
        agaa_exchanged(first, result);                \
        for (uint i = 1u; i < agaa_pixelLanes; ++i) { \
            type other;                               \
            agaa_exchanged(first + i, other);         \
            result = both(result, other);             \
        }                                             \
        barrier();                                    \
        return result;                                \
    }
#endif

// Return the minimum, the maximum or the sum over the lanes of the pixel. No function sums floats, because such sums
// depend on their order.
uvec3 agaa_plus(uvec3 a, uvec3 b) { return a + b; }
AGAA_OF_PIXEL(uint, agaa_minOfPixel, min)
AGAA_OF_PIXEL(uint, agaa_maxOfPixel, max)
AGAA_OF_PIXEL(float, agaa_minOfPixel, min)
AGAA_OF_PIXEL(float, agaa_maxOfPixel, max)
AGAA_OF_PIXEL(vec3, agaa_minOfPixel, min)
AGAA_OF_PIXEL(vec3, agaa_maxOfPixel, max)
AGAA_OF_PIXEL(uvec3, agaa_sumOfPixel, agaa_plus)
#undef AGAA_OF_PIXEL
#endif
