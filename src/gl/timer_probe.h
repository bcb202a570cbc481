// Tests whether a driver's timestamps measure the time of its work.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

// Returns false if the timestamps are wrong or missing, or if the probe does not compile. Throws if the driver creates
// no objects or reports an error. bits: of the timestamp counter. The probe draws: it changes programs, bindings, the
// viewport and tests, which the caller must save.
bool probeTimer(const GladGLContext& gl, uint32_t bits);

} // namespace agaa::gl
