// Depth test of surfaces at a pixel's samples, by depth planes.
// Source: DCAA (Wang et al., I3D 2016) section 3.4.
#ifndef AGAA_MATH_SURFACE_RESOLVE_GLSL
#define AGAA_MATH_SURFACE_RESOLVE_GLSL
#include "coverage_pattern.glsl"
#include "depth_plane.glsl"

// Returns the samples, of those that both surfaces cover, where the second is in front.
// Smaller depths are nearer. secondWins: the second is in front where depths are equal.
uvec4 agaa_samplesBehind(agaa_DepthPlane plane, agaa_DepthPlane second, uvec4 both, bool secondWins, uint samples) {
    if (plane.range.x > second.range.y)
        return both;
    if (plane.range.y < second.range.x)
        return uvec4(0u);
    uvec4 hidden = uvec4(0u);
    for (uint word = 0u; word < samples / 32u; ++word) {
        uint left = both[word];
        while (left != 0u) {
            const uint bit = left & (~left + 1u);
            const rvec2 at = agaa_coveragePosition(word * 32u + uint(findLSB(left)), samples);
            const real by = agaa_depthAt(plane, at) - agaa_depthAt(second, at);
            hidden[word] = hidden[word] | (by > real(0.0) || (by == real(0.0) && secondWins) ? bit : 0u);
            left = left ^ bit;
        }
    }
    return hidden;
}

// Returns sample n of a mask, from 0 on. n must be less than the mask's count.
uint agaa_coveredSample(uvec4 mask, uint n) {
    uint word = 0u;
    while (word < 3u && n >= uint(bitCount(mask[word]))) {
        n -= uint(bitCount(mask[word]));
        word += 1u;
    }
    uint left = mask[word];
    while (n > 0u) {
        left = left & (left - 1u);
        n -= 1u;
    }
    return word * 32u + uint(findLSB(left));
}
#endif
