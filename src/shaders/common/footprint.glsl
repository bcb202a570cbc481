// The footprint of a shading event for functions of the host: second moments of the positions of its samples around its
// position, in shading space. Passes without such functions have none. Needs common/camera.glsl.
// Source: AGAA (Crassin et al., TVCG 2016) section 3.5.3.
#ifndef AGAA_FOOTPRINT_GLSL
#define AGAA_FOOTPRINT_GLSL
#ifndef AGAA_CAMERA_GLSL
#error "footprint.glsl needs camera.glsl."
#endif
#include "math/second_moments.glsl"

#ifdef AGAA_HOST_SHADING
#define AGAA_HAS_FOOTPRINT 1
agaa_SecondMoments agaa_footprint = agaa_noSecondMoments();
#else
#define AGAA_HAS_FOOTPRINT 0
#endif

void agaa_beginFootprint() {
#if AGAA_HAS_FOOTPRINT
    agaa_footprint = agaa_noSecondMoments();
#endif
}

// away   From the event's position, or from any other for agaa_endFootprintAroundMean(). Its square is finite.
void agaa_addToFootprint(float weight, vec3 away) {
#if AGAA_HAS_FOOTPRINT
    agaa_addSecondMoments(agaa_footprint, weight, clamp(away, vec3(-1e15), vec3(1e15)));
#endif
}

// Ends sums of positions in view space with the weight 1.
// mean   Of what was added.
void agaa_endFootprintAroundMean(float count, vec3 mean) {
#if AGAA_HAS_FOOTPRINT
    mat3 view = mat3(agaa_frame.view);
    agaa_footprint = agaa_momentsInBasis(
        agaa_momentsAroundMean(agaa_footprint, count, clamp(mean, vec3(-1e15), vec3(1e15))), view[0], view[1], view[2]);
#endif
}
#endif
