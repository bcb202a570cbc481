// The depth planes that surfaces and fragments keep, with the range of their depths. A triangle smaller than a pixel
// often has a plane that leaves the triangle's depths within the pixel, so that a plane alone either extrapolates
// without bound or has the wrong depth at the samples that the triangle covers.
// Source: DCAA (Wang et al., I3D 2016) section 3.2 and figure 6; hard case 61.
#ifndef AGAA_MATH_STORED_PLANE_GLSL
#define AGAA_MATH_STORED_PLANE_GLSL
#include "depth_plane.glsl"

// Layout of the word of slopes, from the lowest bit: 9 bits for each of the slopes in x and y, in two's complement;
// 6 bits of their common exponent; 8 bits of the range, 4 of which are an exponent.
// Slopes of less than 2^-51 are 0, and a pixel's change of depth is at most 2^12.
#define AGAA_SLOPE_EXPONENT_BIAS 75u // 2^-52 in the exponent of a float

uint agaa_packMantissa(real slope, real perUnit) {
    return uint(int(floor(clamp(slope * perUnit, real(-255.0), real(255.0)) + real(0.5)))) & 0x1FFu;
}

real agaa_unpackMantissa(uint bits) {
    return real(int(bits ^ 0x100u) - 256);
}

// Returns the exponent of the largest slope, 0 if the slopes are 0.
uint agaa_slopeExponent(rvec2 slope) {
    const uint exponent = floatBitsToUint(max(abs(slope.x), abs(slope.y))) >> 23u;
    return clamp(exponent, AGAA_SLOPE_EXPONENT_BIAS, AGAA_SLOPE_EXPONENT_BIAS + 63u) - AGAA_SLOPE_EXPONENT_BIAS;
}

// Returns 2^(exponent - 7), the unit of mantissas, whose largest has 8 bits.
real agaa_slopeUnit(uint exponent) {
    return exponent == 0u ? real(0.0) : uintBitsToFloat((exponent + AGAA_SLOPE_EXPONENT_BIAS - 7u) << 23u);
}

rvec2 agaa_storedSlopes(uint word) {
    const real unit = agaa_slopeUnit((word >> 18u) & 63u);
    return rvec2(agaa_unpackMantissa(word & 0x1FFu), agaa_unpackMantissa((word >> 9u) & 0x1FFu)) * unit;
}

// Returns the word without its range. The relative error is at most 2^-8 of the larger slope.
uint agaa_packSlopes(rvec2 slope) {
    const uint exponent = agaa_slopeExponent(slope);
    const real perUnit = exponent == 0u ? real(0.0) : real(1.0) / agaa_slopeUnit(exponent);
    return agaa_packMantissa(slope.x, perUnit) | (agaa_packMantissa(slope.y, perUnit) << 9u) | (exponent << 18u);
}

// The range is stored as its half, in units of the change of depth across the pixel, above which it limits nothing.
// Both functions are inverse to each other but for the rounding up to 4 bits.
uint agaa_packHalfRange(real halfRange, rvec2 slope) {
    const real whole = abs(slope.x) + abs(slope.y);
    const real ratio = whole > real(0.0) ? clamp(halfRange / whole, real(0.000030517578125), real(1.0)) : real(1.0);
    // 15 steps of a float, by which the quotient may be off, do not round up.
    return (((floatBitsToUint(ratio) + 0x7FFF0u) >> 19u) - (112u << 4u)) << 24u;
}

real agaa_storedHalfRange(uint word, rvec2 slope) {
    return uintBitsToFloat(((word >> 24u) + (112u << 4u)) << 19u) * (abs(slope.x) + abs(slope.y));
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
// depths   Middle and half of the range of depths.
// anchor   Centroid of the covered samples, as an offset from the pixel's centre. The plane is exact there, because the
//          rounding of slopes would move the depth of a steep plane.
agaa_StoredPlane agaa_storePlane(rvec3 plane, rvec2 depths, rvec2 anchor) {
    const uint slopes = agaa_packSlopes(rvec2(plane.y, plane.z));
    const rvec2 rounded = agaa_storedSlopes(slopes);
    const real depth = agaa_planeDepth(plane, anchor);
    const real inside = clamp(depth, depths.x - depths.y, depths.x + depths.y);
    const rvec2 lost = rvec2(plane.y, plane.z) - rounded;
    agaa_StoredPlane stored;
    stored.depth = plane.x + (lost.x * anchor.x + lost.y * anchor.y) + (inside - depth);
    const real middle = agaa_planeDepth(rvec3(stored.depth, rounded.x, rounded.y), anchor);
    stored.slopes = slopes | agaa_packHalfRange(depths.y + abs(depths.x - middle), rounded);
    return stored;
}

// Returns middle and half of a range of depths.
rvec2 agaa_middleAndHalf(rvec2 range) {
    return rvec2(range.x + range.y, range.y - range.x) * real(0.5);
}

// Returns the plane flattened around the middle of its range, so that it stays in the range over the whole pixel.
// Surfaces that merge have such planes: one that leaves the range of a narrow wall would come in front of what hides
// it.
agaa_DepthPlane agaa_flattenedPlane(agaa_DepthPlane plane) {
    const rvec2 depths = agaa_middleAndHalf(plane.range);
    const real reach = (abs(plane.slope.x) + abs(plane.slope.y)) * real(0.5);
    agaa_DepthPlane flattened = plane;
    flattened.depth = depths.x;
    flattened.slope = plane.slope * (reach > depths.y ? depths.y / reach : real(1.0));
    return flattened;
}

rvec3 agaa_storedPlane(agaa_StoredPlane stored) {
    const rvec2 slopes = agaa_storedSlopes(stored.slopes);
    return rvec3(stored.depth, slopes.x, slopes.y);
}

// Returns middle and half of the range of depths. anchor: as stored with.
rvec2 agaa_storedDepths(agaa_StoredPlane stored, rvec2 anchor) {
    return rvec2(agaa_planeDepth(agaa_storedPlane(stored), anchor),
                 agaa_storedHalfRange(stored.slopes, agaa_storedSlopes(stored.slopes)));
}

// Returns the plane of a surface, with its range. widening: of the range, 1 or more.
agaa_DepthPlane agaa_loadedPlane(agaa_StoredPlane stored, rvec2 anchor, real widening) {
    const rvec2 depths = agaa_storedDepths(stored, anchor);
    agaa_DepthPlane plane;
    plane.depth = stored.depth;
    plane.slope = agaa_storedSlopes(stored.slopes);
    plane.range = rvec2(depths.x - depths.y * widening, depths.x + depths.y * widening);
    return plane;
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
