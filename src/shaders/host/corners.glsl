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
// Older GLSL has no expressions there and matches by name.
#if __VERSION__ >= 440
#define AGAA_CORNER_AT(n) layout(location = AGAA_CORNER_LOCATION + n)
#else
#define AGAA_CORNER_AT(n)
#endif
