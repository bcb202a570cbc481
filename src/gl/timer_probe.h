// Whether a driver's timestamps tell the time that its work takes.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

// Draws: changes programs, bindings, viewport and tests, which the caller keeps. False as well where there are no
// timestamps, or the probe does not compile.
bool probeTimer(const GladGLContext& gl, uint32_t bits);

} // namespace agaa::gl
