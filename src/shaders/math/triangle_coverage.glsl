// Coverage of a pixel's coverage samples by a triangle, exact up to the rounding of its edges.
// Sources: DCAA (Wang et al., I3D 2016) section 3.1; Olano and Greer 1997, "Triangle Scan Conversion using 2D
// Homogeneous Coordinates"; hard cases 13, 14 (differences before products), 47 (shared edges), 48 (slivers) and 50
// (vertices behind the eye).
//
// A vertex is (x w, y w, w) with x, y in pixels; its w may have any sign. Triangles that share an edge must pass
// identical vertices: then each sample near the edge belongs to exactly one of them.
#ifndef AGAA_MATH_TRIANGLE_COVERAGE_GLSL
#define AGAA_MATH_TRIANGLE_COVERAGE_GLSL
#include "coverage_pattern.glsl"
#include "real.glsl"
#include "sanitise.glsl"

// Converts clip coordinates x, y, w to a vertex in pixels. pixelsPerNdc: half of the image's size, negative if an axis
// of the image is opposite to ndc.
rvec3 agaa_vertexInPixels(rvec3 clip, rvec2 pixelsPerNdc) {
    PRECISE real x = clip.x * pixelsPerNdc.x + clip.z * abs(pixelsPerNdc.x);
    PRECISE real y = clip.y * pixelsPerNdc.y + clip.z * abs(pixelsPerNdc.y);
    return rvec3(x, y, clip.z);
}

// Returns a power of two, which causes no rounding, that scales sizes to [2^-36, 2^38], so that products of three
// vertices neither overflow nor underflow.
real agaa_vertexScale(real size) {
    if (size > real(1.152921504606846976e18)) // 2^60
        return real(8.0779356694631608874e-28); // 2^-90
    if (size > real(1048576.0)) // 2^20
        return real(9.094947017729282379e-13); // 2^-40
    if (size < real(8.6736173798840354721e-19)) // 2^-60
        return real(1.2379400392853802749e27); // 2^90
    return size < real(9.5367431640625e-7) ? real(1099511627776.0) : real(1.0);
}

// Returns x - centre * w. The product is split, so that its rounding error is 2^-9 of that of a plain product at 16384
// pixels.
real agaa_fromCentre(real x, real w, real centre) {
    PRECISE real carry = w * real(32769.0);
    PRECISE real high = carry - (carry - w);
    PRECISE real low = w - high;
    PRECISE real difference = (x - centre * high) - centre * low;
    return difference;
}

real agaa_scaleOfVertex(rvec3 v) {
    return agaa_vertexScale(abs(v.x) + abs(v.y) + abs(v.z) * real(16384.0));
}

// Returns the scaled vertex with the pixel's centre as origin. It depends only on vertex and pixel.
rvec3 agaa_vertexFromCentre(rvec3 v, rvec2 centre) {
    const rvec3 s = v * agaa_scaleOfVertex(v);
    return rvec3(agaa_fromCentre(s.x, s.z, centre.x), agaa_fromCentre(s.y, s.z, centre.y), s.z);
}

// Defines one order of two vertices, so that both triangles at an edge compute the same line.
bool agaa_isOrdered(rvec3 a, rvec3 b) {
    if (a.x != b.x)
        return a.x < b.x;
    if (a.y != b.y)
        return a.y < b.y;
    return a.z < b.z;
}

// Returns the line through two vertices as a x + b y + c, positive on the left of a to b if both w are positive. The
// line from b to a is its exact negative.
rvec3 agaa_edgeLine(rvec3 a, rvec3 b) {
    const bool ordered = agaa_isOrdered(a, b);
    const rvec3 p = ordered ? a : b;
    const rvec3 q = ordered ? b : a;
    PRECISE real x = p.y * q.z - p.z * q.y;
    PRECISE real y = p.z * q.x - p.x * q.z;
    PRECISE real c = p.x * q.y - p.y * q.x;
    return ordered ? rvec3(x, y, c) : rvec3(-x, -y, -c);
}

// An edge for intersection with rows. Samples on the line count as right of it, or as above it if it is parallel to the
// rows, as if all samples were moved right a little and up by still less. Exactly one of the triangles around a vertex
// at a sample covers the sample.
struct agaa_Edge {
    // two points of the line, the vertices if they are near the pixel, because the error increases with distance
    rvec2 pointA;
    rvec2 pointB;
    real slope;   // x of the line decreases by this for each pixel of y
    bool level;   // parallel to the rows
    bool swapped; // covered samples are left of the line, or below it
    bool outside; // the line passes the pixel at a distance
};

bool agaa_isNearPixel(rvec3 v) {
    const real reach = abs(v.z) * real(8.0);
    return reach > real(0.0) && abs(v.x) <= reach && abs(v.y) <= reach;
}

agaa_Edge agaa_edgeFromCentre(rvec3 a, rvec3 b) {
    agaa_Edge edge;
    const rvec3 line = agaa_edgeLine(a, b);
    const real size = max(abs(line.x), abs(line.y));
    edge.pointA = rvec2(real(0.0));
    edge.pointB = rvec2(real(0.0));
    edge.slope = real(0.0);
    edge.level = abs(line.x) < size * real(1e-20);
    // Lines at infinity and equal vertices are outside, too.
    edge.outside = !(abs(line.z) < size * real(1.5));
    if (edge.outside) {
        edge.swapped = line.z < real(0.0) || (line.z == real(0.0) && !agaa_isOrdered(a, b));
        return edge;
    }
    edge.swapped = edge.level ? line.y < real(0.0) : line.x < real(0.0);
    if (!edge.level)
        edge.slope = line.y / line.x;
    const bool ordered = agaa_isOrdered(a, b);
    const rvec3 p = ordered ? a : b;
    const rvec3 q = ordered ? b : a;
    const bool pIsNear = agaa_isNearPixel(p);
    const bool qIsNear = agaa_isNearPixel(q);
    // If no vertex is near, the point is the one of the line nearest to the centre.
    const rvec3 unit = line / size;
    edge.pointA = rvec2(unit.x, unit.y) * (-unit.z / (unit.x * unit.x + unit.y * unit.y));
    if (pIsNear)
        edge.pointA = rvec2(p.x / p.z, p.y / p.z);
    else if (qIsNear)
        edge.pointA = rvec2(q.x / q.z, q.y / q.z);
    edge.pointB = edge.pointA;
    if (pIsNear && qIsNear)
        edge.pointB = rvec2(q.x / q.z, q.y / q.z);
    return edge;
}

// Returns the samples of a row that an edge covers, in the lowest bits. phase, y: of the row.
uint agaa_edgeSpan(agaa_Edge edge, real y, real phase, uint columns) {
    const uint all = (1u << columns) - 1u;
    uint left = 0u; // samples left of the line
    if (edge.level && !edge.outside) {
        left = y >= edge.pointA.y ? 0u : columns;
    } else if (!edge.outside) {
        // The vertex whose y is closer gives an exact result for a row through the vertex.
        const bool useB = abs(y - edge.pointB.y) < abs(y - edge.pointA.y);
        const rvec2 from = useB ? edge.pointB : edge.pointA;
        PRECISE real x = (from.x + real(0.5)) - edge.slope * (y - from.y);
        PRECISE real at = x * real(columns) - phase;
        left = uint(clamp(-floor(-at), real(0.0), real(columns)));
    }
    return ((all << left) & all) ^ (edge.swapped ? all : 0u);
}

// Returns whether an edge covers a sample at any place of the pixel, by the rules of rows.
// at   From the pixel's centre, in pixels.
bool agaa_edgeCovers(agaa_Edge edge, rvec2 at) {
    const bool useB = abs(at.y - edge.pointB.y) < abs(at.y - edge.pointA.y);
    const rvec2 from = useB ? edge.pointB : edge.pointA;
    PRECISE real x = from.x - edge.slope * (at.y - from.y);
    // On the line, right of it or above.
    const bool isBeyond = edge.outside || (edge.level ? at.y >= edge.pointA.y : at.x >= x);
    return isBeyond != edge.swapped;
}

// Returns the samples on the left of the edge from a to b, for positive w. The edge from b to a has all others.
uvec4 agaa_edgeCoverage(agaa_Edge edge, uint samples) {
    const uint columns = agaa_coverageColumns(samples);
    const uint rowsOfWord = 32u / columns;
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word * 32u < samples; ++word) {
        uint bits = 0u;
        for (uint i = 0u; i < rowsOfWord; ++i) {
            const uint row = word * rowsOfWord + i;
            bits |= agaa_edgeSpan(edge, agaa_coverageRowY(row, samples), agaa_coveragePhase(row, samples), columns)
                    << (i * columns);
        }
        mask[word] = bits;
    }
    return mask;
}

// Returns the mask of a triangle from the masks of its edges bc, ca and ab. The vertices are those of
// agaa_vertexFromCentre(). Triangles with non-finite vertices, or without area, cover nothing.
uvec4 agaa_joinEdges(rvec3 a, rvec3 b, rvec3 c, uvec4 bc, uvec4 ca, uvec4 ab, uint samples) {
    const real facing = a.z * agaa_edgeLine(b, c).z + b.z * agaa_edgeLine(c, a).z + c.z * agaa_edgeLine(a, b).z;
    const bool finite = agaa_isFinite3(a) && agaa_isFinite3(b) && agaa_isFinite3(c) && agaa_isFinite(facing);
    if (!finite || facing == real(0.0) || max(a.z, max(b.z, c.z)) <= real(0.0))
        return uvec4(0u);
    const uvec4 left = bc & ca & ab;
    const uvec4 right = agaa_coverageComplement(bc | ca | ab, samples);
    // One of the two is empty for either winding. Rounding may change the sign of a sliver's area.
    if (min(a.z, min(b.z, c.z)) > real(0.0))
        return left | right;
    // Behind the eye all signs are opposite.
    return facing > real(0.0) ? left : right;
}

// Returns the samples that the part of the triangle in front of the eye covers. centre: of the pixel, in pixels.
uvec4 agaa_triangleCoverage(rvec3 a, rvec3 b, rvec3 c, rvec2 centre, uint samples) {
    const rvec3 p = agaa_vertexFromCentre(a, centre);
    const rvec3 q = agaa_vertexFromCentre(b, centre);
    const rvec3 r = agaa_vertexFromCentre(c, centre);
    return agaa_joinEdges(p, q, r, agaa_edgeCoverage(agaa_edgeFromCentre(q, r), samples),
                          agaa_edgeCoverage(agaa_edgeFromCentre(r, p), samples),
                          agaa_edgeCoverage(agaa_edgeFromCentre(p, q), samples), samples);
}

#endif
