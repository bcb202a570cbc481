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

// Returns the square of the matrix, divided by that of its largest square, which must be > 0.
agaa_SecondMoments agaa_squaredMoments(agaa_SecondMoments m) {
    const real largest = max(max(m.squares.x, m.squares.y), m.squares.z);
    const rvec3 s = rvec3(m.squares.x / largest, m.squares.y / largest, m.squares.z / largest);
    const rvec3 p = rvec3(m.mixed.x / largest, m.mixed.y / largest, m.mixed.z / largest);
    return agaa_SecondMoments(rvec3(s.x * s.x + p.z * p.z + p.y * p.y, p.z * p.z + s.y * s.y + p.x * p.x,
                                    p.y * p.y + p.x * p.x + s.z * s.z),
                              rvec3(p.z * p.y + s.y * p.x + p.x * s.z, p.y * s.x + p.x * p.z + s.z * p.y,
                                    s.x * p.z + p.z * s.y + p.y * p.x));
}

// Returns nearly the largest moment, and its direction: a column of the eighth power of the matrix. Without extent,
// both are 0.
real agaa_longestAxis(agaa_SecondMoments m, OUT(rvec3) axis) {
    axis = rvec3(real(0.0));
    if (max(max(m.squares.x, m.squares.y), m.squares.z) <= real(1e-30))
        return real(0.0);
    const agaa_SecondMoments power = agaa_squaredMoments(agaa_squaredMoments(agaa_squaredMoments(m)));
    rvec3 column = rvec3(power.squares.x, power.mixed.z, power.mixed.y);
    if (power.squares.y > power.squares.x)
        column = rvec3(power.mixed.z, power.squares.y, power.mixed.x);
    if (power.squares.z > max(power.squares.x, power.squares.y))
        column = rvec3(power.mixed.y, power.mixed.x, power.squares.z);
    axis = normalize(column);
    return max(agaa_momentAlong(m, axis, axis), real(0.0));
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
