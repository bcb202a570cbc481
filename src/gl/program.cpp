#include "gl/program.h"

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/glsl/glsl_text.h"
#include "gl/context.h"
#include "gl/errors.h"

#include <algorithm>
#include <vector>

namespace agaa::gl {

namespace {

// Returns the first line of a log as the end of a sentence. Names and text of the host are in the log.
std::string firstLine(const std::string& log) {
    const std::string line = printable(log.substr(0, log.find('\n')), 500);
    if (line.empty())
        return "the driver gives no reason.";
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

static void attachStage(const GladGLContext& gl, GLuint program, const StageText& stage, const std::string& name,
                        AgaaResult blame) {
    const GLuint shader = requireObject(gl, gl.CreateShader(stage.stage), "glCreateShader");
    gl.ShaderSource(shader, 1, &stage.text, nullptr);
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    const std::string log = done ? "" : firstLine(shaderLog(gl, shader));
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader); // it is deleted together with the program
    if (!done) {
        checkErrors(gl, (name + " does not compile").c_str());
        fail(blame, format("%s does not compile: %s", name.c_str(), log.c_str()));
    }
}

GLuint linkProgram(const GladGLContext& gl, std::initializer_list<StageText> stages, const std::string& name,
                   AgaaResult blame, GLenum property) {
    const GLuint program = requireObject(gl, gl.CreateProgram(), "glCreateProgram");
    if (property)
        gl.ProgramParameteri(program, property, GL_TRUE);
    try {
        for (const StageText& stage : stages)
            attachStage(gl, program, stage, name, blame);
        gl.LinkProgram(program);
        GLint done = GL_FALSE;
        gl.GetProgramiv(program, GL_LINK_STATUS, &done);
        if (!done) {
            checkErrors(gl, (name + " does not link").c_str());
            fail(blame, format("%s does not link: %s", name.c_str(), firstLine(programLog(gl, program)).c_str()));
        }
    } catch (...) {
        gl.DeleteProgram(program);
        throw;
    }
    return program;
}

void checkFragment(const GladGLContext& gl, const std::string& text, const std::string& name) {
    // Other programs need a vertex shader in compatibility profiles.
    gl.DeleteProgram(
        linkProgram(gl, {{GL_FRAGMENT_SHADER, text.c_str()}}, name, AGAA_ERROR_INVALID_ARGUMENT, GL_PROGRAM_SEPARABLE));
}

// Returns 0 if the driver refuses the binary, for example after an update that did not change its version string.
static GLuint loadBinary(const GladGLContext& gl, const ProgramCache::Binary& binary) {
    const GLuint program = gl.CreateProgram();
    if (program == 0)
        return 0; // the caller's next call fails, too
    gl.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    gl.ProgramBinary(program, binary.format, binary.bytes.data(), GLsizei(binary.bytes.size()));
    GLint done = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &done);
    if (done)
        return program;
    gl.DeleteProgram(program);
    return 0;
}

static void keepBinary(const GladGLContext& gl, GLuint program, const ProgramCache::Key& key, ProgramCache& cache) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0)
        return;
    ProgramCache::Binary binary;
    binary.bytes.resize(size_t(length));
    GLsizei written = 0;
    gl.GetProgramBinary(program, length, &written, &binary.format, binary.bytes.data());
    binary.bytes.resize(size_t(written));
    if (written > 0)
        cache.set(key, std::move(binary));
}

Compiled compilePass(Context& context, const Pass& pass) {
    const GladGLContext& gl = context.gl;
    const std::string text = passGlslForOpenGl(pass, gl.VERSION_4_5 ? 450 : 430);
    const ProgramCache::Key key = ProgramCache::keyOf(text);
    const ProgramCache::Binary* kept = context.keepsPrograms ? context.programs.find(key) : nullptr;
    // glProgramBinary raises an error for formats that the driver does not list.
    if (kept && std::find(context.binaryFormats.begin(), context.binaryFormats.end(), kept->format) !=
                    context.binaryFormats.end())
        if (const GLuint program = loadBinary(gl, *kept))
            return {program, true};
    const StageText stage{GL_COMPUTE_SHADER, text.c_str()};
    const bool isImported = !pass.compute().hostCode.empty();
    const GLuint program =
        linkProgram(gl, {stage}, isImported ? pass.compute().hostCodeOrigin : "the pass " + pass.name,
                    isImported ? AGAA_ERROR_INVALID_ARGUMENT : AGAA_ERROR_DEVICE,
                    context.keepsPrograms ? GL_PROGRAM_BINARY_RETRIEVABLE_HINT : 0);
    if (context.keepsPrograms)
        keepBinary(gl, program, key, context.programs);
    return {program, false};
}

} // namespace agaa::gl
