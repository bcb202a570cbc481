// Counts of a host's fragments: low words of the frame's 64-bit counts, by word (core/gpu_layout.h).
#define AGAA_FRAGMENT_TIES 8u
#define AGAA_FRAGMENT_SANITISED 10u
#define AGAA_FRAGMENT_MISPLACED 20u
#define AGAA_FRAGMENT_UNANNOUNCED 28u

#if AGAA_COUNTING && AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_AT_COUNTERS) uniform uimageBuffer agaa_counterWords;
uint agaa_addToCounter(uint word, uint amount) { return imageAtomicAdd(agaa_counterWords, int(word), amount); }
#elif AGAA_COUNTING
layout(std430, AGAA_AT_COUNTERS) buffer agaa_CounterBlock {
    uint words[];
} agaa_counterBuffer;
uint agaa_addToCounter(uint word, uint amount) { return atomicAdd(agaa_counterBuffer.words[word], amount); }
#endif

#if AGAA_COUNTING
void agaa_countFragment(uint word, uint amount) {
    uint before = agaa_addToCounter(word, amount);
    if (before + amount < before) // carried
        agaa_addToCounter(word + 1u, 1u);
}
#else
void agaa_countFragment(uint word, uint amount) {}
#endif
