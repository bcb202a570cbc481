// Programs from GLSL.
#pragma once

#include "core/frame/variants.h"

#include <glad/gl.h>

#include <initializer_list>
#include <string>

namespace agaa::gl {

class Context;

struct StageText {
    GLenum stage;
    const char* text;
};
// Throws AGAA_ERROR_INTERNAL, or what is given for texts that hold the host's code, with the compiler's first
// message. isRetrievable: the program's binary will be asked for.
GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages,
                   const std::string& name, AgaaResult blame = AGAA_ERROR_INTERNAL, bool isRetrievable = false);
// A compute pass, from the context's cache where it has the program.
Compiled compilePass(Context& context, const Pass& pass);

} // namespace agaa::gl
