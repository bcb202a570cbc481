// The host's output as passes write and read it: level 0, channels in order.
#pragma once

#include "gl/context.h"

#include <array>

namespace agaa::gl {

// Image stores to a level below the base level do nothing, and a sampler object does not replace a texture's base level
// and swizzle. Sets both, and brings the host's back at the end of the scope. Leaves alone what needs no change:
// textures with bindless handles refuse any.
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
    std::array<GLint, 4> swizzle_{};
};

} // namespace agaa::gl
