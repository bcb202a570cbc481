// The state that the SDK's draw passes and the engine's own ask for.
#pragma once

#include "agaa_gl.h"

#include <glad/gl.h>

namespace harness::gl {

// Viewport of the whole target; everything off that could take fragments away or mix them.
void setTarget(const GladGLContext& gl, uint32_t width, uint32_t height);
// Everything in AgaaDrawState but the stencil test, which masked materials may have otherwise.
void setDrawState(const GladGLContext& gl, const AgaaDrawState& state);
void setStencilTest(const GladGLContext& gl, bool on);

} // namespace harness::gl
