// Spread of a surface's unit normals around their mean: second moments in its tangent plane, which merge with those of
// other surfaces nearly as if all normals were known: products with the mean direction are not kept. Lobes widen in
// each direction by the spread there.
// Source: Olano and Baker 2010, "LEAN Mapping": moments of normals are linear.
#ifndef AGAA_MATH_NORMAL_SPREAD_GLSL
#define AGAA_MATH_NORMAL_SPREAD_GLSL
#include "encoding.glsl"
#include "ndf.glsl"

// Computes axes perpendicular to a stored normal. A z below the distance of codes is a rounding error, whose sign
// differs between shaders; it counts as 0, so that its sign does not mirror the axes.
void agaa_spreadBasis(rvec3 n, OUT(rvec3) t, OUT(rvec3) b) {
    agaa_viewBasis(rvec3(n.x, n.y, abs(n.z) < real(1e-5) ? real(0.0) : n.z), t, b);
}

struct agaa_NormalSpread {
    rvec3 normal;    // unit, the direction of the mean
    rvec3 moments;   // xx, yy and xy along the axes of agaa_spreadBasis(normal), of all normals
    real meanLength; // of the mean
};

agaa_NormalSpread agaa_noSpread(rvec3 normal) {
    return agaa_NormalSpread(normal, rvec3(real(0.0)), real(1.0));
}

rvec3 agaa_mixedProducts(rvec3 a, rvec3 b) {
    return rvec3(a.y * b.z, a.z * b.x, a.x * b.y);
}

// Adds the moments of a spread. The remainder of the moments in the tangent plane is along the normal, because the
// squares of a unit vector's components sum to 1.
void agaa_addSpread(INOUT(agaa_SecondMoments) m, real weight, agaa_NormalSpread s) {
    rvec3 t;
    rvec3 b;
    agaa_spreadBasis(s.normal, t, b);
    const rvec3 n = s.normal;
    const real xx = weight * s.moments.x;
    const real yy = weight * s.moments.y;
    const real xy = weight * s.moments.z;
    const real nn = weight * max(real(1.0) - s.moments.x - s.moments.y, real(0.0));
    m.squares = m.squares + nn * n * n + xx * t * t + yy * b * b + real(2.0) * xy * t * b;
    m.mixed = m.mixed + nn * agaa_mixedProducts(n, n) + xx * agaa_mixedProducts(t, t) + yy * agaa_mixedProducts(b, b) +
              xy * (agaa_mixedProducts(t, b) + agaa_mixedProducts(b, t));
}

// Returns the spread of both surfaces.
// share    Share of b, [0, 1].
// normal   Direction of the mean of both, or another direction that the result is relative to.
agaa_NormalSpread agaa_mixSpreads(agaa_NormalSpread a, agaa_NormalSpread b, real share, rvec3 normal) {
    agaa_SecondMoments m = agaa_SecondMoments(rvec3(real(0.0)), rvec3(real(0.0)));
    agaa_addSpread(m, real(1.0) - share, a);
    agaa_addSpread(m, share, b);
    rvec3 t;
    rvec3 u;
    agaa_spreadBasis(normal, t, u);
    const rvec3 mean = a.normal * (a.meanLength * (real(1.0) - share)) + b.normal * (b.meanLength * share);
    return agaa_NormalSpread(normal,
                             rvec3(max(agaa_momentAlong(m, t, t), real(0.0)), max(agaa_momentAlong(m, u, u), real(0.0)),
                                   agaa_momentAlong(m, t, u)),
                             min(sqrt(dot(mean, mean)), real(1.0)));
}

// Returns the spread of a normal that changes by dx and dy per pixel.
// positions   Second moments xx, yy and xy of the positions around their centroid.
agaa_NormalSpread agaa_spreadOfChange(rvec3 normal, rvec3 dx, rvec3 dy, rvec3 positions) {
    rvec3 t;
    rvec3 b;
    agaa_spreadBasis(normal, t, b);
    const real ux = dot(dx, t);
    const real uy = dot(dx, b);
    const real vx = dot(dy, t);
    const real vy = dot(dy, b);
    const real xx = max(positions.x * ux * ux + positions.y * vx * vx + real(2.0) * positions.z * ux * vx, real(0.0));
    const real yy = max(positions.x * uy * uy + positions.y * vy * vy + real(2.0) * positions.z * uy * vy, real(0.0));
    const real xy = positions.x * ux * uy + positions.y * vx * vy + positions.z * (ux * vy + uy * vx);
    const real scale = real(1.0) / (real(1.0) + xx + yy);
    return agaa_NormalSpread(normal, rvec3(xx, yy, xy) * scale, sqrt(scale));
}

// Widens a lobe like agaa_spreadAlpha2().
void agaa_widenBySpread(agaa_NormalSpread s, real alpha2, uint sggx, OUT(rvec3) axis, OUT(real) along,
                        OUT(real) across) {
    agaa_SecondMoments m = agaa_SecondMoments(rvec3(real(0.0)), rvec3(real(0.0)));
    agaa_addSpread(m, real(1.0), s);
    agaa_spreadAlpha2(m, s.normal, s.meanLength, alpha2, sggx, real(0.0), axis, along, across);
}
#endif
