// Counters of a host's fragments, which add to the frame's 64-bit counters. Needs AGAA_COUNTING and
// AGAA_STORAGE_IMAGES.
#if !defined(AGAA_COUNTING) || !defined(AGAA_STORAGE_IMAGES)
#error "counters.glsl needs AGAA_COUNTING and AGAA_STORAGE_IMAGES."
#endif
#define AGAA_COUNTER(index, name, member)
#define AGAA_COUNTER_DRAWN(index, name, member) const uint name = index;
#define AGAA_COUNTER_MAX(index, name, member)
#define AGAA_COUNTER_FACT(index, name, member, fact) const uint name = index;
#include "tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_DRAWN
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT

#if AGAA_COUNTING && AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_BINDING_COUNTERS) uniform uimageBuffer agaa_counterWords;
uint agaa_addToCounter(uint word, uint amount) { return imageAtomicAdd(agaa_counterWords, int(word), amount); }
#elif AGAA_COUNTING
layout(std430, AGAA_BINDING_COUNTERS) buffer agaa_CounterBlock {
    uint words[];
} agaa_counterBuffer;
uint agaa_addToCounter(uint word, uint amount) { return atomicAdd(agaa_counterBuffer.words[word], amount); }
#endif

#if AGAA_COUNTING
void agaa_countFragment(uint counter, uint amount) {
    uint before = agaa_addToCounter(2u * counter, amount);
    if (before + amount < before) // overflow
        agaa_addToCounter(2u * counter + 1u, 1u);
}
#else
void agaa_countFragment(uint counter, uint amount) {}
#endif

void agaa_countDemands(uint demands, bool isInspected) {
#if AGAA_CHECK_FACTS
#define AGAA_COUNTER(index, name, member)
#define AGAA_COUNTER_MAX(index, name, member)
#define AGAA_COUNTER_FACT(index, name, member, fact) \
    if (fact == 0u ? isInspected : (demands & fact) != 0u) \
        agaa_countFragment(name, 1u);
#include "tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
#endif
}

// Counts a sanitised surface that is or may be visible.
void agaa_countSurface(uint bad) {
    if (bad != 0u)
        agaa_countFragment(AGAA_COUNT_SANITISED, 1u);
    agaa_countDemands(agaa_demands, true);
}

// Counts the mask of a fragment whose material another pass fetches.
void agaa_countMask(AgaaSurfaceInput s) { agaa_countDemands(agaa_demandsOfMask(s), false); }
