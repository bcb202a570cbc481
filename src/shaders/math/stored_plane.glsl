// The depth planes that surfaces and fragments keep, with the range of their depths. A triangle smaller than a pixel
// often has a plane that leaves the triangle's depths within the pixel, so that a plane alone either extrapolates
// without bound or has the wrong depth at the samples that the triangle covers.
// Source: DCAA (Wang et al., I3D 2016) section 3.2 and figure 6; hard case 61.
#ifndef AGAA_MATH_STORED_PLANE_GLSL
#define AGAA_MATH_STORED_PLANE_GLSL
#include "depth_plane.glsl"

// Layout of the word of slopes, from the lowest bit: 8 bits for each of the slopes in x and y, in two's complement;
// 6 bits of their common exponent; 5 bits for each side of the range.
// Slopes of less than 2^-51 are 0, and a pixel's change of depth is at most 2^12.
#define AGAA_SLOPE_EXPONENT_BIAS 75u // 2^-52 in the exponent of a float
#define AGAA_SIDE_CODES 31u          // the last code is a side of 0

uint agaa_packMantissa(real slope, real perUnit) {
    return uint(int(floor(clamp(slope * perUnit, real(-127.0), real(127.0)) + real(0.5)))) & 0xFFu;
}

real agaa_unpackMantissa(uint bits) {
    return real(int(bits ^ 0x80u) - 128);
}

// Returns the exponent of the largest slope, 0 if the slopes are 0.
uint agaa_slopeExponent(rvec2 slope) {
    const uint exponent = floatBitsToUint(max(abs(slope.x), abs(slope.y))) >> 23u;
    return clamp(exponent, AGAA_SLOPE_EXPONENT_BIAS, AGAA_SLOPE_EXPONENT_BIAS + 63u) - AGAA_SLOPE_EXPONENT_BIAS;
}

// Returns 2^(exponent - 6), the unit of mantissas, whose largest has 7 bits.
real agaa_slopeUnit(uint exponent) {
    return exponent == 0u ? real(0.0) : uintBitsToFloat((exponent + AGAA_SLOPE_EXPONENT_BIAS - 6u) << 23u);
}

rvec2 agaa_storedSlopes(uint word) {
    const real unit = agaa_slopeUnit((word >> 16u) & 63u);
    return rvec2(agaa_unpackMantissa(word & 0xFFu), agaa_unpackMantissa((word >> 8u) & 0xFFu)) * unit;
}

// Returns the word without its range. The error is at most 1/127 of the larger slope.
uint agaa_packSlopes(rvec2 slope) {
    const uint exponent = agaa_slopeExponent(slope);
    const real perUnit = exponent == 0u ? real(0.0) : real(1.0) / agaa_slopeUnit(exponent);
    return agaa_packMantissa(slope.x, perUnit) | (agaa_packMantissa(slope.y, perUnit) << 8u) | (exponent << 16u);
}

// A side of the range is stored in units of the change of depth across the pixel, above which it limits nothing, in
// steps of the root of 2. It is rounded to the nearest step: ranges that grew with every merge would bring surfaces in
// front of what hides them.
uint agaa_packSide(real side, real whole) {
    const real ratio = whole > real(0.0) ? clamp(side / whole, real(1e-9), real(1.0)) : real(1.0);
    return uint(clamp(floor(real(0.5) - real(2.0) * log2(ratio)), real(0.0), real(AGAA_SIDE_CODES)));
}

real agaa_unpackSide(uint code, real whole) {
    return code == AGAA_SIDE_CODES ? real(0.0) : whole * exp2(real(-0.5) * real(code));
}

// Returns the depth of a plane at an offset from the pixel's centre, without a range.
real agaa_planeDepth(rvec3 plane, rvec2 offset) {
    PRECISE real depth = plane.x + (plane.y * offset.x + plane.z * offset.y);
    return depth;
}

// The two words of a plane.
struct agaa_StoredPlane {
    real depth;  // at the pixel's centre, far outside the range for some small triangles
    uint slopes; // with the range
};

// Depths increase away from the eye, or towards it if they are negated.
// plane    Depth at the pixel's centre, and its change per pixel in x and in y.
// depths   A depth in the range, and the distances of the lowest and the highest depth from it.
// anchor   Centroid of the covered samples, as an offset from the pixel's centre. The plane is exact there, because the
//          rounding of slopes would move the depth of a steep plane.
agaa_StoredPlane agaa_storePlane(rvec3 plane, rvec3 depths, rvec2 anchor) {
    const uint slopes = agaa_packSlopes(rvec2(plane.y, plane.z));
    const rvec2 rounded = agaa_storedSlopes(slopes);
    const real whole = abs(rounded.x) + abs(rounded.y);
    const real depth = agaa_planeDepth(plane, anchor);
    const real inside = clamp(depth, depths.x - depths.y, depths.x + depths.z);
    const rvec2 lost = rvec2(plane.y, plane.z) - rounded;
    agaa_StoredPlane stored;
    stored.depth = plane.x + (lost.x * anchor.x + lost.y * anchor.y) + (inside - depth);
    const real moved = agaa_planeDepth(rvec3(stored.depth, rounded.x, rounded.y), anchor) - depths.x;
    stored.slopes = slopes | (agaa_packSide(depths.y + moved, whole) << 22u) |
                    (agaa_packSide(depths.z - moved, whole) << 27u);
    return stored;
}

// Returns the middle of a range of depths, and the distances of its ends.
rvec3 agaa_depthsOfRange(rvec2 range) {
    const real halfRange = (range.y - range.x) * real(0.5);
    return rvec3((range.x + range.y) * real(0.5), halfRange, halfRange);
}

rvec3 agaa_storedPlane(agaa_StoredPlane stored) {
    const rvec2 slopes = agaa_storedSlopes(stored.slopes);
    return rvec3(stored.depth, slopes.x, slopes.y);
}

// Returns the distances of the lowest and the highest depth from the depth at the anchor.
rvec2 agaa_storedSides(agaa_StoredPlane stored) {
    const rvec2 slopes = agaa_storedSlopes(stored.slopes);
    const real whole = abs(slopes.x) + abs(slopes.y);
    return rvec2(agaa_unpackSide((stored.slopes >> 22u) & 31u, whole), agaa_unpackSide(stored.slopes >> 27u, whole));
}

// Returns the depth at the anchor, and the distances of the lowest and the highest depth from it. anchor: as stored
// with.
rvec3 agaa_storedDepths(agaa_StoredPlane stored, rvec2 anchor) {
    const rvec2 sides = agaa_storedSides(stored);
    return rvec3(agaa_planeDepth(agaa_storedPlane(stored), anchor), sides.x, sides.y);
}

// Returns the plane of a surface, with its range.
// depths      agaa_storedDepths()
// isReduced   The anchor is the centroid of a part of the covered samples, which may be at an end of the range; the
//             range is then widened to both sides.
agaa_DepthPlane agaa_planeOfDepths(agaa_StoredPlane stored, rvec3 depths, bool isReduced) {
    const real both = depths.y + depths.z;
    agaa_DepthPlane plane;
    plane.depth = stored.depth;
    plane.slope = agaa_storedSlopes(stored.slopes);
    plane.range = rvec2(depths.x - (isReduced ? both : depths.y), depths.x + (isReduced ? both : depths.z));
    return plane;
}

agaa_DepthPlane agaa_loadedPlane(agaa_StoredPlane stored, rvec2 anchor, bool isReduced) {
    return agaa_planeOfDepths(stored, agaa_storedDepths(stored, anchor), isReduced);
}

// A plane that is stored whole has its range in one word: both ends in units of the change of depth across the pixel,
// rounded outwards, 16 bits each.
uint agaa_packRange(agaa_DepthPlane plane) {
    const real whole = abs(plane.slope.x) + abs(plane.slope.y);
    const real perUnit = whole > real(0.0) ? real(65535.0) / whole : real(0.0);
    const rvec2 ends = (plane.range - rvec2(plane.depth - whole * real(0.5))) * perUnit;
    return uint(floor(clamp(ends.x, real(0.0), real(65535.0)))) |
           (uint(ceil(clamp(ends.y, real(0.0), real(65535.0)))) << 16u);
}

rvec2 agaa_unpackRange(real depth, rvec2 slope, uint word) {
    const real whole = abs(slope.x) + abs(slope.y);
    return rvec2(depth - whole * real(0.5)) +
           rvec2(real(word & 0xFFFFu), real(word >> 16u)) * (whole * real(0.0000152590218967));
}

#endif
