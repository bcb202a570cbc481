// Which samples an alpha-masked surface covers: cut-outs, whose alpha is compared with a cutoff, and translucent
// surfaces, whose alpha is the share of samples that they cover.
//
// Passes are programs of their own and must agree about every sample, so every expression that decides is PRECISE and
// its order of operations is written out.
#ifndef AGAA_MATH_COVERAGE_GLSL
#define AGAA_MATH_COVERAGE_GLSL
#include "real.glsl"
#include "sanitise.glsl"

// 0 where alpha is no finite number, so that the gradients of its neighbours in the quad stay small.
real agaa_sanitiseAlpha(real alpha) {
    return agaa_isFinite(alpha) ? clamp(alpha, real(-65504.0), real(65504.0)) : real(0.0);
}

// Located masks: inside a texel of the target the edge of a cut-out is nearly straight, so alpha is taken as a simple
// function of the place and compared with the cutoff at the sample's own position. offset: from the texel's centre to
// the sample, in texels, [-1/2,1/2].

// As a plane, by the change of alpha per texel.
bool agaa_isInCutout(real alpha, real cutoff, rvec2 gradient, rvec2 offset) {
    PRECISE real margin = (alpha - cutoff) + (gradient.x * offset.x + gradient.y * offset.y);
    return margin >= real(0.0);
}

// Bilinear through four points, which also follows corners and thin stems: k = 0 to 3 is at
// (k & 1, k >> 1) / 2 - 1/4 texels from the centre.
bool agaa_isInCutout4(rvec4 alpha, real cutoff, rvec2 offset) {
    PRECISE real x = offset.x * real(2.0) + real(0.5);
    PRECISE real y = offset.y * real(2.0) + real(0.5);
    PRECISE real low = (alpha.x - cutoff) + (alpha.y - alpha.x) * x;
    PRECISE real high = (alpha.z - cutoff) + (alpha.w - alpha.z) * x;
    PRECISE real margin = low + (high - low) * y;
    return margin >= real(0.0);
}

uint agaa_hash(uint x) { // PCG output permutation
    uint state = x * 747796405u + 2891336453u;
    state = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (state >> 22u) ^ state;
}

// The random number of a translucent primitive in a pixel. frame: 0 in every frame keeps the pattern still.
uint agaa_translucencyHash(uint x, uint y, uint primitiveSeed, uint frame) {
    return agaa_hash(x + agaa_hash(y + agaa_hash(primitiveSeed + frame * 0x9E3779B9u)));
}

// Stratified mask: bit i is sample i of one of the `groups` texels of a pixel, each of which has `samples` samples. One
// random number per pixel and primitive is spread over texels and samples, so that the pixel's number of samples is
// alpha n, rounded up or down without bias; which samples they are differs between primitives (hard case 53).
uint agaa_translucentMask(real alpha, uint samples, uint group, uint groups, uint hash) {
    const uint turned = (group + (hash >> 8u)) % groups;
    const real fine = (real(agaa_hash(hash) & 0xFFFFu) + real(0.5)) / real(65536.0);
    const real u = (real(turned) + fine) / real(groups);
    PRECISE real wanted = clamp(agaa_sanitiseAlpha(alpha), real(0.0), real(1.0)) * real(samples) + u;
    const uint count = min(uint(wanted), samples);
    const uint start = (hash >> 16u) + group * 3u;
    uint mask = 0u;
    for (uint i = 0u; i < count; ++i) {
        mask = mask | (1u << ((start + i) % samples));
    }
    return mask;
}

#endif
