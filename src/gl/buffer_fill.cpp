#include "gl/buffer_fill.h"

#include "gl/bindings.h"
#include "gl/program.h"

#include <algorithm>

namespace agaa::gl {

namespace {

constexpr uint64_t lanes = 256;
constexpr uint64_t maxGroups = 65535; // the least limit of an OpenGL context

// The binding is set for each fill. A group fills 256 neighbouring words at a time.
const char* const text = R"(#version 430
layout(local_size_x = 256) in;
layout(std430) writeonly buffer Block { uint words[]; } block;
layout(location = 0) uniform uint value;
void main() {
    uint count = uint(block.words.length());
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * 256u)
        block.words[i] = value;
}
)";

// Accesses of frames after a fill: shaders, copies and uploads, dispatch arguments, constants and texel buffers.
constexpr GLbitfield laterAccesses = GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                     GL_BUFFER_UPDATE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                                     GL_TEXTURE_FETCH_BARRIER_BIT;

} // namespace

BufferFill::BufferFill(const GladGLContext& gl, bool byShader) : gl_(gl) {
    if (!byShader)
        return;
    program_ = linkProgram(gl, {{GL_COMPUTE_SHADER, text}}, "the shader that fills buffers");
    gl.ShaderStorageBlockBinding(program_, 0, bindingPointOf(slot::Aggregates));
    gl.ObjectLabel(GL_PROGRAM, program_, -1, "agaa fill");
}

BufferFill::~BufferFill() {
    if (program_)
        gl_.DeleteProgram(program_);
}

void BufferFill::fill(GLuint buffer, uint64_t bytes, uint32_t value) const {
    if (program_)
        fillByShader(buffer, bytes, value);
    else if (value == 0)
        // glClearNamedBufferData would read a value through the host's pixel unpacking state. Without a value it
        // writes 0.
        gl_.ClearNamedBufferSubData(buffer, GL_R32UI, 0, GLsizeiptr(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    else {
        gl_.NamedBufferSubData(buffer, 0, sizeof value, &value);
        for (uint64_t done = sizeof value; done < bytes; done *= 2)
            gl_.CopyNamedBufferSubData(buffer, buffer, 0, GLintptr(done), GLsizeiptr(std::min(done, bytes - done)));
    }
}

void BufferFill::fillByShader(GLuint buffer, uint64_t bytes, uint32_t value) const {
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // after loads and stores of earlier shaders
    gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, bindingPointOf(slot::Aggregates), buffer, 0, GLsizeiptr(bytes));
    gl_.UseProgram(program_);
    gl_.ProgramUniform1ui(program_, 0, value);
    const uint64_t words = bytes / sizeof value;
    gl_.DispatchCompute(GLuint(std::min((words + lanes - 1) / lanes, maxGroups)), 1, 1);
    gl_.MemoryBarrier(laterAccesses);
}

} // namespace agaa::gl
