// Counts of a workgroup, added to the frame's 64-bit counts once per group.
#ifndef AGAA_COUNTERS_GLSL
#define AGAA_COUNTERS_GLSL
#define AGAA_COUNT_VISIBLE 0u
#define AGAA_COUNT_ONCE 1u
#define AGAA_COUNT_MISSED 2u
#define AGAA_COUNT_MULTI 3u
#define AGAA_COUNT_TIES 4u
#define AGAA_COUNT_SANITISED 5u
#define AGAA_COUNT_EVENTS 6u
#define AGAA_COUNT_SHADOW_TAPS 7u
#define AGAA_COUNT_WIDENED 8u
#define AGAA_COUNT_PIXELS 9u
#define AGAA_COUNT_MAX_EVENTS 10u // one word, a maximum
#define AGAA_COUNTS 11u

#if AGAA_COUNTING
layout(std430, set = AGAA_SET, binding = 2) coherent buffer agaa_CounterBlock {
    uint words[22];
} agaa_counterBuffer;

shared uint agaa_groupCounts[AGAA_COUNTS];
uint agaa_ownCounts[AGAA_COUNTS];

void agaa_countBegin() {
    if (gl_LocalInvocationIndex < AGAA_COUNTS)
        agaa_groupCounts[gl_LocalInvocationIndex] = 0u;
    for (uint i = 0u; i < AGAA_COUNTS; ++i)
        agaa_ownCounts[i] = 0u;
    barrier();
}
void agaa_count(uint which, uint amount) { agaa_ownCounts[which] += amount; }
void agaa_countEnd() {
    for (uint i = 0u; i < AGAA_COUNT_MAX_EVENTS; ++i)
        if (agaa_ownCounts[i] != 0u)
            atomicAdd(agaa_groupCounts[i], agaa_ownCounts[i]);
    atomicMax(agaa_groupCounts[AGAA_COUNT_MAX_EVENTS], agaa_ownCounts[AGAA_COUNT_EVENTS]);
    barrier();
    uint i = gl_LocalInvocationIndex;
    if (i < AGAA_COUNT_MAX_EVENTS && agaa_groupCounts[i] != 0u) {
        uint before = atomicAdd(agaa_counterBuffer.words[2u * i], agaa_groupCounts[i]);
        if (before + agaa_groupCounts[i] < before) // carried
            atomicAdd(agaa_counterBuffer.words[2u * i + 1u], 1u);
    }
    if (i == AGAA_COUNT_MAX_EVENTS)
        atomicMax(agaa_counterBuffer.words[2u * i], agaa_groupCounts[i]);
}
#else
void agaa_countBegin() {}
void agaa_count(uint which, uint amount) {}
void agaa_countEnd() {}
#endif
#endif
