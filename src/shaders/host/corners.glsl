// Where a host's geometry shader passes the corners of a triangle to its fragment shader: three locations.
#ifndef AGAA_CORNER_LOCATION
#define AGAA_CORNER_LOCATION 13
#endif
