// Fixed-point codes of the second moments of unit normals. Integer sums do not depend on the order of fragments.
// The squares of a unit vector's components sum to 1, so that five moments determine the sixth.
// Source: Crassin et al. 2016, section 3.4.1; Olano and Baker 2010, "LEAN Mapping": moments of normals are linear.
#ifndef AGAA_MATH_NORMAL_MOMENTS_GLSL
#define AGAA_MATH_NORMAL_MOMENTS_GLSL
#include "encoding.glsl"
#include "ndf.glsl"

// Sums over 32 samples have 5 bits more.
#define AGAA_MOMENT_BITS 24u

// moment   0 to 4: xx, yy, yz, zx, xy.
uint agaa_momentCode(uint moment, rvec3 n) {
    uint code = 0u;
    if (moment < 2u) {
        const real c = moment == 0u ? n.x : n.y;
        code = agaa_quantise(c * c, AGAA_MOMENT_BITS);
    } else {
        const real product = moment == 2u ? n.y * n.z : (moment == 3u ? n.z * n.x : n.x * n.y);
        code = agaa_signedCode(product, AGAA_MOMENT_BITS);
    }
    return code;
}

// Returns the mean moments from sums of `count` codes. count must be > 0.
agaa_SecondMoments agaa_momentsOfSums(uint xx, uint yy, uint yz, uint zx, uint xy, uint count) {
    const real x = agaa_meanOfSum(xx, count, AGAA_MOMENT_BITS);
    const real y = agaa_meanOfSum(yy, count, AGAA_MOMENT_BITS);
    return agaa_SecondMoments(rvec3(x, y, max(real(1.0) - x - y, real(0.0))),
                              rvec3(agaa_signedMeanOfSum(yz, count, AGAA_MOMENT_BITS),
                                    agaa_signedMeanOfSum(zx, count, AGAA_MOMENT_BITS),
                                    agaa_signedMeanOfSum(xy, count, AGAA_MOMENT_BITS)));
}
#endif
