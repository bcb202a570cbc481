// Draws the layer over the anti-aliased image (render/layers.h).
#pragma once

#include "gl/objects.h"
#include "gl/program.h"
#include "render/layers.h"

namespace harness::gl {

class Layers {
public:
    explicit Layers(const GladGLContext& gl);
    // The textures are the image, which receives the layer, and the resolved outputs.
    void draw(const LayerConstants& constants, const Texture& image, const Texture& meanDepth, const Texture& coverage,
              uint32_t width, uint32_t height);

private:
    const GladGLContext& gl_;
    Program program_;
    Buffer constants_;
    VertexArray vertices_; // without attributes
    Framebuffer target_;
};

} // namespace harness::gl
