// The host's output as passes write and read it: level 0, channels in order.
#pragma once

#include "gl/context.h"

#include <array>

namespace agaa::gl {

// Lets passes write and read level 0 of the output, and brings the host's values back at the end of the scope:
//
// * the base level: image stores to a level below it do nothing, and a sampler object does not replace it
// * the last level, where the texture lacks mip levels that its filter wants, as glTexImage2D leaves one: an image unit with an
//   incomplete texture is invalid, and stores to it do nothing
// * the swizzle, which a sampler object does not replace either
//
// Leaves alone what needs no change: textures with bindless handles refuse any.
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
    GLint maxLevel_ = 0; // 0 where no level is lacked
    std::array<GLint, 4> swizzle_{};
};

} // namespace agaa::gl
