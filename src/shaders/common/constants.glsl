// Specialisation constants of all compute passes. Texts of hosts have macros of the same names instead, so includes
// that both use check for this file or for the macros.
#ifndef AGAA_CONSTANTS_GLSL
#define AGAA_CONSTANTS_GLSL
#define AGAA_CONSTANT(id, name, value) layout(constant_id = id) const uint name = value;
#include "tables/constants.inc"
#undef AGAA_CONSTANT
#endif
