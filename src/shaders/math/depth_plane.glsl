// Depth planes: the depths of a triangle's surface within a pixel, limited to the range of depths of the triangle.
// Sources: DCAA (Wang et al., I3D 2016) sections 3.2 and 3.4; hard cases 45 and 46 (edge-on triangles), 50 (vertices
// behind the eye).
#ifndef AGAA_MATH_DEPTH_PLANE_GLSL
#define AGAA_MATH_DEPTH_PLANE_GLSL
#include "real.glsl"
#include "sanitise.glsl"
#include "triangle_coverage.glsl"

// The depth at an offset from the pixel's centre in pixels is depth + slope * offset, clamped to the range. All members
// are finite.
struct agaa_DepthPlane {
    real depth;  // at the centre; may be outside the range where the triangle misses the centre
    rvec2 slope; // per pixel
    rvec2 range; // lowest and highest depth of the plane in the pixel, within the triangle's depths
};

// Limit of the plane's slope per pixel, in units of the range of the triangle's depths. A triangle with a steeper plane
// is narrower than 1/1024 of a pixel and covers hardly any sample.
real agaa_steepestSlope() {
    return real(1024.0);
}

// Adds the depths of the edge from a vertex in front of the eye to one behind it, which increase without limit.
rvec2 agaa_addEdgeToEye(rvec2 range, rvec2 front, rvec2 behind) {
    // z at w = 0 has the sign of all depths near the eye.
    const real atEye = behind.x * front.y - front.x * behind.y;
    if (atEye < real(0.0))
        return rvec2(real(0.0), range.y);
    return atEye > real(0.0) ? rvec2(range.x, real(1.0)) : range;
}

// Returns the range of depths of the triangle's part in front of the eye, in [0, 1]. z, w: of the vertices.
rvec2 agaa_depthRange(rvec3 z, rvec3 w) {
    rvec2 range = rvec2(real(1.0), real(0.0));
    for (int i = 0; i < 3; ++i) {
        if (w[i] > real(0.0)) {
            const real depth = agaa_saturate(agaa_quotient(z[i], w[i]));
            range = rvec2(min(range.x, depth), max(range.y, depth));
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (w[i] > real(0.0) && w[k] <= real(0.0))
                range = agaa_addEdgeToEye(range, rvec2(z[i], w[i]), rvec2(z[k], w[k]));
        }
    }
    return range;
}

// Returns the depth plane of a triangle in a pixel. A triangle without area has the middle of its range as depth; a
// triangle that covers nothing has depth 0.
// a, b, c   Vertices of agaa_triangleCoverage().
// z         clip.z of the vertices, with depths z / w in [0, 1], in either direction.
// centre    Centre of the pixel, in pixels.
agaa_DepthPlane agaa_depthPlane(rvec3 a, rvec3 b, rvec3 c, rvec3 z, rvec2 centre) {
    agaa_DepthPlane plane;
    plane.depth = real(0.0);
    plane.slope = rvec2(real(0.0));
    plane.range = rvec2(real(0.0));
    const rvec3 p = agaa_vertexFromCentre(a, centre);
    const rvec3 q = agaa_vertexFromCentre(b, centre);
    const rvec3 r = agaa_vertexFromCentre(c, centre);
    const bool finite = agaa_isFinite3(p) && agaa_isFinite3(q) && agaa_isFinite3(r) && agaa_isFinite3(z);
    if (!finite || max(p.z, max(q.z, r.z)) <= real(0.0))
        return plane;
    const rvec3 scale = rvec3(agaa_scaleOfVertex(a), agaa_scaleOfVertex(b), agaa_scaleOfVertex(c));
    const rvec3 w = rvec3(p.z, q.z, r.z);
    const rvec3 scaledZ = z * scale;
    plane.range = agaa_depthRange(scaledZ, w);
    const real least = plane.range.x;
    const real greatest = plane.range.y;
    const real middle = (least + greatest) * real(0.5);
    plane.depth = middle;

    // Edge functions weigh the vertices. Depths are relative to a reference near them: most are near 1, and sums would
    // lose the digits that differ. The reference has few digits, which agaa_fromCentre() needs.
    const rvec3 qr = agaa_edgeLine(q, r);
    const rvec3 rp = agaa_edgeLine(r, p);
    const rvec3 pq = agaa_edgeLine(p, q);
    const real facing = w.x * qr.z + w.y * rp.z + w.z * pq.z;
    const real reference = floor(middle * real(32768.0)) * real(0.000030517578125);
    const rvec3 sum = qr * agaa_fromCentre(scaledZ.x, w.x, reference) +
                      rp * agaa_fromCentre(scaledZ.y, w.y, reference) + pq * agaa_fromCentre(scaledZ.z, w.z, reference);
    if (facing == real(0.0) || !agaa_isFinite(facing) || !agaa_isFinite3(sum))
        return plane;

    // Steeper planes are flattened around the middle depth, whose position in the pixel does not change.
    const real size = max(abs(facing), real(1e-37));
    const real steepest = max(greatest - least, real(1e-30)) * agaa_steepestSlope();
    const real divisor = max(size, (abs(sum.x) + abs(sum.y)) / steepest);
    const real flattened = size / divisor;
    const real inverse = (facing < real(0.0) ? real(-1.0) : real(1.0)) / divisor;
    plane.slope = rvec2(sum.x, sum.y) * inverse;
    const real depth = middle + (reference - middle) * flattened + sum.z * inverse;
    const real reach = (abs(plane.slope.x) + abs(plane.slope.y)) * real(0.5);
    plane.depth = clamp(depth, least - reach, greatest + reach);
    plane.range = rvec2(clamp(plane.depth - reach, least, greatest), clamp(plane.depth + reach, least, greatest));
    return plane;
}

// Returns the depth at an offset from the pixel's centre, in pixels.
real agaa_depthAt(agaa_DepthPlane plane, rvec2 offset) {
    return clamp(plane.depth + (plane.slope.x * offset.x + plane.slope.y * offset.y), plane.range.x, plane.range.y);
}

// Returns whether two surfaces may touch within the pixel. tolerance: of depths, at least the step of the depth format.
bool agaa_depthsOverlap(agaa_DepthPlane a, agaa_DepthPlane b, real tolerance) {
    return a.range.x <= b.range.y + tolerance && b.range.x <= a.range.y + tolerance;
}

#endif
