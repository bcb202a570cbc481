// Flags of AgaaAdaptiveSampling.
#ifndef AGAA_ADAPTIVE_FLAGS_GLSL
#define AGAA_ADAPTIVE_FLAGS_GLSL
#include "common/api_values.glsl"

bool agaa_isAdaptive(uint flag) { return (AGAA_ADAPTIVE_FLAGS & flag) != 0u; }
#endif
