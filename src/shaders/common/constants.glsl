// Specialisation constants of all compute passes.
#ifndef AGAA_CONSTANTS_GLSL
#define AGAA_CONSTANTS_GLSL
#define AGAA_CONSTANT(id, name, value) layout(constant_id = id) const uint name = value;
#include "tables/constants.inc"
#undef AGAA_CONSTANT
#endif
