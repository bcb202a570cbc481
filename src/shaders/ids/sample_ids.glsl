// The primitive ids of samples. The prepass wrote them, or with AGAA_EXPANDED passes that expand triangles. Needs
// AGAA_BINDING_IDS.
#ifndef AGAA_SAMPLE_IDS_GLSL
#define AGAA_SAMPLE_IDS_GLSL
#ifndef AGAA_BINDING_IDS
#error "sample_ids.glsl needs AGAA_BINDING_IDS."
#endif
#ifndef AGAA_EXPANDED
#define AGAA_EXPANDED 0
#endif
#include "common/target.glsl"
#include "ids/id_values.glsl"

#if AGAA_EXPANDED
#include "ids/visible_samples.glsl"
uint agaa_idOf(uvec2 pixel, uint i) { return agaa_visibleId(pixel, i); }
#else
// An id is four bytes, each of which is exact in an 8-bit channel on every device at every sample count.
layout(AGAA_BINDING_IDS) uniform AGAA_TARGET_TEXTURE agaa_ids;

// Returns 0 where there is no geometry.
uint agaa_idOf(uvec2 pixel, uint i) {
    uvec4 bytes = uvec4(AGAA_FETCH(agaa_ids, pixel, i) * 255.0 + 0.5);
    return bytes.x | bytes.y << 8 | bytes.z << 16 | bytes.w << 24;
}
#endif

// Returns false for draws that a G-buffer holds instead (AGAA_FETCH_NOT_ALL_DRAWS).
bool agaa_isFetched(uint id) {
#ifdef AGAA_SOME_UNFETCHED
    return id != AGAA_UNFETCHED_ID;
#else
    return true;
#endif
}
#endif
