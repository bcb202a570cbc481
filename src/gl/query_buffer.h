// Unbinds the host's query buffer: while one is bound, query results go to that buffer instead of to the CPU.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

inline bool hasQueryBuffer(const GladGLContext& gl) { return gl.VERSION_4_4 || gl.ARB_query_buffer_object; }

// No query buffer is bound during the lifetime of an object. The destructor restores the host's binding.
class NoQueryBuffer {
public:
    explicit NoQueryBuffer(const GladGLContext& gl) : gl_(gl) {
        if (!hasQueryBuffer(gl))
            return;
        gl.GetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer_);
        gl.BindBuffer(GL_QUERY_BUFFER, 0);
    }
    ~NoQueryBuffer() {
        if (buffer_ != 0)
            gl_.BindBuffer(GL_QUERY_BUFFER, GLuint(buffer_));
    }
    NoQueryBuffer(const NoQueryBuffer&) = delete;
    NoQueryBuffer& operator=(const NoQueryBuffer&) = delete;

private:
    const GladGLContext& gl_;
    GLint buffer_ = 0;
};

} // namespace agaa::gl
