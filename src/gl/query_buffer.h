// The results of queries go to a buffer that the host has bound, if it has, and not to the pointer
// given.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

inline bool hasQueryBuffer(const GladGLContext& gl) {
    return gl.VERSION_4_4 || gl.ARB_query_buffer_object;
}

// While it lives, no buffer takes the results of queries.
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
