/* State of a draw pass, for the OpenGL hosts with a draw callback.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "gl.h"

static void enable(GLenum capability, uint32_t isEnabled) {
    if (isEnabled)
        glEnable(capability);
    else
        glDisable(capability);
}

/* Sets the state that a draw pass requires. */
static void setState(const AgaaDrawState* state) {
    static const GLenum compareOps[] = {GL_LESS, GL_GREATER, GL_EQUAL, GL_ALWAYS};
    const uint32_t mask = state->colorWriteMask;
    enable(GL_DEPTH_TEST, 1);
    glDepthFunc(compareOps[state->depthCompare]);
    glDepthMask((GLboolean)state->depthWrite);
    enable(GL_STENCIL_TEST, state->stencilTest);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glStencilMask(0xFF);
    glColorMask((mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0);
    enable(GL_SAMPLE_SHADING, state->sampleShading);
    glMinSampleShading(1.0f);
    enable(GL_MULTISAMPLE, 1);
    enable(GL_BLEND, state->keepFirst);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    enable(GL_DITHER, 0);
    enable(GL_SCISSOR_TEST, 0);
    enable(GL_CULL_FACE, 0); /* the host chooses culling, which must be the same in every pass */
}
