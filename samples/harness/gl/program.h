// Programs of the sample engine.
#pragma once

#include <glad/gl.h>

#include <string>

namespace harness::gl {

class Program {
public:
    Program() = default;
    // fragment and geometry may be empty. Throws std::runtime_error with the driver's messages.
    Program(const GladGLContext& gl, const std::string& vertex, const std::string& fragment, const std::string& name,
            const std::string& geometry = {});
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    GLuint get() const { return program_; }
    explicit operator bool() const { return program_ != 0; }
    GLint uniform(const char* name) const;

private:
    const GladGLContext* gl_ = nullptr;
    GLuint program_ = 0;
};

// Returns "#version …" and the definitions that shaders/interface.glsl needs on OpenGL. Vertex stages of old versions
// also need an extension.
std::string versionLine(uint32_t glslVersion);
std::string vertexText(uint32_t glslVersion, const char* body);

} // namespace harness::gl
