// The OpenGL state of the SDK's and the engine's draw passes.
#pragma once

#include "agaa_gl.h"

#include <glad/gl.h>

#include <span>

namespace harness::gl {

// Sets the viewport to the whole target and disables all state that could discard or blend fragments.
void setTarget(const GladGLContext& gl, uint32_t width, uint32_t height);

// Sets the first viewports and scissors of a draw pass.
void setViewports(const GladGLContext& gl, std::span<const AgaaViewport> list);
// Sets all of AgaaDrawState except the stencil test, which may differ for masked materials.
void setDrawState(const GladGLContext& gl, const AgaaDrawState& state);
void setStencilTest(const GladGLContext& gl, bool on);

} // namespace harness::gl
