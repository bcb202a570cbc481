#include "gl/output_view.h"

namespace agaa::gl {

static constexpr std::array<GLint, 4> inOrder = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};

// Returns whether the filter may need mip levels that the storage lacks. Immutable storage has all its levels.
static bool mayLackLevels(const GladGLContext& gl, GLuint texture) {
    GLint isImmutable = GL_FALSE, filter = GL_NEAREST;
    gl.GetTextureParameteriv(texture, GL_TEXTURE_IMMUTABLE_FORMAT, &isImmutable);
    gl.GetTextureParameteriv(texture, GL_TEXTURE_MIN_FILTER, &filter);
    return !isImmutable && filter != GL_NEAREST && filter != GL_LINEAR;
}

OutputView::OutputView(const GladGLContext& gl, GLuint texture) : gl_(gl), texture_(texture) {
    if (mayLackLevels(gl, texture))
        gl.GetTextureParameteriv(texture, GL_TEXTURE_MAX_LEVEL, &maxLevel_);
    gl.GetTextureParameteriv(texture, GL_TEXTURE_BASE_LEVEL, &baseLevel_);
    gl.GetTextureParameteriv(texture, GL_TEXTURE_SWIZZLE_RGBA, swizzle_.data());
    if (baseLevel_ != 0)
        gl.TextureParameteri(texture, GL_TEXTURE_BASE_LEVEL, 0);
    if (maxLevel_ != 0)
        gl.TextureParameteri(texture, GL_TEXTURE_MAX_LEVEL, 0);
    if (swizzle_ != inOrder)
        gl.TextureParameteriv(texture, GL_TEXTURE_SWIZZLE_RGBA, inOrder.data());
}

OutputView::~OutputView() {
    if (baseLevel_ != 0)
        gl_.TextureParameteri(texture_, GL_TEXTURE_BASE_LEVEL, baseLevel_);
    if (maxLevel_ != 0)
        gl_.TextureParameteri(texture_, GL_TEXTURE_MAX_LEVEL, maxLevel_);
    if (swizzle_ != inOrder)
        gl_.TextureParameteriv(texture_, GL_TEXTURE_SWIZZLE_RGBA, swizzle_.data());
}

} // namespace agaa::gl
