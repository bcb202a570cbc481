// Objects as a host engine has them: a few of each kind, to be bound and deleted.
#pragma once

#include <glad/gl.h>

#include <array>
#include <cstddef>

namespace agaa::test {

class HostObjects {
public:
    static constexpr size_t kCount = 3;
    using Names = std::array<GLuint, kCount>;
    static constexpr GLsizeiptr kBufferBytes = 65536;
    static constexpr GLint kLevels = 4, kLayers = 4;

    explicit HostObjects(const GladGLContext& gl);
    ~HostObjects();
    HostObjects(const HostObjects&) = delete;
    HostObjects& operator=(const HostObjects&) = delete;
    void deleteAll();

    Names buffers{};        // of kBufferBytes
    Names textures{};       // TEXTURE_2D, RGBA8, kLevels
    Names multisampled{};   // TEXTURE_2D_MULTISAMPLE
    Names arrays{};         // TEXTURE_2D_ARRAY, RGBA8, kLevels, kLayers
    Names bufferTextures{}; // TEXTURE_BUFFER
    Names samplers{};
    Names renderbuffers{};
    Names framebuffers{}; // the last with a stencil
    Names vertexArrays{};
    Names programs{};
    Names pipelines{}; // of separable programs

private:
    const GladGLContext& gl_;
    Names stages_{};
};

} // namespace agaa::test
