#include "view_texture.h"

namespace viewer {

ViewTexture::ViewTexture(const GladGLContext& gl) : gl_(gl) {
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    // Texels are shown as they are.
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

ViewTexture::~ViewTexture() { gl_.DeleteTextures(1, &texture_); }

void ViewTexture::update(uint32_t width, uint32_t height, const std::vector<harness::Pixel>& pixels, uint64_t version) {
    if (version == version_ || pixels.empty())
        return;
    version_ = version;
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, GLsizei(width), GLsizei(height), 0, GL_RGB, GL_UNSIGNED_BYTE,
                   pixels.data());
}

} // namespace viewer
