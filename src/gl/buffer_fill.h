// Fills buffers with a word.
#pragma once

#include <glad/gl.h>

#include <cstdint>

namespace agaa::gl {

class BufferFill {
public:
    // byShader: a compute shader fills, which on GPUs is faster than a clear by the API. Throws AGAA_ERROR_DEVICE if
    // the driver does not compile it.
    BufferFill(const GladGLContext& gl, bool byShader);
    ~BufferFill();
    BufferFill(const BufferFill&) = delete;
    BufferFill& operator=(const BufferFill&) = delete;

    // Fills the first bytes of a buffer, a multiple of 4. The caller issues barriers for stores before the call as for
    // glBufferSubData. The words are visible to later storage and image accesses of shaders, texture fetches, uniform
    // blocks, indirect commands, and updates and copies of buffers. Vertex and index fetches, reads through mapped
    // memory and queries need a barrier of the caller. A shader changes the program and the storage binding of the
    // aggregates, and must not run while textures of the draw framebuffer are bound.
    void fill(GLuint buffer, uint64_t bytes, uint32_t value) const;

private:
    void fillByShader(GLuint buffer, uint64_t bytes, uint32_t value) const;

    const GladGLContext& gl_;
    GLuint program_ = 0; // 0: glClearNamedBufferSubData and copies fill
};

} // namespace agaa::gl
