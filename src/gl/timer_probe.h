// Whether a driver's timestamps tell the time that its work takes.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

// Changes the program in use and the first shader storage binding. False as well where there are no timestamps.
bool probeTimer(const GladGLContext& gl);

} // namespace agaa::gl
