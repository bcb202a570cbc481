// Compute programs from GLSL.
#pragma once

#include "core/plan.h"

#include <glad/gl.h>

#include <string>

namespace agaa::gl {

// Throws AGAA_ERROR_INTERNAL, or what is given for texts that hold the host's code, with the compiler's first
// message.
GLuint compileCompute(const GladGLContext& gl, const std::string& text, const std::string& name,
                      AgaaResult blame = AGAA_ERROR_INTERNAL);
GLuint compilePass(const GladGLContext& gl, const Pass& pass);

} // namespace agaa::gl
