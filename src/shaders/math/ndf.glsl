// Normal distributions: conversions between roughness conventions, round and elliptic widening.
// Sources: AGAA (Crassin et al., TVCG 2016) sections 3.4.1 and 3.5.2; Toksvig 2005, "Mipmapping Normal Maps"; Olano and
// Baker 2010, "LEAN Mapping"; Heitz et al. 2015, "The SGGX Microflake Distribution"; Duff et al. 2017, "Building an
// Orthonormal Basis, Revisited"; hard cases 1 to 5 and 9.
//
// alpha is the width of the GGX lobe (the paper's r), alpha2 its square, perceptual roughness the square root of alpha.
// All other code uses alpha2. All conversions are in this file, because widening alpha in place of alpha2 filters too
// little without visible errors.
#ifndef AGAA_MATH_NDF_GLSL
#define AGAA_MATH_NDF_GLSL
#include "encoding.glsl"
#include "real.glsl"
#include "sanitise.glsl"
#include "second_moments.glsl"

// Values of AgaaNdf. Lobes are elliptic from agaa_ndfLean on.
#define agaa_ndfNone 0u
#define agaa_ndfLean 2u
#define agaa_ndfSggx 3u
// Values of AGAA_FILTER_DIFFUSE: 1 + AgaaDiffuseFilter, or 0 for no filter.
#define agaa_diffuseMisesFisher 2u
#define agaa_diffuseSggx 3u

// alpha >= .002025: below, D overflows half floats and loses its digits in single precision.
real agaa_minAlpha2() {
    return real(4.100625e-6);
}

// Returns the Blinn-Phong exponent of the lobe of the same width, [0, 487729].
real agaa_exponentFromAlpha2(real a2) {
    return real(2.0) / clamp(a2, agaa_minAlpha2(), real(1.0)) - real(2.0);
}

// Returns alpha2 widened by the variance of normals, from the length of their mean. The five steps of section 3.5.2
// (alpha2 -> exponent -> Toksvig factor -> exponent -> alpha2) are one fraction, which is finite for alpha2 = 0 and
// lengths above 1.
real agaa_toksvigAlpha2(real alpha2, real meanLength) {
    const real a = agaa_saturate(alpha2);
    const real len = agaa_saturate(meanLength);
    const real t = real(2.0) * (real(1.0) - a) * (real(1.0) - len);
    const real denominator = len + t;
    real widened = real(1.0);
    if (denominator > real(0.0)) {
        widened = clamp((a * len + t) / denominator, a, real(1.0));
    }
    return widened;
}

// Returns the bound of 1 - length for the mean of equal stored normals. Rounding changes each of three components by
// half a step of its signed code, 2/(2^bits-2): once if integer codes are summed exactly (roundings = 1), n times if
// blending rounds after each of n additions (roundings = n).
real agaa_storedLengthBound(uint roundings, uint bits) {
    return real(1.7320508075688772) * real(roundings) / real(max(agaa_maxCode(bits), 2u) - 1u);
}

// Returns the mean length without the rounding error: deficits 1-L up to `bound` become 0, by deficit' = max(0, deficit
// - bound) / (1 - bound). The function is continuous and maps 1 to 1 and 0 to 0, so that fully scattered normals stay
// fully scattered.
real agaa_varianceFloor(real meanLength, real bound) {
    const real b = clamp(bound, real(0.0), real(0.5));
    const real deficit = real(1.0) - agaa_saturate(meanLength);
    return real(1.0) - max(deficit - b, real(0.0)) / (real(1.0) - b);
}

// Returns the length of the normal in which the paper's folded layout stores roughness: L = s/(1+s), in terms of alpha2
// (2-2a)/(2-a), which is its own inverse. The length is at least 1/256, because alpha2 = 1 would otherwise store a zero
// vector and lose the direction.
real agaa_foldedLength(real alpha2) {
    const real a = clamp(alpha2, agaa_minAlpha2(), real(1.0));
    const real folded = real(2.0) * (real(1.0) - a) / (real(2.0) - a);
    return max(folded, real(0.00390625));
}

real agaa_alpha2FromFoldedLength(real meanLength) {
    const real len = agaa_saturate(meanLength);
    const real a = real(2.0) * (real(1.0) - len) / (real(2.0) - len);
    return max(a, agaa_minAlpha2());
}

// Computes direction and length of a mean normal. If opposite normals cancel, the direction is the fallback (the normal
// of a sample) and the length is 0, which gives the widest lobe.
void agaa_meanDirection(rvec3 sumDir, rvec3 fallback, OUT(rvec3) n, OUT(real) len) {
    const real m = max(abs(sumDir.x), max(abs(sumDir.y), abs(sumDir.z)));
    // The sum of 32 cancelling unit vectors is about 1e-6 by rounding, which is no direction.
    if (agaa_isFinite3(sumDir) && m > real(2e-6)) {
        // The scale by the largest component keeps the squares in range.
        const rvec3 scaled = rvec3(sumDir.x / m, sumDir.y / m, sumDir.z / m);
        const real scaledLength = sqrt(dot(scaled, scaled));
        n = rvec3(scaled.x / scaledLength, scaled.y / scaledLength, scaled.z / scaledLength);
        len = m < real(1.0) ? min(m * scaledLength, real(1.0)) : real(1.0);
    } else {
        n = normalize(agaa_directionOrZ(fallback));
        len = real(0.0);
    }
}

// Widens a lobe in each direction by the spread of normals there. axis receives the widest direction (unit,
// perpendicular to the mean direction n), along and across receive alpha2 in that direction and perpendicular to it.
// LEAN mapping (sggx 0) adds twice the variance of slopes, as for a Gaussian in place of GGX. SGGX (sggx 1) adds
// projected areas. A variance up to `bound` counts as rounding. Second moments do not distinguish a normal from its
// opposite, but the length of the mean does: below 1/2, normals point in all directions, and the lobe approaches the
// widest.
void agaa_spreadAlpha2(agaa_SecondMoments m, rvec3 n, real meanLength, real alpha2, uint sggx,
                       real bound, OUT(rvec3) axis, OUT(real) along, OUT(real) across) {
    const real a2 = clamp(alpha2, agaa_minAlpha2(), real(1.0));
    rvec3 t;
    rvec3 b;
    agaa_viewBasis(n, t, b);
    const real tt = agaa_momentAlong(m, t, t);
    const real bb = agaa_momentAlong(m, b, b);
    const real tb = agaa_momentAlong(m, t, b);
    const real nn = agaa_momentAlong(m, n, n);
    // Computes the eigenvalues and the eigenvector of the larger one, in the form of the vector whose terms have one
    // sign.
    const real skew = real(0.5) * (tt - bb);
    const real root = sqrt(skew * skew + tb * tb);
    const real mean = real(0.5) * (tt + bb);
    real u = skew + root;
    real v = tb;
    if (skew < real(0.0)) {
        u = tb;
        v = root - skew;
    }
    const real norm2 = u * u + v * v;
    axis = t;
    if (norm2 > real(1e-20)) {
        const real scale = real(1.0) / sqrt(norm2);
        axis = (u * scale) * t + (v * scale) * b;
    }
    along = max(mean + root - bound, real(0.0));
    across = max(mean - root - bound, real(0.0));
    if (sggx != 0u) {
        const real area = a2 + (real(1.0) - a2) * max(nn, real(0.0));
        along = (a2 + (real(1.0) - a2) * along) / area;
        across = (a2 + (real(1.0) - a2) * across) / area;
    } else {
        const real twice = real(2.0) / max(nn, real(1e-3));
        along = a2 + twice * along;
        across = a2 + twice * across;
    }
    const real facing = agaa_saturate(real(4.0) * agaa_sq(meanLength));
    along = min(along, real(1.0));
    across = min(across, real(1.0));
    along = clamp(along + (real(1.0) - facing) * (real(1.0) - along), a2, real(1.0));
    across = clamp(across + (real(1.0) - facing) * (real(1.0) - across), a2, along);
}

#endif
