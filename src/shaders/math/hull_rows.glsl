// The pixels that a triangle touches, row by row, for passes that expand triangles without a rasteriser.
// Source: math/triangle_hull.glsl, whose polygons have their centres inside.
#ifndef AGAA_MATH_HULL_ROWS_GLSL
#define AGAA_MATH_HULL_ROWS_GLSL
#include "real.glsl"
#include "triangle_hull.glsl"

// The part of a triangle in front of the near plane, in pixels.
struct agaa_Outline {
    rvec2 at[4];
    uint count;     // 0 if nothing is in front of the near plane, or a vertex is not finite
    real halfWidth; // of the square around a pixel's centre that touches the triangle
};

// Columns of pixels in a row; none if first > last. They are in the image.
struct agaa_Span {
    real first;
    real last;
};

// a, b, c, nearPlane, pixelsPerNdc: see agaa_triangleHull(). pixelsPerNdc is positive.
agaa_Outline agaa_triangleOutline(rvec4 a, rvec4 b, rvec4 c, rvec2 nearPlane, rvec2 pixelsPerNdc) {
    agaa_Outline outline;
    outline.count = 0u;
    outline.halfWidth = real(0.5);
    for (int i = 0; i < 4; ++i)
        outline.at[i] = rvec2(real(0.0));
    if (!agaa_isFiniteVertex(a) || !agaa_isFiniteVertex(b) || !agaa_isFiniteVertex(c))
        return outline;
    const agaa_ClippedTriangle clipped = agaa_clippedToNear(a, b, c, nearPlane, pixelsPerNdc);
    outline.count = clipped.count;
    if (clipped.count == 0u)
        return outline;
    if (!clipped.bounded) { // the whole image
        outline.count = 4u;
        for (uint i = 0u; i < 4u; ++i)
            outline.at[i] = rvec2(i == 1u || i == 2u ? real(2.0) * pixelsPerNdc.x : real(0.0),
                                  i < 2u ? real(0.0) : real(2.0) * pixelsPerNdc.y);
        return outline;
    }
    for (int i = 0; i < 4; ++i)
        outline.at[i] = clipped.at[i] + pixelsPerNdc;
    // The hull that a rasteriser draws is at most this wide.
    outline.halfWidth += real(3.0) * (real(0.00390625) + clipped.size * real(4e-7));
    return outline;
}

// Returns the pixels between two positions on an axis of the image, widened by halfWidth.
agaa_Span agaa_pixelsBetween(real low, real high, real halfWidth, real size) {
    agaa_Span span;
    span.first = max(-floor(-(low - halfWidth - real(0.5))), real(0.0));
    span.last = min(floor(high + halfWidth - real(0.5)), size - real(1.0));
    return span;
}

// Returns the rows that the outline touches. height: of the image.
agaa_Span agaa_outlineRows(agaa_Outline o, real height) {
    real low = o.at[0].y;
    real high = low;
    for (uint i = 1u; i < o.count; ++i) {
        low = min(low, o.at[i].y);
        high = max(high, o.at[i].y);
    }
    return agaa_pixelsBetween(low, high, o.halfWidth, height);
}

// Returns the columns that the outline touches. width: of the image.
agaa_Span agaa_outlineColumns(agaa_Outline o, real width) {
    real low = o.at[0].x;
    real high = low;
    for (uint i = 1u; i < o.count; ++i) {
        low = min(low, o.at[i].x);
        high = max(high, o.at[i].x);
    }
    return agaa_pixelsBetween(low, high, o.halfWidth, width);
}

// Returns the columns that the outline touches in a row of pixels.
agaa_Span agaa_outlineSpan(agaa_Outline o, real row, real width) {
    const real below = row + real(0.5) - o.halfWidth;
    const real above = row + real(0.5) + o.halfWidth;
    real low = real(3e38);
    real high = real(-3e38);
    rvec2 from = o.at[o.count - 1u];
    for (uint i = 0u; i < o.count; ++i) {
        const rvec2 to = o.at[i];
        if (max(from.y, to.y) >= below && min(from.y, to.y) <= above) {
            // The edge between the borders of the row. A level edge is taken whole, because its slope may overflow.
            const real rise = to.y - from.y;
            const bool isLevel = abs(rise) < real(0.00390625);
            const real slope = isLevel ? real(0.0) : (to.x - from.x) / rise;
            const real left = min(from.x, to.x);
            const real right = max(from.x, to.x);
            const real x0 = clamp(from.x + slope * (clamp(from.y, below, above) - from.y), left, right);
            const real x1 = clamp(to.x + slope * (clamp(to.y, below, above) - to.y), left, right);
            low = min(low, isLevel ? left : min(x0, x1));
            high = max(high, isLevel ? right : max(x0, x1));
        }
        from = to;
    }
    if (low > high) {
        agaa_Span none;
        none.first = real(1.0);
        none.last = real(0.0);
        return none;
    }
    return agaa_pixelsBetween(low, high, o.halfWidth, width);
}
#endif
