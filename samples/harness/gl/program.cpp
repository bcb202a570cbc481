#include "gl/program.h"

#include "embedded.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace harness::gl {

namespace {

GLuint compile(const GladGLContext& gl, GLenum stage, const std::string& text, const std::string& name) {
    const GLuint shader = gl.CreateShader(stage);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done)
        return shader;
    GLint length = 0;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(size_t(length) + 1);
    gl.GetShaderInfoLog(shader, length, nullptr, log.data());
    gl.DeleteShader(shader);
    throw std::runtime_error("The shader \"" + name + "\" does not compile:\n" + log.data());
}

} // namespace

Program::Program(const GladGLContext& gl, const std::string& vertex, const std::string& fragment,
                 const std::string& name, const std::string& geometry)
    : gl_(&gl), program_(gl.CreateProgram()) {
    try {
        const auto attach = [&](GLenum stage, const std::string& text) {
            const GLuint shader = compile(gl, stage, text, name);
            gl.AttachShader(program_, shader);
            gl.DeleteShader(shader); // deleted with the program
        };
        attach(GL_VERTEX_SHADER, vertex);
        if (!fragment.empty())
            attach(GL_FRAGMENT_SHADER, fragment);
        if (!geometry.empty())
            attach(GL_GEOMETRY_SHADER, geometry);
        gl.LinkProgram(program_);
        GLint done = GL_FALSE;
        gl.GetProgramiv(program_, GL_LINK_STATUS, &done);
        if (!done) {
            char log[4096] = "";
            gl.GetProgramInfoLog(program_, sizeof log, nullptr, log);
            throw std::runtime_error("The program \"" + name + "\" does not link:\n" + log);
        }
    } catch (...) {
        gl.DeleteProgram(program_);
        throw;
    }
}

Program::~Program() {
    if (program_)
        gl_->DeleteProgram(program_);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), program_(std::exchange(other.program_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(program_, other.program_);
    return *this;
}

GLint Program::uniform(const char* name) const { return gl_->GetUniformLocation(program_, name); }

std::string versionLine(uint32_t glslVersion) { return "#version " + std::to_string(glslVersion) + "\n"; }

std::string vertexText(uint32_t glslVersion, const char* body) {
    return versionLine(glslVersion) +
           (glslVersion < 420 ? "#extension GL_ARB_shading_language_420pack : require\n" : "") +
           (glslVersion < 400 ? "#extension GL_ARB_gpu_shader5 : require\n" : "") + // `precise`
           "#define HARNESS_GL\n" + embedded::interface_glsl + body;
}

} // namespace harness::gl
