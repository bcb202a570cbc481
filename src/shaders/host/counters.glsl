// Counts of a host's fragments: low words of the frame's 64-bit counts, by word (core/gpu_layout.h).
#define AGAA_FRAGMENT_TIES 8u
#define AGAA_FRAGMENT_SANITISED 10u
#define AGAA_FRAGMENT_MISPLACED 20u
#define AGAA_FRAGMENT_UNANNOUNCED 28u

#if AGAA_COUNTING && AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_AT_COUNTERS) uniform uimageBuffer agaa_counterWords;
void agaa_countFragment(uint word, uint amount) {
    imageAtomicAdd(agaa_counterWords, int(word), amount);
}
#elif AGAA_COUNTING
layout(std430, AGAA_AT_COUNTERS) buffer agaa_CounterBlock {
    uint words[];
} agaa_counterBuffer;
void agaa_countFragment(uint word, uint amount) { atomicAdd(agaa_counterBuffer.words[word], amount); }
#else
void agaa_countFragment(uint word, uint amount) {}
#endif
