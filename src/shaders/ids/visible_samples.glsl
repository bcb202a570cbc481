// The depth and the primitive id of each sample. Passes that expand triangles fill the buffer. Words are 0 where there
// is no geometry, and of two surfaces the nearer one has the greater word of depth, so that atomicMax() finds it. Of
// equal depths the primitive with the least id is shown; a host that draws in the order of ids draws it first. Needs
// common/frame.glsl, AGAA_BINDING_VISIBLE, and AGAA_SAMPLES and AGAA_FAR_DEPTH of common/constants.glsl.
#ifndef AGAA_VISIBLE_SAMPLES_GLSL
#define AGAA_VISIBLE_SAMPLES_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_BINDING_VISIBLE)
#error "visible_samples.glsl needs frame.glsl and AGAA_BINDING_VISIBLE."
#endif
#ifndef AGAA_VISIBLE_ACCESS
#define AGAA_VISIBLE_ACCESS readonly
#endif
layout(std430, AGAA_BINDING_VISIBLE) AGAA_VISIBLE_ACCESS buffer agaa_VisibleBlock {
    uint words[]; // two for each sample: depth and id
} agaa_visible;

// Returns the index of the first word.
uint agaa_visibleAt(uvec2 pixel, uint i) { return 2u * ((pixel.y * agaa_frame.size.x + pixel.x) * AGAA_SAMPLES + i); }

// depth   In [0, 1], where floats and their bits have the same order.
uint agaa_depthWord(float depth) {
    uint bits = floatBitsToUint(max(depth, 0.0)); // -0 is 0
    return AGAA_FAR_DEPTH != 0u ? ~bits : bits;
}

float agaa_visibleDepth(uvec2 pixel, uint i) {
    uint word = agaa_visible.words[agaa_visibleAt(pixel, i)];
    return word == 0u ? float(AGAA_FAR_DEPTH) : uintBitsToFloat(AGAA_FAR_DEPTH != 0u ? ~word : word);
}

uint agaa_visibleId(uvec2 pixel, uint i) {
    uint word = agaa_visible.words[agaa_visibleAt(pixel, i) + 1u];
    return word == 0u ? 0u : ~word;
}
#endif
