// State of the draw passes on OpenGL.
#pragma once

#include "gl_device.h"

namespace agaa::conformance {

inline void setCapability(GLenum capability, bool isEnabled) {
    if (isEnabled)
        glEnable(capability);
    else
        glDisable(capability);
}

// Sets all state except the stencil test, which differs between materials. `blends` is Mistakes::blends.
inline void setDrawState(const AgaaDrawState& state, bool blends) {
    constexpr GLenum compareOps[] = {GL_LESS, GL_GREATER, GL_EQUAL, GL_ALWAYS};
    const auto writes = [&](uint32_t bit) { return GLboolean((state.colorWriteMask & bit) != 0); };
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(compareOps[state.depthCompare & 3]);
    glDepthMask(state.depthWrite != 0);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glStencilMask(0xFF);
    glColorMask(writes(1), writes(2), writes(4), writes(8));
    setCapability(GL_SAMPLE_SHADING, state.sampleShading != 0);
    glMinSampleShading(1.0f);
    glEnable(GL_MULTISAMPLE);
    setCapability(GL_BLEND, state.keepFirst != 0 || state.additive != 0 || blends);
    glBlendEquation(GL_FUNC_ADD);
    if (blends)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    else
        glBlendFunc(state.additive ? GL_ONE : GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    glDisable(GL_DITHER);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    constexpr GLenum conservativeRasterization = 0x9346; // from GL_NV_conservative_raster
    if (state.conservative)
        glEnable(conservativeRasterization);
}

} // namespace agaa::conformance
