// Clears the aggregates of a pixel before fragments are added to them, so that no pass has to fill them before. Without
// AGAA_WORDS, nothing is cleared.
#ifndef AGAA_CLEAR_AGGREGATES_GLSL
#define AGAA_CLEAR_AGGREGATES_GLSL

layout(std430, AGAA_BINDING_AGGREGATES) writeonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

// word   The first word that this lane clears.
// step   From one word of this lane to the next.
void agaa_clearAggregates(uvec2 pixel, uint word, uint step) {
    const uint words = AGAA_AGGREGATES * AGAA_WORDS;
    const uint base = (pixel.y * agaa_frame.size.x + pixel.x) * words;
    for (; word < words; word += step)
        agaa_aggregates.words[base + word] = 0u;
}
#endif
