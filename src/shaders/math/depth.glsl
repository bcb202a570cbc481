// Conversion of depth buffer values to view-space positions.
// Sources: AGAA (Crassin et al., TVCG 2016) Algorithm 1(a); hard cases 16 (reversed depth, infinite
// far plane), 20 (depth quantum against k) and 22 (camera-relative clustering).
//
// View space looks down -z; clip = P * view with P column-major, p22 = P[2][2], p32 = P[3][2];
// depth is clip.z / clip.w in [0, 1], either direction, far plane finite or not.
#ifndef AGAA_MATH_DEPTH_GLSL
#define AGAA_MATH_DEPTH_GLSL
#include "real.glsl"

// Limit of distances. Squares and cubes of it fit into a float.
real agaa_maxViewDistance() {
    return real(1e12);
}

// Returns |d + p22|, which has the sign of p32 in front of the camera for every perspective projection. It is kept
// above 0 at an infinite far plane.
real agaa_depthDenominator(real d, real p22, real p32) {
    const real sum = p32 < real(0.0) ? -(d + p22) : d + p22;
    return max(sum, max(abs(p32) / agaa_maxViewDistance(), real(1e-25)));
}

real agaa_viewZFromDepth(real d, real p22, real p32, uint orthographic) {
    real z = real(0.0);
    if (orthographic != 0u) {
        z = (d - p32) * agaa_guardedReciprocal(p22);
    } else {
        z = -abs(p32) / agaa_depthDenominator(d, p22, p32);
    }
    return clamp(z, -agaa_maxViewDistance(), agaa_maxViewDistance());
}

// Returns the depth at a view z, [0, 1]: the inverse of agaa_viewZFromDepth().
real agaa_depthOfViewZ(real z, real p22, real p32, uint orthographic) {
    const real depth = orthographic != 0u ? p22 * z + p32 : -p22 - p32 / min(z, -real(1e-25));
    return clamp(depth, real(0.0), real(1.0));
}

// Returns the step in view z of one step `quantum` of the depth buffer at depth d, |dz/dd| * quantum. The quantum is
// 2^-24 for a 24-bit format, and the spacing of floats at d for a float format.
real agaa_depthQuantum(real z, real d, real p22, real p32, uint orthographic, real quantum) {
    const real q = agaa_saturate(quantum);
    real dz = real(0.0);
    if (orthographic != 0u) {
        dz = q * abs(agaa_guardedReciprocal(p22));
    } else {
        // dz/dd = p32 / (d + p22)^2 = -z / (d + p22)
        dz = min(abs(z), agaa_maxViewDistance()) * (q / agaa_depthDenominator(d, p22, p32));
    }
    return min(dz, agaa_maxViewDistance());
}

// Returns the view-space position of a point of the image at view z. offsetX and offsetY shift the image (an off-centre
// frustum, jitter): P[2][0] and P[2][1], or P[3][0] and P[3][1] of an orthographic projection.
rvec3 agaa_viewPosition(rvec2 ndc, real z, real p00, real p11, real offsetX, real offsetY,
                        uint orthographic) {
    const real ix = agaa_guardedReciprocal(p00);
    const real iy = agaa_guardedReciprocal(p11);
    rvec3 p = rvec3((ndc.x - offsetX) * ix, (ndc.y - offsetY) * iy, z);
    if (orthographic == 0u) {
        p.x = -z * (ndc.x + offsetX) * ix;
        p.y = -z * (ndc.y + offsetY) * iy;
    }
    return p;
}

// Returns the distance with which lengths in a view scale. An orthographic view has one scale and an arbitrary eye, so
// half of the view's width replaces the distance, as in a perspective view of 90 degrees.
real agaa_scaleDistance(real fromEye, real p00, uint orthographic) {
    return orthographic != 0u ? abs(agaa_guardedReciprocal(p00)) : fromEye;
}

// Returns the characteristic length of Equation 1 at this distance: the larger of k and perDistance * distance.
// clustering.glsl adds the step of the depth buffer, which depends on the pair of samples.
real agaa_characteristicLength(real k, real perDistance, real distance) {
    return max(k, perDistance * abs(distance));
}

#endif
