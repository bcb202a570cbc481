// Where a host's geometry or vertex shader passes the corners of a triangle to its fragment shader: three locations.
#ifndef AGAA_CORNER_LOCATION
#define AGAA_CORNER_LOCATION 13
#endif
// x, y and w in pixels; where fragments carry their materials, z of clip coordinates too, for depths in [0, 1].
#if AGAA_NEEDS_MATERIAL
#define AGAA_CORNER vec4
#else
#define AGAA_CORNER vec3
#endif
// NVIDIA's linker places outputs without a location over those of the host.
#define AGAA_AT_CORNERS layout(location = AGAA_CORNER_LOCATION)
