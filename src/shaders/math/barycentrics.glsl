// Barycentric coordinates of a point of the image in a triangle, from the clip coordinates of its vertices.
// Sources: Olano and Greer 1997, "Triangle Scan Conversion using 2D Homogeneous Coordinates"; Burns and Hunt
// 2013, "The Visibility Buffer", section 4; hard cases 13 and 14 (differences before products).
//
// Vertices are not divided by w, so vertices behind the eye need no clipping.
#ifndef AGAA_MATH_BARYCENTRICS_GLSL
#define AGAA_MATH_BARYCENTRICS_GLSL
#include "real.glsl"
#include "sanitise.glsl"

struct agaa_Barycentrics {
    rvec3 at; // perspective-correct weights of the vertices, [0;1], of sum 1
    rvec3 dx; // change per pixel in x
    rvec3 dy; // change per pixel in y
    real facing; // > 0 if the vertices turn from x to y of ndc, < 0 if they turn the other way
};

real agaa_cross2(rvec2 a, rvec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Returns the offset of a vertex with clip coordinates x, y, w from the ray through ndc, in pixels times w.
rvec2 agaa_fromRay(rvec3 clip, rvec2 ndc, rvec2 pixelsPerNdc) {
    return (rvec2(clip.x, clip.y) - ndc * clip.z) * pixelsPerNdc;
}

// Points outside the triangle, such as those of slivers that a rasteriser snapped to its grid, are moved inside. A
// triangle without area has equal weights that do not change.
// a, b, c        Clip coordinates x, y, w.
// pixelsPerNdc   Half of the image's size.
agaa_Barycentrics agaa_barycentrics(rvec3 a, rvec3 b, rvec3 c, rvec2 ndc, rvec2 pixelsPerNdc) {
    agaa_Barycentrics result;
    result.at = rvec3(real(1.0) / real(3.0));
    result.dx = rvec3(real(0.0));
    result.dy = rvec3(real(0.0));
    result.facing = real(0.0);
    rvec2 ra = agaa_fromRay(a, ndc, pixelsPerNdc);
    rvec2 rb = agaa_fromRay(b, ndc, pixelsPerNdc);
    rvec2 rc = agaa_fromRay(c, ndc, pixelsPerNdc);
    rvec3 w = rvec3(a.z, b.z, c.z);
    // A common factor does not change the weights. Squares of large coordinates would overflow.
    const real size = max(max(max(abs(ra.x), abs(ra.y)), max(abs(rb.x), abs(rb.y))), max(abs(rc.x), abs(rc.y)));
    const real divisionScale = agaa_divisionScale(size);
    const real scale = agaa_guardedReciprocal(size * divisionScale);
    ra = ra * divisionScale * scale;
    rb = rb * divisionScale * scale;
    rc = rc * divisionScale * scale;
    w = w * divisionScale * scale;
    const rvec3 edge = rvec3(agaa_cross2(rb, rc), agaa_cross2(rc, ra), agaa_cross2(ra, rb));
    const real sum = edge.x + edge.y + edge.z;
    if (!agaa_isFinite(sum) || abs(sum) <= real(1e-30))
        return result;
    result.facing = dot(edge, w);
    const real inverse = real(1.0) / sum;
    result.at = edge * inverse;
    // Derivatives of the edges: each r changes by -w along one axis.
    const rvec3 ex = rvec3(w.z * rb.y - w.y * rc.y, w.x * rc.y - w.z * ra.y, w.y * ra.y - w.x * rb.y);
    const rvec3 ey = rvec3(w.y * rc.x - w.z * rb.x, w.z * ra.x - w.x * rc.x, w.x * rb.x - w.y * ra.x);
    result.dx = (ex - result.at * (ex.x + ex.y + ex.z)) * inverse;
    result.dy = (ey - result.at * (ey.x + ey.y + ey.z)) * inverse;
    result.at = max(result.at, rvec3(real(0.0)));
    result.at /= result.at.x + result.at.y + result.at.z;
    return result;
}
#endif
