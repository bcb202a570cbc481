// Triangle hulls: polygons whose rasterisation gives a fragment to each pixel that a triangle touches, without
// conservative rasterisation.
// Sources: DCAA (Wang et al., I3D 2016) section 4.1, which needs that; Hasselgren et al. 2005, "Conservative
// Rasterization", GPU Gems 2, chapter 42; hard case 50.
//
// These pixels have their centres in the Minkowski sum of triangle and pixel square. The sum is convex and has a vertex
// for each vertex of the triangle and each corner of the square.
#ifndef AGAA_MATH_TRIANGLE_HULL_GLSL
#define AGAA_MATH_TRIANGLE_HULL_GLSL
#include "real.glsl"
#include "sanitise.glsl"

// A triangle strip of `count` vertices in clip space, with w = 1 and depth 1/2. Attributes must be flat.
struct agaa_Hull {
    rvec4 vertices[8];
    uint count; // 0 if nothing is in front of the near plane, or a vertex is not finite
};

// The triangle clipped at the near plane, in pixels from the image's centre.
struct agaa_ClippedTriangle {
    rvec2 at[4];
    uint count;
    real size; // of the largest coordinate
    bool bounded; // false if a vertex is at the eye
};

void agaa_addClipped(INOUT(agaa_ClippedTriangle) clipped, rvec4 vertex, rvec2 pixelsPerNdc) {
    const rvec2 p = rvec2(agaa_quotient(vertex.x, vertex.w), agaa_quotient(vertex.y, vertex.w)) * abs(pixelsPerNdc);
    const real size = max(abs(p.x), abs(p.y));
    clipped.bounded = clipped.bounded && vertex.w > real(0.0) && agaa_isFinite(size) && size < real(1e7);
    clipped.size = max(clipped.size, size);
    clipped.at[clipped.count] = p;
    clipped.count += 1u;
}

agaa_ClippedTriangle agaa_clippedToNear(rvec4 a, rvec4 b, rvec4 c, rvec2 nearPlane, rvec2 pixelsPerNdc) {
    agaa_ClippedTriangle clipped;
    clipped.count = 0u;
    clipped.size = real(0.0);
    clipped.bounded = true;
    for (int i = 0; i < 4; ++i)
        clipped.at[i] = rvec2(real(0.0));
    rvec4 from = c;
    for (int i = 0; i < 3; ++i) {
        const rvec4 to = i == 0 ? a : i == 1 ? b : c;
        const real before = nearPlane.x * from.z + nearPlane.y * from.w;
        const real after = nearPlane.x * to.z + nearPlane.y * to.w;
        if ((before >= real(0.0)) != (after >= real(0.0)))
            // From the vertex in front, because the other one may be so far away that its rounding moves the point.
            agaa_addClipped(clipped, before >= real(0.0) ? from + (to - from) * agaa_quotient(before, before - after)
                                                         : to + (from - to) * agaa_quotient(after, after - before),
                            pixelsPerNdc);
        if (after >= real(0.0))
            agaa_addClipped(clipped, to, pixelsPerNdc);
        from = to;
    }
    return clipped;
}

// Returns the corner of the square that is furthest in a direction. Corners are counted anticlockwise from the upper
// right.
uint agaa_furthestCorner(rvec2 direction) {
    if (direction.x > real(0.0) && direction.y >= real(0.0))
        return 0u;
    if (direction.x <= real(0.0) && direction.y > real(0.0))
        return 1u;
    return direction.x < real(0.0) ? 2u : 3u;
}

rvec2 agaa_squareCorner(uint corner, real halfWidth) {
    return rvec2(corner == 0u || corner == 3u ? halfWidth : -halfWidth, corner < 2u ? halfWidth : -halfWidth);
}

// Simplifies a polygon so that it turns anticlockwise at every vertex. A thin polygon becomes its longest distance;
// vertices closer than rounding become one. Returns the largest distance by which the border may have moved.
real agaa_simplifyClipped(INOUT(agaa_ClippedTriangle) p, real rounding) {
    rvec2 first = p.at[0];
    rvec2 second = p.at[0];
    real longest = real(0.0);
    real area = real(0.0);
    uint kept = 0u;
    for (uint i = 0u; i < p.count; ++i) {
        const rvec2 a = p.at[i];
        for (uint k = 0u; k < i; ++k) {
            const rvec2 d = p.at[k] - a;
            const real squared = d.x * d.x + d.y * d.y;
            if (squared > longest) {
                longest = squared;
                first = p.at[k];
                second = a;
            }
        }
    }
    longest = sqrt(longest);
    for (uint i = 2u; i < p.count; ++i) {
        const rvec2 d = p.at[i - 1u] - p.at[0];
        const rvec2 e = p.at[i] - p.at[0];
        area += d.x * e.y - d.y * e.x;
    }
    if (abs(area) <= rounding * longest) {
        p.at[0] = first;
        p.at[1] = longest > real(0.0) ? second : first;
        p.count = 2u;
        return rounding * real(2.0);
    }
    agaa_ClippedTriangle source = p;
    for (uint i = 0u; i < source.count; ++i) {
        const rvec2 a = source.at[area > real(0.0) ? i : source.count - 1u - i];
        const rvec2 d = kept == 0u ? rvec2(longest) : a - p.at[kept - 1u];
        const rvec2 e = kept == 0u ? rvec2(longest) : a - p.at[0];
        if (max(abs(d.x), abs(d.y)) > rounding && max(abs(e.x), abs(e.y)) > rounding) {
            p.at[kept] = a;
            kept += 1u;
        }
    }
    p.count = kept;
    return rounding;
}

bool agaa_isFiniteVertex(rvec4 v) {
    return agaa_isFinite3(rvec3(v.x, v.y, v.z)) && agaa_isFinite(v.w);
}

// Returns a value > 0 if vertices with clip coordinates x, y, w turn from x to y of ndc, < 0 if they turn the other
// way.
real agaa_facing(rvec3 a, rvec3 b, rvec3 c) {
    const rvec3 s = cross(b, c);
    return a.x * s.x + a.y * s.y + a.z * s.z;
}

// Returns the whole image, for triangles without bounds.
agaa_Hull agaa_wholeImage() {
    agaa_Hull hull;
    hull.count = 4u;
    for (uint i = 0u; i < 8u; ++i)
        hull.vertices[i] = rvec4((i & 1u) != 0u ? real(1.0) : real(-1.0), (i & 2u) != 0u ? real(1.0) : real(-1.0),
                                 real(0.5), real(1.0));
    return hull;
}

// Returns the hull of a triangle of either winding.
// a, b, c        Clip coordinates.
// nearPlane      Points in front of the eye have nearPlane.x * z + nearPlane.y * w >= 0: (1, 0) if depth 0 is near,
//                (-1, 1) if depth 1 is near, (1, 1) for depths from -1.
// pixelsPerNdc   Half of the image's size.
agaa_Hull agaa_triangleHull(rvec4 a, rvec4 b, rvec4 c, rvec2 nearPlane, rvec2 pixelsPerNdc) {
    agaa_Hull hull = agaa_wholeImage();
    hull.count = 0u;
    if (!agaa_isFiniteVertex(a) || !agaa_isFiniteVertex(b) || !agaa_isFiniteVertex(c))
        return hull;
    agaa_ClippedTriangle p = agaa_clippedToNear(a, b, c, nearPlane, pixelsPerNdc);
    if (p.count == 0u)
        return hull;
    hull.count = 4u;
    if (!p.bounded)
        return hull;
    // Rasterisers round vertices to 1/256 of a pixel. Large coordinates have larger rounding errors.
    const real rounding = real(0.00390625) + p.size * real(4e-7);
    real halfWidth = real(0.5) + rounding;
    halfWidth += agaa_simplifyClipped(p, rounding);

    rvec2 outline[8];
    uint count = 0u;
    uint corner = 0u;
    for (uint i = 0u; i <= p.count; ++i) {
        const rvec2 at = p.at[i % p.count];
        const rvec2 edge = p.at[(i + 1u) % p.count] - at;
        uint next = agaa_furthestCorner(rvec2(edge.y, -edge.x));
        if (edge.x == real(0.0) && edge.y == real(0.0))
            next = (i & 1u) != 0u ? 1u : 3u;
        if (i == 0u) { // the loop starts and ends at the first edge
            corner = next;
            continue;
        }
        uint steps = (next - corner) & 3u;
        if (steps == 3u) // turned back by rounding
            steps = 0u;
        for (uint k = 0u; k <= steps; ++k) {
            const rvec2 q = at + agaa_squareCorner((corner + k) & 3u, halfWidth);
            if (count < 8u)
                outline[count] = q;
            count = min(count + 1u, 8u);
        }
        corner = (corner + steps) & 3u;
    }
    hull.count = count;
    for (uint i = 0u; i < count; ++i) {
        const rvec2 q = outline[i == 0u ? 0u : (i & 1u) != 0u ? (i + 1u) / 2u : count - i / 2u] / abs(pixelsPerNdc);
        hull.vertices[i] = rvec4(q.x, q.y, real(0.5), real(1.0));
    }
    return hull;
}

#endif
