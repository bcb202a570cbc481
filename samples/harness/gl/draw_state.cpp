#include "gl/draw_state.h"

#include <stdexcept>

namespace harness::gl {

static GLenum compareFunction(uint32_t compare) {
    switch (compare) {
    case AGAA_COMPARE_LESS:
        return GL_LESS;
    case AGAA_COMPARE_GREATER:
        return GL_GREATER;
    case AGAA_COMPARE_EQUAL:
        return GL_EQUAL;
    case AGAA_COMPARE_ALWAYS:
        return GL_ALWAYS;
    }
    throw std::runtime_error("The SDK asks for an unknown depth comparison.");
}

void setTarget(const GladGLContext& gl, uint32_t width, uint32_t height) {
    gl.Viewport(0, 0, GLsizei(width), GLsizei(height));
    for (GLenum capability : {GL_SCISSOR_TEST, GL_BLEND, GL_DITHER, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_MASK,
                              GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD, GL_DEPTH_CLAMP})
        gl.Disable(capability);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.DepthRange(0, 1);
    gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); // the convention of Vulkan
}

void setViewports(const GladGLContext& gl, std::span<const AgaaViewport> list) {
    for (GLuint i = 0; i < list.size(); ++i) {
        const AgaaViewport& v = list[i];
        gl.ViewportIndexedf(i, v.x, v.y, v.width, v.height);
        gl.ScissorIndexed(i, GLint(v.scissorX), GLint(v.scissorY), GLsizei(v.scissorWidth), GLsizei(v.scissorHeight));
        gl.Enablei(GL_SCISSOR_TEST, i);
    }
}

void setDrawState(const GladGLContext& gl, const AgaaDrawState& state) {
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(compareFunction(state.depthCompare));
    gl.DepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    const auto writes = [&](uint32_t bit) -> GLboolean { return state.colorWriteMask & bit ? GL_TRUE : GL_FALSE; };
    gl.ColorMask(writes(1), writes(2), writes(4), writes(8));
    (state.keepFirst || state.additive ? gl.Enable : gl.Disable)(GL_BLEND);
    gl.BlendFunc(state.additive ? GL_ONE : GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    if (state.colorSamples) {
        gl.Disable(GL_RASTER_MULTISAMPLE_EXT);
        gl.CoverageModulationNV(GL_NONE);
    }
    gl.BlendEquation(GL_FUNC_ADD);
    (state.sampleShading ? gl.Enable : gl.Disable)(GL_SAMPLE_SHADING);
    gl.MinSampleShading(1);
    constexpr GLenum conservativeRasterization = 0x9346; // GL_NV_conservative_raster
    if (state.conservative)
        gl.Enable(conservativeRasterization);
}

void setStencilTest(const GladGLContext& gl, bool on) {
    (on ? gl.Enable : gl.Disable)(GL_STENCIL_TEST);
    gl.StencilFunc(GL_EQUAL, 0, 0xFF);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    gl.StencilMask(0xFF);
}

} // namespace harness::gl
