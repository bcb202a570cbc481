// The OpenGL state of the SDK's and the engine's draw passes.
#pragma once

#include "agaa_gl.h"

#include <glad/gl.h>

namespace harness::gl {

// Sets the viewport to the whole target and disables all state that could discard or blend fragments.
void setTarget(const GladGLContext& gl, uint32_t width, uint32_t height);
// Sets all of AgaaDrawState except the stencil test, which may differ for masked materials.
void setDrawState(const GladGLContext& gl, const AgaaDrawState& state);
void setStencilTest(const GladGLContext& gl, bool on);

} // namespace harness::gl
