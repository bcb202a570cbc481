// Operations on the lanes of a pixel, in passes with one lane per sample. Neighbouring lanes have the samples of one
// pixel. All lanes of the workgroup must call each function. Values are exchanged by subgroup operations with
// AGAA_SUBGROUPS, otherwise through shared memory.
//
// With AGAA_SUBGROUPS all subgroups must be full, and a subgroup must have at least as many lanes as a pixel.
#ifndef AGAA_LANES_GLSL
#define AGAA_LANES_GLSL
#include "aggregate/lane_words.glsl"

#ifdef AGAA_VARIABLE_LANES
// Pixels have different numbers of lanes, which the includer sets in each lane by agaa_setLanes(). Values are
// exchanged through shared memory.
uint agaa_pixelLanes = 1u;
uint agaa_firstOfPixel = 0u;

// first   The first of `count` neighbouring lanes, up to 32. A lane without a pixel is its own pixel.
void agaa_setLanes(uint first, uint count) {
    agaa_firstOfPixel = first;
    agaa_pixelLanes = count;
}
#else
// The number of lanes of a pixel: n, rounded up to a power of two.
const uint agaa_pixelLanes = AGAA_SAMPLES <= 1u    ? 1u
                             : AGAA_SAMPLES <= 2u  ? 2u
                             : AGAA_SAMPLES <= 4u  ? 4u
                             : AGAA_SAMPLES <= 8u  ? 8u
                             : AGAA_SAMPLES <= 16u ? 16u
                                                   : 32u;
// The number of pixels that a workgroup processes at a time.
const uint agaa_pixelsAtOnce = 64u / agaa_pixelLanes;
#endif

#if AGAA_SUBGROUPS
// APIs do not define how gl_LocalInvocationIndex maps to subgroups.
uint agaa_laneIndex() { return gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID; }
#else
uint agaa_laneIndex() { return gl_LocalInvocationIndex; }
#endif

#ifdef AGAA_VARIABLE_LANES
uint agaa_firstLane() { return agaa_firstOfPixel; }
uint agaa_laneSample() { return agaa_laneIndex() - agaa_firstOfPixel; }
#else
// Returns the first lane of this lane's pixel.
uint agaa_firstLane() { return agaa_laneIndex() & ~(agaa_pixelLanes - 1u); }

// Returns the sample of this lane; it may be n or more.
uint agaa_laneSample() { return agaa_laneIndex() & (agaa_pixelLanes - 1u); }

// Returns the index of this lane's pixel in an iteration, [0, 63].
uint agaa_lanePixel(uint iteration) { return iteration * agaa_pixelsAtOnce + agaa_laneIndex() / agaa_pixelLanes; }
#endif

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

// Returns the value of the lane of sample i.
vec3 agaa_ofSample(vec3 v, uint i) {
    return subgroupShuffle(v, (gl_SubgroupInvocationID & ~(agaa_pixelLanes - 1u)) + i);
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

// Returns the index of lane i of the pixel, or of its last lane. Loops over the lanes of a pixel read eight lanes per
// iteration, because software rasterisers of Mesa end all loops of an invocation after 65535 iterations in total.
uint agaa_laneIn(uint i) { return agaa_firstLane() + min(i, agaa_pixelLanes - 1u); }
uint agaa_flagOf(uint i) { return AGAA_EXCHANGED(agaa_laneIn(i), 0u); }

uint agaa_samplesWhere(bool condition) {
    AGAA_EXCHANGED(gl_LocalInvocationIndex, 0u) = condition ? 1u : 0u;
    barrier();
    uint samples = 0u;
    for (uint i = 0u; i < agaa_pixelLanes; i += 8u)
        samples |= (agaa_flagOf(i) | agaa_flagOf(i + 1u) << 1u | agaa_flagOf(i + 2u) << 2u | agaa_flagOf(i + 3u) << 3u |
                    agaa_flagOf(i + 4u) << 4u | agaa_flagOf(i + 5u) << 5u | agaa_flagOf(i + 6u) << 6u |
                    agaa_flagOf(i + 7u) << 7u)
                   << i;
    barrier();
    return samples & (0xFFFFFFFFu >> (32u - agaa_pixelLanes));
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

vec3 agaa_ofSample(vec3 v, uint i) {
    agaa_exchange(v);
    barrier();
    vec3 result;
    agaa_exchanged(agaa_firstLane() + i, result);
    barrier();
    return result;
}

#define AGAA_OF_PIXEL(type, name, both)                                           \
    type name(type v) {                                                           \
        agaa_exchange(v);                                                         \
        barrier();                                                                \
        type result;                                                              \
        agaa_exchanged(agaa_firstLane(), result);                                 \
        for (uint i = 1u; i < agaa_pixelLanes; i += 8u) {                         \
            type others[8];                                                       \
            agaa_exchanged(agaa_laneIn(i), others[0]);                            \
            agaa_exchanged(agaa_laneIn(i + 1u), others[1]);                       \
            agaa_exchanged(agaa_laneIn(i + 2u), others[2]);                       \
            agaa_exchanged(agaa_laneIn(i + 3u), others[3]);                       \
            agaa_exchanged(agaa_laneIn(i + 4u), others[4]);                       \
            agaa_exchanged(agaa_laneIn(i + 5u), others[5]);                       \
            agaa_exchanged(agaa_laneIn(i + 6u), others[6]);                       \
            agaa_exchanged(agaa_laneIn(i + 7u), others[7]);                       \
            result = both(result, others[0]);                                     \
            result = i + 1u < agaa_pixelLanes ? both(result, others[1]) : result; \
            result = i + 2u < agaa_pixelLanes ? both(result, others[2]) : result; \
            result = i + 3u < agaa_pixelLanes ? both(result, others[3]) : result; \
            result = i + 4u < agaa_pixelLanes ? both(result, others[4]) : result; \
            result = i + 5u < agaa_pixelLanes ? both(result, others[5]) : result; \
            result = i + 6u < agaa_pixelLanes ? both(result, others[6]) : result; \
            result = i + 7u < agaa_pixelLanes ? both(result, others[7]) : result; \
        }                                                                         \
        barrier();                                                                \
        return result;                                                            \
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
