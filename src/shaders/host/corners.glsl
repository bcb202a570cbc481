// The corners of a triangle, which a host's geometry or vertex shader passes to its fragment shader in three locations.
// Needs AGAA_NEEDS_MATERIAL.
#ifndef AGAA_NEEDS_MATERIAL
#error "corners.glsl needs AGAA_NEEDS_MATERIAL."
#endif
#ifndef AGAA_CORNER_LOCATION
#define AGAA_CORNER_LOCATION 13
#endif
// A corner has x, y and w in pixels. If fragments have materials, it also has z of clip coordinates, for depths in [0,
// 1].
#if AGAA_NEEDS_MATERIAL
#define AGAA_CORNER vec4
#else
#define AGAA_CORNER vec3
#endif
// The location is explicit, because NVIDIA's linker assigns outputs without one to locations of the host.
#define AGAA_AT_CORNERS layout(location = AGAA_CORNER_LOCATION)
