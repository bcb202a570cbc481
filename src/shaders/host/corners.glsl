// The corners of a triangle, which a host's geometry or vertex shader passes to its fragment shader in three locations.
#ifndef AGAA_CORNER_LOCATION
#define AGAA_CORNER_LOCATION 13
#endif
// A corner has x, y and w in pixels, and z of clip coordinates, for depths in [0, 1].
#define AGAA_CORNER vec4
// The location is explicit, because NVIDIA's linker assigns outputs without one to locations of the host.
#define AGAA_AT_CORNERS layout(location = AGAA_CORNER_LOCATION)
