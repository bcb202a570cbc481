// Compiles programs from GLSL.
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
// Throws `blame` with the compiler's first message. blame: AGAA_ERROR_INTERNAL unless the text contains code of the
// host. isRetrievable: the binary of the program will be read.
GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages, const std::string& name,
                   AgaaResult blame = AGAA_ERROR_INTERNAL, bool isRetrievable = false);
// Compiles a compute pass, or loads its program from the context's cache.
Compiled compilePass(Context& context, const Pass& pass);

} // namespace agaa::gl
