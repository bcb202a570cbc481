#include "gl/program.h"

#include "core/error.h"
#include "core/glsl_text.h"

#include <vector>

namespace agaa::gl {

namespace {

std::string firstLine(const std::string& log) { return log.substr(0, log.find('\n')); }

std::string shaderLog(const GladGLContext& gl, GLuint shader) {
    GLint length = 0;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(size_t(length) + 1);
    gl.GetShaderInfoLog(shader, length, nullptr, text.data());
    return text.data();
}

std::string programLog(const GladGLContext& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(size_t(length) + 1);
    gl.GetProgramInfoLog(program, length, nullptr, text.data());
    return text.data();
}

} // namespace

GLuint compileCompute(const GladGLContext& gl, const std::string& text, const std::string& name,
                      AgaaResult blame) {
    const char* source = text.c_str();
    const GLuint shader = gl.CreateShader(GL_COMPUTE_SHADER);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) {
        const std::string log = shaderLog(gl, shader);
        gl.DeleteShader(shader);
        fail(blame, format("%s does not compile: %s", name.c_str(), firstLine(log).c_str()));
    }
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    gl.DeleteShader(shader);
    gl.GetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        const std::string log = programLog(gl, program);
        gl.DeleteProgram(program);
        fail(blame, format("%s does not link: %s", name.c_str(), firstLine(log).c_str()));
    }
    return program;
}

GLuint compilePass(const GladGLContext& gl, const Pass& pass) {
    const std::string text = passGlslForOpenGl(pass, gl.VERSION_4_5 ? 450 : 430);
    return pass.hostCode.empty()
               ? compileCompute(gl, text, "the pass " + pass.name)
               : compileCompute(gl, text, "AgaaShadowFunction::glsl", AGAA_ERROR_INVALID_ARGUMENT);
}

} // namespace agaa::gl
