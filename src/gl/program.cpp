#include "gl/program.h"

#include "core/error.h"
#include "core/glsl_text.h"

#include <vector>

namespace agaa::gl {

namespace {

// As the end of a sentence.
std::string firstLine(const std::string& log) {
    std::string line = log.substr(0, log.find('\n'));
    return line.ends_with('.') ? line : line + '.';
}

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

static void attachStage(const GladGLContext& gl, GLuint program, const StageText& stage,
                        const std::string& name, AgaaResult blame) {
    const GLuint shader = gl.CreateShader(stage.stage);
    gl.ShaderSource(shader, 1, &stage.text, nullptr);
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    const std::string log = done ? "" : firstLine(shaderLog(gl, shader));
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader); // with the program
    if (!done)
        fail(blame, format("%s does not compile: %s", name.c_str(), log.c_str()));
}

GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages,
                   const std::string& name, AgaaResult blame) {
    const GLuint program = gl.CreateProgram();
    try {
        for (const StageText& stage : stages)
            attachStage(gl, program, stage, name, blame);
        gl.LinkProgram(program);
        GLint done = GL_FALSE;
        gl.GetProgramiv(program, GL_LINK_STATUS, &done);
        if (!done)
            fail(blame, format("%s does not link: %s", name.c_str(),
                               firstLine(programLog(gl, program)).c_str()));
    } catch (...) {
        gl.DeleteProgram(program);
        throw;
    }
    return program;
}

GLuint compilePass(const GladGLContext& gl, const Pass& pass) {
    const std::string text = passGlslForOpenGl(pass, gl.VERSION_4_5 ? 450 : 430);
    const StageText stage{GL_COMPUTE_SHADER, text.c_str()};
    return pass.hostCode.empty()
               ? linkProgram(gl, {stage}, "the pass " + pass.name)
               : linkProgram(gl, {stage}, pass.hostCodeOrigin, AGAA_ERROR_INVALID_ARGUMENT);
}

} // namespace agaa::gl
