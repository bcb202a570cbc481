// States between fragments and the framebuffer: depth, stencil, blending, masks and clear values.
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

using Gl = GladGLContext;

// glBlendEquationSeparatei refuses the equations of GL_KHR_blend_equation_advanced.
void setBlendEquations(const StateContext& context, const StateRow&, uint32_t element, const StateValue& value) {
    const GLenum rgb = component<GLenum>(value, 0), alpha = component<GLenum>(value, 1);
    if (rgb == alpha)
        context.gl().BlendEquationi(element, rgb);
    else
        context.gl().BlendEquationSeparatei(element, rgb, alpha);
}

void readClampFragmentColor(const StateReading& reading, const StateRow&, uint32_t, StateValue& out) {
    out.setInteger(0, reading.clampFragmentColor());
}

// clang-format off
constexpr StateRow kRows[] = {
    {"GL_DEPTH_FUNC", "depth comparison", {GL_DEPTH_FUNC}, "e", readValues, set<&Gl::DepthFunc>},
    {"GL_DEPTH_WRITEMASK", "writing of depths", {GL_DEPTH_WRITEMASK}, "b", readValues,
     set<&Gl::DepthMask>},
    {"GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK", "stencil comparison, front",
     {GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK}, "eiu", readValues,
     set<&Gl::StencilFuncSeparate, GL_FRONT>},
    {"GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK",
     "stencil comparison, back",
     {GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK}, "eiu", readValues,
     set<&Gl::StencilFuncSeparate, GL_BACK>},
    {"GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS",
     "stencil operations, front",
     {GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS}, "eee", readValues,
     set<&Gl::StencilOpSeparate, GL_FRONT>},
    {"GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS",
     "stencil operations, back",
     {GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS},
     "eee", readValues, set<&Gl::StencilOpSeparate, GL_BACK>},
    {"GL_STENCIL_WRITEMASK", "writing of stencils, front", {GL_STENCIL_WRITEMASK}, "u", readValues,
     set<&Gl::StencilMaskSeparate, GL_FRONT>},
    {"GL_STENCIL_BACK_WRITEMASK", "writing of stencils, back", {GL_STENCIL_BACK_WRITEMASK}, "u",
     readValues, set<&Gl::StencilMaskSeparate, GL_BACK>},

    {"GL_COLOR_WRITEMASK", "writing of colours", {GL_COLOR_WRITEMASK}, "bbbb", readValues,
     setAt<&Gl::ColorMaski>, StateArray::DrawBuffers},
    {"GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA", "blend equations",
     {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA}, "ee", readValues, setBlendEquations,
     StateArray::DrawBuffers},
    {"GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA",
     "blend functions",
     {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA}, "eeee",
     readValues, setAt<&Gl::BlendFuncSeparatei>, StateArray::DrawBuffers},
    {"GL_BLEND_COLOR", "constant colour of blending", {GL_BLEND_COLOR}, "ffff", readValues,
     set<&Gl::BlendColor>},
    {"GL_LOGIC_OP_MODE", "logical operation on colours", {GL_LOGIC_OP_MODE}, "e", readValues,
     set<&Gl::LogicOp>},

    {"GL_COLOR_CLEAR_VALUE", "clear colour", {GL_COLOR_CLEAR_VALUE}, "ffff", readValues,
     set<&Gl::ClearColor>},
    {"GL_DEPTH_CLEAR_VALUE", "clear depth", {GL_DEPTH_CLEAR_VALUE}, "f", readValues,
     set<&Gl::ClearDepth>},
    {"GL_STENCIL_CLEAR_VALUE", "clear stencil", {GL_STENCIL_CLEAR_VALUE}, "i", readValues,
     set<&Gl::ClearStencil>},

    {"GL_ALPHA_TEST_FUNC, GL_ALPHA_TEST_REF", "alpha comparison",
     {GL_ALPHA_TEST_FUNC, GL_ALPHA_TEST_REF}, "ef", readValues, set<&Gl::AlphaFunc>,
     StateArray::Once, StateProfile::Compatibility},
    {"GL_CLAMP_FRAGMENT_COLOR", "clamping of fragment colours", {GL_CLAMP_FRAGMENT_COLOR}, "e",
     readClampFragmentColor, setParameter<&Gl::ClampColor>, StateArray::Once,
     StateProfile::Compatibility},
    {"GL_CLAMP_VERTEX_COLOR", "clamping of vertex colours", {GL_CLAMP_VERTEX_COLOR}, "e",
     readValues, setParameter<&Gl::ClampColor>, StateArray::Once, StateProfile::Compatibility},
};
// clang-format on

} // namespace

std::span<const StateRow> fragmentRows() { return kRows; }

} // namespace agaa::gl
