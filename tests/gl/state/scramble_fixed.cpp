// Scramblers of what is not a binding and not switched by glEnable.
#include "scramblers.h"

namespace agaa::test {
namespace {

constexpr auto compareFunction = [](Values& v) {
    return v.oneOf<GLenum>({GL_NEVER, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL});
};
constexpr auto stencilOperation = [](Values& v) {
    return v.oneOf<GLenum>({GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP});
};
constexpr auto stencilMask = [](Values& v) {
    return v.oneOf<GLuint>({0u, 0x0Fu, 0xF0u, 0x81u, 0x7FFFFFFFu, 0xFFFFFFFFu});
};
constexpr auto factor = [](Values& v) {
    return v.oneOf<GLenum>({GL_ONE, GL_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_COLOR,
                            GL_SRC_ALPHA_SATURATE, GL_SRC1_COLOR});
};
constexpr auto equation = [](Values& v) {
    return v.oneOf<GLenum>({GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX});
};
constexpr auto polygonMode = [](Values& v) { return v.oneOf<GLenum>({GL_POINT, GL_LINE}); };
constexpr auto hint = [](Scrambling& s) {
    s.gl.Hint(s.row.parameters[0], s.values.oneOf<GLenum>({GL_FASTEST, GL_NICEST}));
};
constexpr auto clampColor = [](Scrambling& s) {
    s.gl.ClampColor(s.row.parameters[0], s.values.oneOf<GLenum>({GL_TRUE, GL_FALSE, GL_FIXED_ONLY}));
};
constexpr auto pixelFlag = [](Scrambling& s) { s.gl.PixelStorei(s.row.parameters[0], s.values.boolean()); };
constexpr auto pixelCount = [](Scrambling& s) {
    s.gl.PixelStorei(s.row.parameters[0], s.values.oneOf<GLint>({1, 3, 8, 17, 300}));
};
constexpr auto pixelAlignment = [](Scrambling& s) {
    s.gl.PixelStorei(s.row.parameters[0], s.values.oneOf<GLint>({1, 2, 8}));
};

const Scrambler kFixedFunctions[] = {
    {"GL_VIEWPORT",
     [](Scrambling& s) {
         s.gl.ViewportIndexedf(s.element, s.values.number(-8, 8), s.values.number(-8, 8), s.values.number(1, 33),
                               s.values.number(1, 17));
     }},
    {"GL_DEPTH_RANGE",
     [](Scrambling& s) {
         s.gl.DepthRangeIndexed(s.element, s.values.number(0.125f, 0.5f), s.values.number(0.5f, 0.875f));
     }},
    {"GL_SCISSOR_BOX",
     [](Scrambling& s) {
         s.gl.ScissorIndexed(s.element, s.values.oneOf<GLint>({-5, 2, 7}), s.values.oneOf<GLint>({-3, 1, 9}),
                             s.values.oneOf<GLint>({0, 11, 400}), s.values.oneOf<GLint>({13, 21}));
     }},
    {"GL_CLIP_ORIGIN, GL_CLIP_DEPTH_MODE",
     [](Scrambling& s) {
         s.gl.ClipControl(s.values.oneOf<GLenum>({GL_LOWER_LEFT, GL_UPPER_LEFT}),
                          s.values.oneOf<GLenum>({GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE}));
     }},
    {"GL_CULL_FACE_MODE",
     [](Scrambling& s) {
         s.gl.CullFace(s.values.oneOf<GLenum>({GL_FRONT, GL_FRONT_AND_BACK}));
     }},
    {"GL_FRONT_FACE",
     [](Scrambling& s) {
         s.gl.FrontFace(s.values.oneOf<GLenum>({GL_CW, GL_CCW}));
     }},
    {"GL_POLYGON_MODE",
     [](Scrambling& s) {
         if (s.compatibilityProfile) {
             s.gl.PolygonMode(GL_FRONT, polygonMode(s.values));
             s.gl.PolygonMode(GL_BACK, polygonMode(s.values));
         } else {
             s.gl.PolygonMode(GL_FRONT_AND_BACK, polygonMode(s.values));
         }
     }},
    {"GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS, GL_POLYGON_OFFSET_CLAMP",
     [](Scrambling& s) {
         const GLfloat factor = s.values.number(-2, 3), units = s.values.number(5, 9);
         if (s.gl.ARB_polygon_offset_clamp)
             s.gl.PolygonOffsetClamp(factor, units, s.values.number(0.125f, 0.5f));
         else
             s.gl.PolygonOffset(factor, units);
     }},
    {"GL_LINE_WIDTH", // above 1 is an error in forward-compatible contexts
     [](Scrambling& s) { s.gl.LineWidth(s.values.number(0.25f, 0.75f)); }},
    {"GL_POINT_SIZE", [](Scrambling& s) { s.gl.PointSize(s.values.number(2, 6)); }},
    {"GL_POINT_FADE_THRESHOLD_SIZE",
     [](Scrambling& s) { s.gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, s.values.number(2, 6)); }},
    {"GL_POINT_SPRITE_COORD_ORIGIN",
     [](Scrambling& s) {
         s.gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN,
                              static_cast<GLint>(s.values.oneOf<GLenum>({GL_LOWER_LEFT, GL_UPPER_LEFT})));
     }},
    {"GL_PROVOKING_VERTEX",
     [](Scrambling& s) {
         s.gl.ProvokingVertex(s.values.oneOf<GLenum>({GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION}));
     }},
    {"GL_PRIMITIVE_RESTART_INDEX",
     [](Scrambling& s) {
         s.gl.PrimitiveRestartIndex(s.values.oneOf<GLuint>({255u, 65535u, 0xFFFFFFFFu, 7u}));
     }},
    {"GL_PATCH_VERTICES",
     [](Scrambling& s) {
         s.gl.PatchParameteri(GL_PATCH_VERTICES, s.values.oneOf<GLint>({1, 2, 4, 16}));
     }},
    {"GL_PATCH_DEFAULT_INNER_LEVEL",
     [](Scrambling& s) {
         const GLfloat levels[] = {s.values.number(2, 6), s.values.number(2, 6)};
         s.gl.PatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels);
     }},
    {"GL_PATCH_DEFAULT_OUTER_LEVEL",
     [](Scrambling& s) {
         const GLfloat levels[] = {s.values.number(2, 6), s.values.number(2, 6), s.values.number(2, 6),
                                   s.values.number(2, 6)};
         s.gl.PatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
     }},
    {"GL_SAMPLE_COVERAGE_VALUE, GL_SAMPLE_COVERAGE_INVERT",
     [](Scrambling& s) { s.gl.SampleCoverage(s.values.number(0, 0.5f), s.values.boolean()); }},
    {"GL_SAMPLE_MASK_VALUE",
     [](Scrambling& s) {
         s.gl.SampleMaski(s.element, s.values.oneOf<GLuint>({0u, 5u, 0x80000000u, 0x7FFFFFFFu}));
     }},
    {"GL_MIN_SAMPLE_SHADING_VALUE", [](Scrambling& s) { s.gl.MinSampleShading(s.values.number(0.25f, 1)); }},
    {"GL_RASTER_SAMPLES_EXT, GL_RASTER_FIXED_SAMPLE_LOCATIONS_EXT",
     [](Scrambling& s) {
         s.gl.RasterSamplesEXT(s.values.oneOf<GLuint>({2u, 4u, 8u}), s.values.boolean());
     }},
    {"GL_COVERAGE_MODULATION_NV",
     [](Scrambling& s) {
         s.gl.CoverageModulationNV(s.values.oneOf<GLenum>({GL_RGB, GL_RGBA, GL_ALPHA}));
     }},
    {"GL_FRAGMENT_SHADER_DERIVATIVE_HINT", hint},
    {"GL_LINE_SMOOTH_HINT", hint},
    {"GL_POLYGON_SMOOTH_HINT", hint},
    {"GL_SHADE_MODEL",
     [](Scrambling& s) {
         s.gl.ShadeModel(s.values.oneOf<GLenum>({GL_FLAT, GL_SMOOTH}));
     }},

    {"GL_DEPTH_FUNC", [](Scrambling& s) { s.gl.DepthFunc(compareFunction(s.values)); }},
    {"GL_DEPTH_WRITEMASK", [](Scrambling& s) { s.gl.DepthMask(s.values.boolean()); }},
    {"GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK",
     [](Scrambling& s) {
         s.gl.StencilFuncSeparate(GL_FRONT, compareFunction(s.values), s.values.oneOf<GLint>({1, 77, 255}),
                                  stencilMask(s.values));
     }},
    {"GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK",
     [](Scrambling& s) {
         s.gl.StencilFuncSeparate(GL_BACK, compareFunction(s.values), s.values.oneOf<GLint>({2, 78, 254}),
                                  stencilMask(s.values));
     }},
    {"GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS",
     [](Scrambling& s) {
         s.gl.StencilOpSeparate(GL_FRONT, stencilOperation(s.values), stencilOperation(s.values),
                                stencilOperation(s.values));
     }},
    {"GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS",
     [](Scrambling& s) {
         s.gl.StencilOpSeparate(GL_BACK, stencilOperation(s.values), stencilOperation(s.values),
                                stencilOperation(s.values));
     }},
    {"GL_STENCIL_WRITEMASK", [](Scrambling& s) { s.gl.StencilMaskSeparate(GL_FRONT, stencilMask(s.values)); }},
    {"GL_STENCIL_BACK_WRITEMASK", [](Scrambling& s) { s.gl.StencilMaskSeparate(GL_BACK, stencilMask(s.values)); }},
    {"GL_COLOR_WRITEMASK",
     [](Scrambling& s) {
         s.gl.ColorMaski(s.element, s.values.boolean(), s.values.boolean(), s.values.boolean(), s.values.boolean());
     }},
    {"GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA",
     [](Scrambling& s) { s.gl.BlendEquationSeparatei(s.element, equation(s.values), equation(s.values)); }},
    {"GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA",
     [](Scrambling& s) {
         s.gl.BlendFuncSeparatei(s.element, factor(s.values), factor(s.values), factor(s.values), factor(s.values));
     }},
    {"GL_BLEND_COLOR",
     [](Scrambling& s) {
         s.gl.BlendColor(s.values.number(-1, 3), s.values.number(2, 4), s.values.number(0, 1), s.values.number(0, 1));
     }},
    {"GL_LOGIC_OP_MODE",
     [](Scrambling& s) {
         s.gl.LogicOp(s.values.oneOf<GLenum>({GL_XOR, GL_CLEAR, GL_NAND}));
     }},
    {"GL_COLOR_CLEAR_VALUE",
     [](Scrambling& s) {
         s.gl.ClearColor(s.values.number(-1, 3), s.values.number(2, 4), s.values.number(0, 1), s.values.number(0, 1));
     }},
    {"GL_DEPTH_CLEAR_VALUE", [](Scrambling& s) { s.gl.ClearDepth(s.values.number(0, 0.5f)); }},
    {"GL_STENCIL_CLEAR_VALUE",
     [](Scrambling& s) {
         s.gl.ClearStencil(s.values.oneOf<GLint>({1, 99, 255}));
     }},
    {"GL_ALPHA_TEST_FUNC, GL_ALPHA_TEST_REF",
     [](Scrambling& s) { s.gl.AlphaFunc(compareFunction(s.values), s.values.number(0, 2)); }},
    {"GL_CLAMP_FRAGMENT_COLOR", clampColor},
    {"GL_CLAMP_VERTEX_COLOR", clampColor},
    {"GL_CLAMP_READ_COLOR", clampColor},

    {"GL_PACK_SWAP_BYTES", pixelFlag},
    {"GL_PACK_LSB_FIRST", pixelFlag},
    {"GL_PACK_ROW_LENGTH", pixelCount},
    {"GL_PACK_IMAGE_HEIGHT", pixelCount},
    {"GL_PACK_SKIP_ROWS", pixelCount},
    {"GL_PACK_SKIP_PIXELS", pixelCount},
    {"GL_PACK_SKIP_IMAGES", pixelCount},
    {"GL_PACK_ALIGNMENT", pixelAlignment},
    {"GL_PACK_COMPRESSED_BLOCK_WIDTH", pixelCount},
    {"GL_PACK_COMPRESSED_BLOCK_HEIGHT", pixelCount},
    {"GL_PACK_COMPRESSED_BLOCK_DEPTH", pixelCount},
    {"GL_PACK_COMPRESSED_BLOCK_SIZE", pixelCount},
    {"GL_UNPACK_SWAP_BYTES", pixelFlag},
    {"GL_UNPACK_LSB_FIRST", pixelFlag},
    {"GL_UNPACK_ROW_LENGTH", pixelCount},
    {"GL_UNPACK_IMAGE_HEIGHT", pixelCount},
    {"GL_UNPACK_SKIP_ROWS", pixelCount},
    {"GL_UNPACK_SKIP_PIXELS", pixelCount},
    {"GL_UNPACK_SKIP_IMAGES", pixelCount},
    {"GL_UNPACK_ALIGNMENT", pixelAlignment},
    {"GL_UNPACK_COMPRESSED_BLOCK_WIDTH", pixelCount},
    {"GL_UNPACK_COMPRESSED_BLOCK_HEIGHT", pixelCount},
    {"GL_UNPACK_COMPRESSED_BLOCK_DEPTH", pixelCount},
    {"GL_UNPACK_COMPRESSED_BLOCK_SIZE", pixelCount},
    {"GL_MATRIX_MODE",
     [](Scrambling& s) {
         s.gl.MatrixMode(s.values.oneOf<GLenum>({GL_PROJECTION, GL_TEXTURE}));
     }},
};

} // namespace

std::span<const Scrambler> fixedFunctionScramblers() { return kFixedFunctions; }

} // namespace agaa::test
