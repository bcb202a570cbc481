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
// A vertex shader that draws three vertices as a triangle over the whole target.
inline constexpr const char* wholeTargetText = R"(#version 430
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

// If OpenGL reports an error, throws its code; otherwise throws `blame` with the compiler's first message. blame: the
// default is for text of the SDK, which conforming drivers compile. property: one of the program that is set to true,
// as GL_PROGRAM_SEPARABLE, or 0.
GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages, const std::string& name,
                   AgaaResult blame = AGAA_ERROR_DEVICE, GLenum property = 0);
// Throws AGAA_ERROR_INVALID_ARGUMENT if this fragment shader does not compile and link.
void checkFragment(const GladGLContext& gl, const std::string& text, const std::string& name);
// Compiles a compute pass, or loads its program from the context's cache.
Compiled compilePass(Context& context, const Pass& pass);

} // namespace agaa::gl
