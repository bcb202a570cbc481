#include "gl_programs.h"

#include "drawing.h"
#include "host_shaders.h"

#include <stdexcept>

namespace agaa::conformance {

namespace {

// GLSL before 4.30 has explicit locations only by extension.
std::string versionLine(uint32_t glslVersion) {
    return "#version " + std::to_string(glslVersion) +
           " core\n"
           "#extension GL_ARB_separate_shader_objects : enable\n"
           "#extension GL_ARB_explicit_uniform_location : enable\n";
}

// Outputs for AGAA_GL_OUTPUTS_HOST, which receive agaa_out0 … after agaa_emit().
std::string outputsText(uint32_t count, bool isDeclaration) {
    std::string text;
    for (uint32_t i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        text += isDeclaration ? "layout(location = " + n + ") out vec4 hostOut" + n + ";\n"
                              : "    hostOut" + n + " = agaa_out" + n + ";\n";
    }
    return text;
}

std::string fragmentText(const AgaaDrawPass& pass, const ShaderDialect& dialect, bool isMasked) {
    const std::string text = versionLine(dialect.glslVersion) + pass.glslExtensions +
                             (isMasked ? "#define AGAA_ALPHA_MASKED 1\n" : "") + pass.glslDeclarations;
    if (!dialect.declaresOutputs)
        return text + fragmentShader;
    const uint32_t outputs = pass.state.colorAttachmentCount;
    std::string code = fragmentShader;
    code.insert(code.rfind('}'), outputsText(outputs, false));
    return text + outputsText(outputs, true) + code;
}

void attach(GLuint program, GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* const pieces[] = {text.c_str()};
    glShaderSource(shader, 1, pieces, nullptr);
    glCompileShader(shader);
    GLint isCompiled = 0;
    char message[2048] = "";
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    glGetShaderInfoLog(shader, sizeof message, nullptr, message);
    glAttachShader(program, shader);
    glDeleteShader(shader); // the program keeps the shader
    if (!isCompiled)
        throw std::runtime_error(std::string("a shader of the suite's host does not compile: ") + message);
}

// Returns an empty text for passes that need none.
std::string geometryText(const AgaaDrawPass& pass, const ShaderDialect& dialect) {
    return pass.glslGeometry
               ? versionLine(dialect.glslVersion) + pass.glslExtensions + pass.glslGeometry + geometryShader
               : "";
}

std::string vertexText(const AgaaDrawPass& pass, const ShaderDialect& dialect) {
    const std::string version = versionLine(dialect.glslVersion);
    if (!pass.glslVertex)
        return version + "#define ON_OPENGL\n" + vertexShader;
    const std::string own = version + pass.glslExtensions + "#define ON_OPENGL\n" + pass.glslVertex;
    return pass.state.multicast ? own + "#define MULTICAST\n" + vertexShader : own + pullingShader;
}

GLuint createProgram(const std::string& vertices, const std::string& geometry, const std::string& fragments) {
    const GLuint program = glCreateProgram();
    try {
        attach(program, GL_VERTEX_SHADER, vertices);
        if (!geometry.empty())
            attach(program, GL_GEOMETRY_SHADER, geometry);
        attach(program, GL_FRAGMENT_SHADER, fragments);
        glLinkProgram(program);
        GLint isLinked = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
        char message[2048] = "";
        glGetProgramInfoLog(program, sizeof message, nullptr, message);
        if (!isLinked)
            throw std::runtime_error(std::string("a program of the suite's host does not link: ") + message);
    } catch (...) {
        glDeleteProgram(program);
        throw;
    }
    return program;
}

} // namespace

OpenGlPrograms::~OpenGlPrograms() {
    for (const auto& [key, program] : programs_)
        destroy(program);
}

void OpenGlPrograms::destroy(const OpenGlProgram& program) {
    glDeleteProgram(program.opaque);
    glDeleteProgram(program.masked);
}

OpenGlPrograms::Key OpenGlPrograms::keyOf(AgaaView view, uint64_t pipelineKey, uint32_t pass) const {
    return mistakes_.keysByPass ? Key(nullptr, pass) : Key(view, pipelineKey);
}

void OpenGlPrograms::prepare(const Functions& sdk, AgaaView view, const ShaderDialect& dialect) {
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    const AgaaGlDrawPass initialNative = AGAA_GL_DRAW_PASS_INIT;
    const DrawPasses<AgaaGlDrawPass> list(sdk, view, initial, initialNative);
    views_.insert(view);
    for (size_t i = 0; i < list.passes.size(); ++i) {
        const AgaaDrawPass& pass = list.passes[i];
        const Key key = keyOf(view, pass.pipelineKey, pass.pass);
        if (programs_.count(key))
            continue;
        OpenGlProgram& program = programs_[key]; // stored first, so that it is destroyed if the second program fails
        const std::string geometry = geometryText(pass, dialect), vertices = vertexText(pass, dialect);
        program.opaque = createProgram(vertices, geometry, fragmentText(pass, dialect, false));
        program.masked = createProgram(vertices, geometry, fragmentText(pass, dialect, true));
    }
}

void OpenGlPrograms::forget(AgaaView view) {
    views_.erase(view);
    for (auto i = programs_.begin(); i != programs_.end();) {
        const AgaaView owner = i->first.first;
        if (owner == view || (!owner && views_.empty())) {
            destroy(i->second);
            i = programs_.erase(i);
        } else
            ++i;
    }
}

const OpenGlProgram* OpenGlPrograms::find(AgaaView view, uint64_t pipelineKey, uint32_t pass) const {
    const auto found = programs_.find(keyOf(view, pipelineKey, pass));
    return found == programs_.end() ? nullptr : &found->second;
}

} // namespace agaa::conformance
