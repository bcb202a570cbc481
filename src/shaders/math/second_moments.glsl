// Second moments of vectors: of an aggregate's unit normals, and of the positions of its samples.
// Source: AGAA (Crassin et al., TVCG 2016) sections 3.4.1 and 3.5.3.
#ifndef AGAA_MATH_SECOND_MOMENTS_GLSL
#define AGAA_MATH_SECOND_MOMENTS_GLSL
#include "real.glsl"

// Weighted sums, or means, of the products of components.
struct agaa_SecondMoments {
    rvec3 squares; // xx, yy, zz
    rvec3 mixed;   // yz, zx, xy
};

agaa_SecondMoments agaa_noSecondMoments() {
    return agaa_SecondMoments(rvec3(real(0.0)), rvec3(real(0.0)));
}

void agaa_addSecondMoments(INOUT(agaa_SecondMoments) m, real weight, rvec3 v) {
    m.squares = m.squares + weight * rvec3(v.x * v.x, v.y * v.y, v.z * v.z);
    m.mixed = m.mixed + weight * rvec3(v.y * v.z, v.z * v.x, v.x * v.y);
}

// Returns the moment in the directions a and b.
real agaa_momentAlong(agaa_SecondMoments m, rvec3 a, rvec3 b) {
    const rvec3 r = rvec3(m.squares.x * b.x + m.mixed.z * b.y + m.mixed.y * b.z,
                          m.mixed.z * b.x + m.squares.y * b.y + m.mixed.x * b.z,
                          m.mixed.y * b.x + m.mixed.x * b.y + m.squares.z * b.z);
    return dot(a, r);
}

// Returns the moments of vectors of which x, y and z are the products with the axes a, b and c. Squares stay >= 0 with
// rounding.
agaa_SecondMoments agaa_momentsInBasis(agaa_SecondMoments m, rvec3 a, rvec3 b, rvec3 c) {
    return agaa_SecondMoments(rvec3(max(agaa_momentAlong(m, a, a), real(0.0)),
                                    max(agaa_momentAlong(m, b, b), real(0.0)),
                                    max(agaa_momentAlong(m, c, c), real(0.0))),
                              rvec3(agaa_momentAlong(m, b, c), agaa_momentAlong(m, c, a), agaa_momentAlong(m, a, b)));
}

// Returns the moments around the mean from sums of `count` vectors and their mean. Squares stay >= 0 with rounding.
// count   Must be > 0.
agaa_SecondMoments agaa_momentsAroundMean(agaa_SecondMoments sums, real count, rvec3 mean) {
    const rvec3 squares = rvec3(sums.squares.x / count - mean.x * mean.x, sums.squares.y / count - mean.y * mean.y,
                                sums.squares.z / count - mean.z * mean.z);
    return agaa_SecondMoments(max(squares, rvec3(real(0.0))),
                              rvec3(sums.mixed.x / count - mean.y * mean.z, sums.mixed.y / count - mean.z * mean.x,
                                    sums.mixed.z / count - mean.x * mean.y));
}
#endif
