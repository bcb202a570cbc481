// Bounds the depths of each pixel by a depth prepass: a bound lies behind all samples of the pixel and of its
// neighbours. Where one of them shows the background, the bound is 0, which hides nothing (Wang et al., "Decoupled
// Coverage Anti-Aliasing", I3D 2016, section 4.2).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/sample_depth.glsl"
#include "common/tile_pixels.glsl"
#include "coverage/fragment_words.glsl"
#include "math/ordered_bits.glsl"

void main() {
    const uvec2 size = agaa_frame.size;
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (any(greaterThanEqual(pixel, size)))
        return;
    const float background = float(AGAA_FAR_DEPTH);
    uvec2 first = max(pixel, uvec2(1u)) - 1u;
    uvec2 last = min(pixel + 1u, size - 1u);
    float farthest = AGAA_FAR_DEPTH != 0u ? 0.0 : -1.0; // depths that increase away from the eye
    bool hasBackground = false;
    for (uint y = first.y; y <= last.y; ++y)
        for (uint x = first.x; x <= last.x; ++x)
            for (uint i = 0u; i < AGAA_HW_SAMPLES; ++i) {
                float depth = agaa_depthOf(uvec2(x, y), i);
                hasBackground = hasBackground || depth == background;
                farthest = max(farthest, AGAA_FAR_DEPTH != 0u ? depth : -depth);
            }
    // Fragments at the same depth as the samples stay. Depth buffers round by 2^-25, or 2^-24 of the depth.
    farthest += abs(farthest) * 9.5367e-7 + 1.1921e-7; // 2^-20, 2^-23
    agaa_fragments.words[agaa_boundOf(pixel, size)] = hasBackground ? 0u : ~agaa_orderedBits(farthest);
}
