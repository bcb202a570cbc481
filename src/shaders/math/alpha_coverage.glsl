// Samples that an alpha-masked surface covers: cut-outs, whose alpha is compared with a cutoff, and translucent
// surfaces, whose alpha is the share of samples that they cover.
//
// Passes are separate programs and must agree about every sample, so every deciding expression is PRECISE and
// has an explicit order of operations.
#ifndef AGAA_MATH_ALPHA_COVERAGE_GLSL
#define AGAA_MATH_ALPHA_COVERAGE_GLSL
#include "limits.glsl"
#include "real.glsl"
#include "sanitise.glsl"

// Returns 0 for non-finite alpha, so that the gradients of its neighbours in the quad stay small. It returns 0 for
// denormal alpha, too: programs, and threads of software rasterisers, may flush denormals or keep them, and the
// comparison of a cutoff with 0 must not depend on that.
real agaa_sanitiseAlpha(real alpha) {
    const bool isZero = !agaa_isFinite(alpha) || abs(alpha) < AGAA_MIN_NORMAL;
    return isZero ? real(0.0) : clamp(alpha, -AGAA_MAX_HALF, AGAA_MAX_HALF);
}

// Cut-outs: inside a texel of the target the edge of a cut-out is nearly straight, so alpha is a simple function of
// the position and is compared with the cutoff at the sample's position. offset: from the texel's centre to the
// sample, in texels, [-1/2, 1/2].

// Returns whether a sample is covered, with alpha as a plane. gradient: change of alpha per texel.
bool agaa_isInCutout(real alpha, real cutoff, rvec2 gradient, rvec2 offset) {
    PRECISE real margin = (alpha - cutoff) + (gradient.x * offset.x + gradient.y * offset.y);
    return margin >= real(0.0);
}

// Returns whether a sample is covered, with alpha bilinear through four points, which also follows corners and thin
// stems. Point k, 0 to 3, is at (k & 1, k >> 1) / 2 - 1/4 texels from the centre.
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

// Returns the random number of a translucent primitive in a pixel. A constant frame keeps the pattern constant.
uint agaa_translucencyHash(uint x, uint y, uint primitiveSeed, uint frame) {
    return agaa_hash(x + agaa_hash(y + agaa_hash(primitiveSeed + frame * 0x9E3779B9u)));
}

// Returns a stratified mask: bit i is sample i of one of the `groups` texels of a pixel, each with `samples` samples.
// One random number per pixel and primitive is distributed over texels and samples, so that the pixel has alpha n
// samples, rounded up or down without bias. The chosen samples differ between primitives (hard case 53).
uint agaa_translucentMask(real alpha, uint samples, uint group, uint groups, uint hash) {
    const uint rotated = (group + (hash >> 8u)) % groups;
    const real fine = (real(agaa_hash(hash) & 0xFFFFu) + real(0.5)) / real(65536.0);
    const real u = (real(rotated) + fine) / real(groups);
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
