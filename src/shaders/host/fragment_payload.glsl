// The payload of a fragment: geometry and material (coverage/material_payload.glsl). Needs AGAA_NEEDS_MATERIAL = 1.
#if !AGAA_NEEDS_MATERIAL
#error "fragment_payload.glsl needs AGAA_NEEDS_MATERIAL."
#endif
#include "host/fragment_depth.glsl"
#include "coverage/material_payload.glsl"
#include "common/curvature.glsl"
#include "math/stored_plane.glsl"
#include "aggregate/packing.glsl"
#include "coverage/surface_spread.glsl"

uint agaa_payload[AGAA_MATERIAL_PAYLOAD_WORDS]; // by agaa_packFragment()
uint agaa_wasSanitised = 0u;

// Fills agaa_payload, and sets agaa_wasSanitised if a member of s was not finite or out of range. Returns false for a
// triangle at the far plane, which is background. plane: agaa_cornerPlane().
bool agaa_packFragment(AgaaSurfaceInput s, uvec4 mask, agaa_DepthPlane plane) {
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE) | agaa_sanitiseNormalChange(s.normalDx, s.normalDy);
    agaa_wasSanitised = bad;
    if (AGAA_SPREAD_WORDS == 0u)
        s.alpha2 = agaa_widenedByCurvature(s.alpha2, s.normalDx, s.normalDy, mask);
    agaa_packSurface(agaa_storedInput(s));
    agaa_DepthPlane growing = agaa_growingDepth(plane);
    agaa_StoredPlane stored = agaa_storePlane(vec3(growing.depth, growing.slope), agaa_depthsOfRange(growing.range),
                                              agaa_coverageMiddle(mask, AGAA_SAMPLES));
    agaa_payload[0] = floatBitsToUint(stored.depth);
    agaa_payload[1] = stored.slopes;
    agaa_payload[2] = agaa_packNormal(s.normal);
#if AGAA_SPREAD_WORDS
    vec3 normal = agaa_unpackNormal(agaa_payload[2]);
    uvec2 spread = agaa_packSpread(agaa_spreadOfFragment(normal, s.normalDx, s.normalDy, mask));
    agaa_payload[AGAA_PLANE_WORDS] = spread.x;
    agaa_payload[AGAA_PLANE_WORDS + 1u] = spread.y;
#endif
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_payload[AGAA_PLANE_WORDS + AGAA_SPREAD_WORDS + w] = agaa_packed[w];
    return !agaa_isAtFarDepth(plane);
}
