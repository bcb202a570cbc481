// Where a pass's resources are bound. Vulkan numbers them in one space; OpenGL has a space a kind, and
// some of them have eight places (src/gl/bindings.h).
#ifndef AGAA_BINDINGS_GLSL
#define AGAA_BINDINGS_GLSL
#ifdef AGAA_GL
#define AGAA_AT_FRAME binding = 0
#define AGAA_AT_LIGHTS binding = 0
#define AGAA_AT_COUNTERS binding = 1
#define AGAA_AT_AGGREGATES binding = 2
#define AGAA_AT_DEFERRED binding = 3
#define AGAA_AT_METADATA_OUT binding = 0
#define AGAA_AT_OUTPUT binding = 1
#define AGAA_AT_DEPTH binding = 3
#define AGAA_AT_SURFACE0 binding = 4
#define AGAA_AT_SURFACE1 binding = 5
#define AGAA_AT_SURFACE2 binding = 6
#define AGAA_AT_SURFACE3 binding = 7
#define AGAA_AT_METADATA binding = 8
#define AGAA_AT_SHADOW0 binding = 12
#define AGAA_AT_SHADOW1 binding = 13
#define AGAA_AT_SHADOW2 binding = 14
#define AGAA_AT_SHADOW3 binding = 15
#define AGAA_AT_BELOW binding = 16
#else
#define AGAA_AT_FRAME set = 0, binding = 0
#define AGAA_AT_LIGHTS set = 0, binding = 1
#define AGAA_AT_COUNTERS set = 0, binding = 2
#define AGAA_AT_DEPTH set = 0, binding = 3
#define AGAA_AT_SURFACE0 set = 0, binding = 4
#define AGAA_AT_SURFACE1 set = 0, binding = 5
#define AGAA_AT_SURFACE2 set = 0, binding = 6
#define AGAA_AT_SURFACE3 set = 0, binding = 7
#define AGAA_AT_METADATA set = 0, binding = 8
#define AGAA_AT_METADATA_OUT set = 0, binding = 9
#define AGAA_AT_AGGREGATES set = 0, binding = 10
#define AGAA_AT_OUTPUT set = 0, binding = 11
#define AGAA_AT_SHADOW0 set = 0, binding = 12
#define AGAA_AT_SHADOW1 set = 0, binding = 13
#define AGAA_AT_SHADOW2 set = 0, binding = 14
#define AGAA_AT_SHADOW3 set = 0, binding = 15
#define AGAA_AT_BELOW set = 0, binding = 16
#define AGAA_AT_DEFERRED set = 0, binding = 17
#endif
#endif
