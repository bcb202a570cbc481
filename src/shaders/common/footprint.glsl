// The footprint of a shading event: second moments of the positions of its samples around its position, in shading
// space. It is known where functions of the host or settings read it. Needs common/camera.glsl.
// Source: AGAA (Crassin et al., TVCG 2016) section 3.5.3.
#ifndef AGAA_FOOTPRINT_GLSL
#define AGAA_FOOTPRINT_GLSL
#ifndef AGAA_CAMERA_GLSL
#error "footprint.glsl needs camera.glsl."
#endif
#include "math/second_moments.glsl"
#include "tables/lighting.inc"

#ifndef AGAA_HOST_FOOTPRINTS // mask of the shadows that a function of the host looks up over footprints
#define AGAA_HOST_FOOTPRINTS 0
#endif
#if defined(AGAA_HOST_SHADING) || AGAA_HOST_FOOTPRINTS
#define AGAA_HAS_FOOTPRINT true
#else
#define AGAA_HAS_FOOTPRINT (AGAA_LIGHT_DIRECTIONS != 0u || AGAA_SHADOW_FILTER == AGAA_SHADOW_COVARIANCE)
#endif
agaa_SecondMoments agaa_footprint = agaa_SecondMoments(vec3(0.0), vec3(0.0));

void agaa_beginFootprint() {
    if (AGAA_HAS_FOOTPRINT)
        agaa_footprint = agaa_noSecondMoments();
}

// Components are clamped, so that their squares are finite.
// away   The vector from the event's position, or from any other for agaa_endFootprintAroundMean().
void agaa_addToFootprint(float weight, vec3 away) {
    if (AGAA_HAS_FOOTPRINT)
        agaa_addSecondMoments(agaa_footprint, weight, clamp(away, vec3(-1e15), vec3(1e15)));
}

// Ends sums of positions in view space with the weight 1.
// mean   The mean of the added vectors.
void agaa_endFootprintAroundMean(float count, vec3 mean) {
    if (AGAA_HAS_FOOTPRINT) {
        mat3 view = mat3(agaa_frame.view);
        agaa_footprint =
            agaa_momentsInBasis(agaa_momentsAroundMean(agaa_footprint, count, clamp(mean, vec3(-1e15), vec3(1e15))),
                                view[0], view[1], view[2]);
    }
}

// Returns the moment along the axis of the view, [0, inf).
float agaa_depthVariance() {
    vec3 axis = transpose(mat3(agaa_frame.view))[2];
    return max(agaa_momentAlong(agaa_footprint, axis, axis), 0.0);
}
#endif
