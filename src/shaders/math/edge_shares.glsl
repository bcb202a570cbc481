// The lines that jagged edges stand for, and the shares of pixels beyond them (Jimenez et al. 2012, SMAA). The paper
// looks shares up in a texture of areas; here they are computed.
//
// An edge lies between a row of pixels and the row across: the one above, or for columns the one to the left. Heights
// are above the row's boundary, in pixels. Shares have x: of the pixel, which shows the colour across, and y: of the
// pixel across, which shows this pixel's colour.
#ifndef AGAA_MATH_EDGE_SHARES_GLSL
#define AGAA_MATH_EDGE_SHARES_GLSL
#include "real.glsl"

// Edges that cross the end of an edge.
const uint agaa_crossesHere = 1u;   // beside the row
const uint agaa_crossesAcross = 2u; // beside the row across

// Returns the areas below and above the boundary of a line with these heights at its ends.
rvec2 agaa_areasOfLine(real from, real to, real width) {
    const real above = max(max(from, to), real(0.0));
    const real below = max(-min(from, to), real(0.0));
    if (above > real(0.0) && below > real(0.0)) // two triangles
        return rvec2(below * below, above * above) * (width / (real(2.0) * (below + above)));
    const real mean = real(0.5) * width * (from + to);
    return rvec2(max(-mean, real(0.0)), max(mean, real(0.0)));
}

// Returns the height of the line's end, which lies in the middle of the edge that crosses there. other: the edges that
// cross at the other end.
real agaa_endHeight(uint crossing, uint other) {
    if (crossing == (agaa_crossesHere | agaa_crossesAcross)) // either may continue the line: the one that it crosses to
        crossing = other == agaa_crossesHere ? agaa_crossesAcross : other == agaa_crossesAcross ? agaa_crossesHere : 0u;
    return crossing == agaa_crossesHere ? real(-0.5) : crossing == agaa_crossesAcross ? real(0.5) : real(0.0);
}

// Returns the areas of a line from a height to the boundary at `middle`, between two positions before the middle.
rvec2 agaa_areasOfHalf(real height, real middle, real from, real to) {
    return agaa_areasOfLine(height * (middle - from) / middle, height * (middle - to) / middle, to - from);
}

// Returns the height where the image is not moved. An end without a crossing edge lies on the boundary.
real agaa_movedHeight(real height, real moved) {
    return height == real(0.0) ? height : height + moved;
}

// before, after   Pixels of the edge before and after this one.
// first, last     The edges that cross at its ends.
// moved           How far the camera's jitter moved the image away from the row across (SMAA T2x, section 4.5). The
//                 shares are those of pixels that are not moved.
rvec2 agaa_edgeShares(real before, real after, uint first, uint last, real moved) {
    const real length = before + after + real(1.0);
    const real seenFrom = agaa_endHeight(first, last);
    const real seenTo = agaa_endHeight(last, first);
    const real from = agaa_movedHeight(seenFrom, moved);
    const real to = agaa_movedHeight(seenTo, moved);
    if (seenFrom * seenTo < real(0.0)) // one line through the edge
        return agaa_areasOfLine((from * (after + real(1.0)) + to * before) / length,
                                (from * after + to * (before + real(1.0))) / length, real(1.0));
    const real middle = real(0.5) * length; // two lines meet there on the boundary
    rvec2 shares = rvec2(real(0.0));
    if (before < middle)
        shares += agaa_areasOfHalf(from, middle, before, min(before + real(1.0), middle));
    if (after < middle)
        shares += agaa_areasOfHalf(to, middle, after, min(after + real(1.0), middle));
    return shares;
}

// Returns the part of a true corner's share that remains, per side. A corner whose crossing edge is longer than a pixel
// belongs to the shape. Only the nearer end counts.
// first, last   Longer edges that cross at the ends, as agaa_crosses….
rvec2 agaa_cornerShares(real before, real after, uint first, uint last) {
    const real rounding = real(0.75); // of the share
    const real toFirst = before < after ? rounding : before > after ? real(0.0) : real(0.5) * rounding;
    const real toLast = rounding - toFirst;
    rvec2 rest = rvec2(real(1.0));
    if ((first & agaa_crossesHere) != 0u)
        rest.x -= toFirst;
    if ((last & agaa_crossesHere) != 0u)
        rest.x -= toLast;
    if ((first & agaa_crossesAcross) != 0u)
        rest.y -= toFirst;
    if ((last & agaa_crossesAcross) != 0u)
        rest.y -= toLast;
    return rest;
}

// Staircases. Their steps alternate between edges along rows and along columns, so that they stand for a diagonal line.

// Returns the integral of clamp(z, 0, 1) up to z.
real agaa_integralOfClamped(real z) {
    const real c = agaa_saturate(z);
    return real(0.5) * c * c + max(z - real(1.0), real(0.0));
}

// Returns the mean of clamp(z, 0, 1) for z from a to b.
real agaa_meanOfClamped(real a, real b) {
    const real range = b - a;
    if (abs(range) < real(1e-3))
        return agaa_saturate(real(0.5) * (a + b));
    return (agaa_integralOfClamped(b) - agaa_integralOfClamped(a)) / range;
}

// Returns the share of the pixel with corners (0, 0) and (1, 1) that lies above a line; y is downward, from.x < to.x.
real agaa_shareAbove(rvec2 from, rvec2 to) {
    const real slope = (to.y - from.y) / (to.x - from.x);
    const real atLeft = from.y - slope * from.x;
    return agaa_meanOfClamped(atLeft, atLeft + slope);
}

// Returns the end of the line at the lower left of a staircase, relative to the pixel whose upper edge is its step 0.
// steps       Steps from there to the last one.
// isDoubled   The last step has twice the length; the line passes through its middle. Otherwise it ends in the middle
//             of the step.
rvec2 agaa_lowerEnd(uint steps, bool isDoubled) {
    const rvec2 end = rvec2(-real(steps / 2u), real((steps + 1u) / 2u));
    const rvec2 middle = (steps & 1u) != 0u ? rvec2(real(0.0), real(-0.5)) : rvec2(real(0.5), real(0.0));
    return isDoubled ? end : end + middle;
}

// Returns the same at the upper right.
rvec2 agaa_upperEnd(uint steps, bool isDoubled) {
    const rvec2 end = rvec2(real(steps / 2u + 1u), -real((steps + 1u) / 2u));
    const rvec2 middle = (steps & 1u) != 0u ? rvec2(real(0.0), real(0.5)) : rvec2(real(-0.5), real(0.0));
    return isDoubled ? end : end + middle;
}

// Staircases with fewer steps are edges with corners.
const uint agaa_fewestSteps = 6u;

// Returns the shares of the pixel at step 0 and of the pixel above it.
rvec2 agaa_diagonalShares(rvec2 lower, rvec2 upper) {
    const rvec2 up = rvec2(real(0.0), real(1.0));
    return rvec2(agaa_shareAbove(lower, upper), real(1.0) - agaa_shareAbove(lower + up, upper + up));
}

#endif
