// Finds the nearest primitive of each sample without a rasteriser and with atomics of 32 bits: the first step finds the
// depths, the second one the least id of a primitive at this depth. Both steps are one pipeline, so that they have the
// same planes, and depths at samples are precise. Needs coverage/triangle_words.glsl and what visible_samples.glsl
// needs.
#ifndef AGAA_NEAREST_SAMPLES_GLSL
#define AGAA_NEAREST_SAMPLES_GLSL
#ifndef AGAA_TRIANGLE_WORDS_GLSL
#error "nearest_samples.glsl needs triangle_words.glsl."
#endif
#define AGAA_VISIBLE_ACCESS
#include "ids/visible_samples.glsl"
#include "math/depth_plane.glsl"

// Returns whether this step counts what fragments demand.
bool agaa_isFirstDraw() { return agaa_triangles.words[AGAA_FINDS_DEPTHS] != 0u; }

// Returns the word of the plane's depth at sample i, or 0 if the sample does not show it.
// isCut   The near plane cuts the triangle.
uint agaa_wordAt(agaa_DepthPlane plane, uint i, bool isCut) {
    vec2 offset = agaa_sampleLocation(i) - 0.5;
    precise float along = plane.slope.x * offset.x;
    precise float change = along + plane.slope.y * offset.y;
    precise float depth = plane.depth + change;
    bool isBeforeNear = isCut && (AGAA_FAR_DEPTH != 0u ? depth < 0.0 : depth > 1.0);
    depth = clamp(depth, plane.range.x, plane.range.y);
    return isBeforeNear || depth == float(AGAA_FAR_DEPTH) ? 0u : agaa_depthWord(depth);
}

// The samples between the near and the far plane, and those of them that this step may change: they are nearer than the
// depths so far, or have the depths that were found. Other invocations may find nearer depths meanwhile.
struct agaa_OpenSamples {
    uint inRange;
    uint open;
};

// mask   Covered samples.
agaa_OpenSamples agaa_openSamples(uvec2 pixel, uint mask, agaa_DepthPlane plane, bool isCut) {
    bool findsDepths = agaa_isFirstDraw();
    agaa_OpenSamples samples = agaa_OpenSamples(0u, 0u);
    for (uint left = mask; left != 0u; left &= left - 1u) {
        uint i = uint(findLSB(left));
        uint word = agaa_wordAt(plane, i, isCut), found = agaa_visible.words[agaa_visibleAt(pixel, i)];
        samples.inRange |= word != 0u ? 1u << i : 0u;
        samples.open |= word != 0u && (findsDepths ? found < word : found == word) ? 1u << i : 0u;
    }
    return samples;
}

// open   Of agaa_openSamples(), those that the primitive covers.
void agaa_keepSamples(uvec2 pixel, uint id, uint open, agaa_DepthPlane plane, bool isCut) {
    bool findsDepths = agaa_isFirstDraw();
    for (uint left = open; left != 0u; left &= left - 1u) {
        uint i = uint(findLSB(left)), at = agaa_visibleAt(pixel, i);
        if (findsDepths)
            atomicMax(agaa_visible.words[at], agaa_wordAt(plane, i, isCut));
        else
            atomicMax(agaa_visible.words[at + 1u], ~id);
    }
}
#endif
