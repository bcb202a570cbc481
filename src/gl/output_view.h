// Texture parameters of the host's output while a pass uses it: level 0, channels in order.
#pragma once

#include "gl/context.h"

#include <array>

namespace agaa::gl {

// Lets passes write and read level 0 of the output. The destructor restores the host's values of these parameters:
//
// * The base level becomes 0: image stores to a level below it do nothing, and a sampler object does not override it.
// * The last level becomes 0 if the texture lacks mip levels that its filter needs, as after glTexImage2D: an image
//   unit with an incomplete texture is invalid, and stores to it do nothing.
// * The swizzle becomes the identity: a sampler object does not override it.
//
// Parameters that have the needed value are not set: textures with bindless handles refuse any change.
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
    GLint maxLevel_ = 0; // 0: the texture has all levels that its filter needs
    std::array<GLint, 4> swizzle_{};
};

} // namespace agaa::gl
