// The host's output as passes write and read it: level 0, channels in order.
#pragma once

#include "gl/context.h"

#include <array>

namespace agaa::gl {

// Image stores do nothing to a level below the base level, nor, on NVIDIA's driver, to a texture that lacks mip levels which
// its filter wants: glTexImage2D leaves one. A sampler object does not replace a texture's base level and swizzle. Sets what
// lets level 0 be written and read, and brings the host's values back at the end of the scope. Leaves alone what needs no
// change: textures with bindless handles refuse any.
class OutputView {
public:
    OutputView(const GladGLContext& gl, GLuint texture);
    ~OutputView();
    OutputView(const OutputView&) = delete;
    OutputView& operator=(const OutputView&) = delete;

private:
    const GladGLContext& gl_;
    GLuint texture_;
    GLint baseLevel_ = 0;
    GLint maxLevel_ = 0; // 0 in a texture of immutable storage, which lacks no level
    std::array<GLint, 4> swizzle_{};
};

} // namespace agaa::gl
