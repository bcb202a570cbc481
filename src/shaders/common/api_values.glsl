// Values of the public headers.
#ifndef AGAA_API_VALUES_GLSL
#define AGAA_API_VALUES_GLSL
#define AGAA_API_VALUE(name, value) const uint name = value;
#include "tables/api_values.inc"
#undef AGAA_API_VALUE
#endif
