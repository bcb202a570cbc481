// Shared memory of passes with one lane per sample: words of each of the 64 lanes. Data that are never needed at the
// same time share the words: ids of a pixel's samples, samples that are grouped, and the light that reaches samples. An
// array of a lane would be slow on GPUs, which keep it in device memory if an index is variable.
//
// The includer may define AGAA_SAMPLE_WORDS, the words that it needs for the samples of a pixel, and if it groups no
// samples AGAA_GROUPING_WORDS as 0. Needs common/constants.glsl. Without AGAA_SAMPLE_LANES the file is empty.
#ifndef AGAA_LANE_WORDS_GLSL
#define AGAA_LANE_WORDS_GLSL
#if AGAA_SAMPLE_LANES
#ifndef AGAA_CONSTANTS_GLSL
#error "lane_words.glsl needs constants.glsl."
#endif

#ifndef AGAA_SAMPLE_WORDS
#define AGAA_SAMPLE_WORDS 0u
#endif
#ifndef AGAA_GROUPING_WORDS
#if AGAA_SUBGROUPS
#define AGAA_GROUPING_WORDS 9u // of aggregate/lane_clustering.glsl
#else
#define AGAA_GROUPING_WORDS 12u // and three of aggregate/lanes.glsl
#endif
#endif
const uint agaa_laneWordCount =
    AGAA_SAMPLE_WORDS > AGAA_GROUPING_WORDS ? AGAA_SAMPLE_WORDS : AGAA_GROUPING_WORDS;
shared uint agaa_laneWords[64u * agaa_laneWordCount];

// Lanes that access the same word use different banks of the memory.
#define AGAA_LANE_WORD(lane, word) agaa_laneWords[64u * (word) + (lane)]
#endif
#endif
