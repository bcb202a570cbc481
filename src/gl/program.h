// Programs from GLSL.
#pragma once

#include "core/plan.h"

#include <glad/gl.h>

#include <initializer_list>
#include <string>

namespace agaa::gl {

struct StageText {
    GLenum stage;
    const char* text;
};
// Throws AGAA_ERROR_INTERNAL, or what is given for texts that hold the host's code, with the compiler's first
// message.
GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages,
                   const std::string& name, AgaaResult blame = AGAA_ERROR_INTERNAL);
GLuint compilePass(const GladGLContext& gl, const Pass& pass);

} // namespace agaa::gl
