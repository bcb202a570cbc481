// Facet normals of depth planes, in view space. A plane of depths over the image is a plane of clip coordinates, whose
// normal in view space is the product with the transposed projection.
// Source: DCAA (Wang et al., I3D 2016) sections 3.4 and 4.3, whose surfaces merge by facet normals.
#ifndef AGAA_MATH_FACET_NORMAL_GLSL
#define AGAA_MATH_FACET_NORMAL_GLSL
#include "real.glsl"

// The normal of a plane is, up to its length, slope.x * alongX + slope.y * alongY + depth * perDepth + level. Slopes
// are changes of depth per pixel, and the depth is that at the pixel's centre, away from the eye.
struct agaa_FacetFrame {
    rvec3 alongX;
    rvec3 alongY;
    rvec3 perDepth;
    rvec3 level;
};

// ndc           Centre of the pixel.
// pixelsPerNdc  Half of the size of the image.
// scale, offset, p22, orthographic   The projection, as in agaa_viewPosition().
// sign          -1 if depths away from the eye are negated, otherwise 1.
agaa_FacetFrame agaa_facetFrame(rvec2 ndc, rvec2 pixelsPerNdc, rvec2 scale, rvec2 offset, real p22, uint orthographic,
                                real sign) {
    const bool isPerspective = orthographic == 0u;
    const rvec2 slant = isPerspective ? offset + ndc : rvec2(real(0.0));
    agaa_FacetFrame facets;
    facets.alongX = rvec3(scale.x, real(0.0), slant.x) * (pixelsPerNdc.x * sign);
    facets.alongY = rvec3(real(0.0), scale.y, slant.y) * (pixelsPerNdc.y * sign);
    facets.perDepth = rvec3(real(0.0), real(0.0), isPerspective ? -sign : real(0.0));
    facets.level = rvec3(real(0.0), real(0.0), -p22);
    return facets;
}

// Returns the unit normal of a plane, or (0, 0, 0) if it has none.
// plane   Depth at the pixel's centre, and its change per pixel in x and in y.
rvec3 agaa_facetNormal(agaa_FacetFrame facets, rvec3 plane) {
    const rvec3 n =
        (facets.alongX * plane.y + facets.alongY * plane.z) + (facets.perDepth * plane.x + facets.level);
    const real largest = max(max(abs(n.x), abs(n.y)), abs(n.z));
    if (!(largest > real(0.0)))
        return rvec3(real(0.0));
    const real scale = agaa_divisionScale(largest);
    const rvec3 scaled = n * scale * (real(1.0) / max(largest * scale, real(1e-37)));
    return scaled * (real(1.0) / sqrt(max(dot(scaled, scaled), real(1e-12))));
}
#endif
