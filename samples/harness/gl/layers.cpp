#include "gl/layers.h"

#include "embedded.h"
#include "gl/draw_state.h"

namespace harness::gl {

static const std::string head = "#version 430\n#define AT(n) binding = n\n#define VERTEX gl_VertexID\n"
                                "#define INSTANCE gl_InstanceID\n";

Layers::Layers(const GladGLContext& gl)
    : gl_(gl), program_(gl, layerText(head, embedded::layers_vert), layerText(head, embedded::layers_frag), "layers"),
      constants_(createBuffer(gl)), vertices_(createVertexArray(gl)), target_(createFramebuffer(gl)) {
    gl.NamedBufferData(constants_.get(), sizeof(LayerConstants), nullptr, GL_DYNAMIC_DRAW);
}

void Layers::draw(const LayerConstants& constants, const Texture& image, const Texture& meanDepth,
                  const Texture& coverage, uint32_t width, uint32_t height) {
    gl_.NamedBufferSubData(constants_.get(), 0, sizeof constants, &constants);
    gl_.NamedFramebufferTexture(target_.get(), GL_COLOR_ATTACHMENT0, image.get(), 0);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.get());
    setTarget(gl_, width, height);
    gl_.Disable(GL_DEPTH_TEST); // the fragment shader reads the resolved depth
    gl_.Disable(GL_STENCIL_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.UseProgram(program_.get());
    gl_.BindVertexArray(vertices_.get());
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, 0, constants_.get());
    gl_.BindTextureUnit(1, meanDepth.get());
    gl_.BindTextureUnit(2, coverage.get());
    gl_.BindSampler(1, 0);
    gl_.BindSampler(2, 0);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(layerQuadCount));
    gl_.Disable(GL_BLEND);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
}

} // namespace harness::gl
