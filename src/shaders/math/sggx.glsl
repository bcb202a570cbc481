// The diffuse term of the SGGX distribution of normals, as a mean of visible normals.
// Source: Heitz et al. 2015, "The SGGX Microflake Distribution", section 4 and supplemental material (sampling of
// visible normals); AGAA (Crassin et al., TVCG 2016) sections 3.5.2 and 5.1.
#ifndef AGAA_MATH_SGGX_GLSL
#define AGAA_MATH_SGGX_GLSL
#include "ndf.glsl"

#define AGAA_SGGX_NORMALS 8u

// Returns the mean of max(n.l, 0) over normals of the distribution that face the eye.
// moments   Second moments of unit normals, the matrix of the distribution up to its scale.
// v, l      Unit vectors to the eye and to the light.
real agaa_sggxCosine(agaa_SecondMoments moments, rvec3 v, rvec3 l) {
    rvec3 k;
    rvec3 j;
    agaa_viewBasis(v, k, j);
    // The factor of Cholesky in the order v, j, k maps a unit sphere to the ellipsoid of the distribution. Normals have
    // a least spread in each direction, because the matrix of equal ones is singular.
    const real least = real(1e-4);
    const real a = sqrt(max(agaa_momentAlong(moments, v, v), real(0.0)) + least);
    const real b = agaa_momentAlong(moments, j, v) / a;
    const real c = agaa_momentAlong(moments, k, v) / a;
    const real d = sqrt(max(agaa_momentAlong(moments, j, j) - b * b, real(0.0)) + least);
    const real e = (agaa_momentAlong(moments, k, j) - b * c) / d;
    const real f = sqrt(max(agaa_momentAlong(moments, k, k) - c * c - e * e, real(0.0)) + least);
    const rvec3 light = rvec3(dot(l, k), dot(l, j), dot(l, v));
    real sum = real(0.0);
    for (uint i = 0u; i < AGAA_SGGX_NORMALS; ++i) {
        // Points of the half of the unit sphere that the eye sees, uniform in its projection.
        const real r2 = (real(i) + real(0.5)) / real(AGAA_SGGX_NORMALS);
        const real turn = real(2.39996322972865332) * real(i);
        const real r = sqrt(r2);
        const real x = r * cos(turn);
        const real y = r * sin(turn);
        const real z = sqrt(real(1.0) - r2);
        const rvec3 n = rvec3(f * x + e * y + c * z, d * y + b * z, a * z);
        sum = sum + max(dot(n, light), real(0.0)) / sqrt(max(dot(n, n), real(1e-12)));
    }
    return min(sum / real(AGAA_SGGX_NORMALS), real(1.0));
}
#endif
