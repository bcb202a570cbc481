// The pixels of the view as a texture of the window's context.
#pragma once

#include "image/image.h"

#include <glad/gl.h>

namespace viewer {

class ViewTexture {
public:
    explicit ViewTexture(const GladGLContext& gl);
    ~ViewTexture();
    ViewTexture(const ViewTexture&) = delete;
    ViewTexture& operator=(const ViewTexture&) = delete;

    // Uploads pixels of another version than before.
    void update(uint32_t width, uint32_t height, const std::vector<harness::Pixel>& pixels, uint64_t version);
    void* id() const { return reinterpret_cast<void*>(uintptr_t(texture_)); } // ImTextureID

private:
    const GladGLContext& gl_;
    GLuint texture_ = 0;
    uint64_t version_ = 0;
};

} // namespace viewer
