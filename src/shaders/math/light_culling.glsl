// Light culling: tests whether lights may reach anything within a box.
// Sources: Olsson, Billeter and Assarsson 2012, "Clustered Deferred and Forward Shading", section 4; Wronski 2017,
// "Cull that cone!" for cones against spheres.
#ifndef AGAA_MATH_LIGHT_CULLING_GLSL
#define AGAA_MATH_LIGHT_CULLING_GLSL
#include "real.glsl"

// Returns the bound of the rounding error of a position whose coordinates have this size.
real agaa_positionError(real size) { return real(1e-5) * size; }

real agaa_largestOf(rvec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Returns whether agaa_pointAttenuation() may be above 0 within the box from `low` to `high`. A range of 0 has no end.
bool agaa_rangeReaches(rvec3 light, real range, rvec3 low, rvec3 high) {
    if (!(range > real(0.0)))
        return true;
    const rvec3 d = clamp(light, low, high) - light;
    const real size = max(agaa_largestOf(light), max(agaa_largestOf(low), agaa_largestOf(high)));
    const real reach = range * real(1.002) + agaa_positionError(size); // views are rotations up to a thousandth
    return !(dot(d, d) > reach * reach); // NaN: true
}

// Returns whether agaa_spotCone() may be above 0 within the sphere. direction: unit, from the light.
bool agaa_coneReaches(rvec3 light, rvec3 direction, real cosOuter, rvec3 centre, real radius) {
    if (cosOuter <= real(0.0)) // half of space or more
        return true;
    const rvec3 v = centre - light;
    const real along = dot(v, direction);
    const real across = sqrt(max(dot(v, v) - along * along, real(0.0)));
    const real sinOuter = sqrt(max(real(1.0) - cosOuter * cosOuter, real(0.0)));
    // distance from the cone, if its nearest point is on the side
    const real outside = across * cosOuter - along * sinOuter;
    // The difference of squares is exact to a thousandth. Views are rotations up to a thousandth, so their angles are,
    // too.
    const real reach = radius * real(1.002) + real(3e-3) * (abs(along) + across) +
                       agaa_positionError(max(agaa_largestOf(light), agaa_largestOf(centre)));
    return !(outside > reach || along < -reach); // NaN: true
}
#endif
