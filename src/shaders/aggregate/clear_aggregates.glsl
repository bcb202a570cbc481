// Clears the aggregates of a pixel before fragments are added to them: in place of a fill of all aggregates, because
// most pixels have one. Of aggregates without samples, only the word of the coverage is cleared. Without AGAA_WORDS,
// nothing is.
#ifndef AGAA_CLEAR_AGGREGATES_GLSL
#define AGAA_CLEAR_AGGREGATES_GLSL

layout(std430, AGAA_BINDING_AGGREGATES) writeonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

// count   Aggregates of the pixel. The first is always cleared.
// word    The first word that this lane clears.
// step    From one word of this lane to the next.
void agaa_clearAggregates(uvec2 pixel, uint count, uint word, uint step) {
    const uint words = AGAA_AGGREGATES * AGAA_WORDS;
    const uint base = (pixel.y * agaa_frame.size.x + pixel.x) * words;
    const uint used = max(count, 1u) * AGAA_WORDS;
    for (; word < words; word += step)
        if (word < used || word % AGAA_WORDS == (AGAA_FIELD_COVERAGE & 0xFFu))
            agaa_aggregates.words[base + word] = 0u;
}
#endif
