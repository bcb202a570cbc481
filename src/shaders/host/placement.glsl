// Checks whether fragments are at the positions that the frame's camera projects them to. With a projection that
// differs from the rasteriser's, shading would use other positions, which no other counter shows. Needs AGAA_COUNTING
// and AGAA_FIRST_PASS.
#if !defined(AGAA_COUNTING) || !defined(AGAA_FIRST_PASS)
#error "placement.glsl needs AGAA_COUNTING and AGAA_FIRST_PASS."
#endif
#include "math/placement.glsl"

bool agaa_isMisplaced(vec3 position) {
    uint orthographic = agaa_frame.isOrthographic;
    vec3 p = mat3(agaa_frame.view) * position;
    vec2 ndc = orthographic != 0u ? p.xy * agaa_frame.projectionScale + agaa_frame.projectionOffset
                                  : -p.xy * agaa_frame.projectionScale / p.z - agaa_frame.projectionOffset;
    vec2 target = vec2(agaa_frame.size * uvec2(AGAA_SCALE_X, AGAA_SCALE_Y));
    vec2 away = abs((ndc * 0.5 + 0.5) * target - agaa_shownPoint(gl_FragCoord.xy));
    float z = agaa_viewZFromDepth(gl_FragCoord.z, agaa_frame.projection22, agaa_frame.projection32,
                                  orthographic);
    float quantum = agaa_depthQuantum(z, gl_FragCoord.z, agaa_frame.projection22, agaa_frame.projection32,
                                      orthographic, 5.96e-8);
    return agaa_isElsewhere(away, p.z, z, fwidth(p.z), quantum);
}

void agaa_checkPlacement(vec3 position) {
#if AGAA_COUNTING && AGAA_FIRST_PASS
    if (agaa_isMisplaced(position) && !AGAA_HELPER)
        agaa_countFragment(AGAA_COUNT_MISPLACED, 1u);
#endif
}
