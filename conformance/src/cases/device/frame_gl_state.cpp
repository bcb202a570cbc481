#include "frame_gl_state.h"

namespace agaa::conformance {

namespace {

#define NAMED(e)                                                                                                               \
    { e, #e }
struct Named {
    GLenum value;
    const char* name;
};

constexpr Named capabilities[] = {NAMED(GL_DEPTH_TEST),
                                  NAMED(GL_DEPTH_CLAMP),
                                  NAMED(GL_STENCIL_TEST),
                                  NAMED(GL_RASTERIZER_DISCARD),
                                  NAMED(GL_CULL_FACE),
                                  NAMED(GL_POLYGON_OFFSET_FILL),
                                  NAMED(GL_POLYGON_OFFSET_LINE),
                                  NAMED(GL_POLYGON_OFFSET_POINT),
                                  NAMED(GL_POLYGON_SMOOTH),
                                  NAMED(GL_LINE_SMOOTH),
                                  NAMED(GL_PROGRAM_POINT_SIZE),
                                  NAMED(GL_MULTISAMPLE),
                                  NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                  NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                                  NAMED(GL_SAMPLE_COVERAGE),
                                  NAMED(GL_SAMPLE_MASK),
                                  NAMED(GL_SAMPLE_SHADING),
                                  NAMED(GL_COLOR_LOGIC_OP),
                                  NAMED(GL_DITHER),
                                  NAMED(GL_FRAMEBUFFER_SRGB),
                                  NAMED(GL_PRIMITIVE_RESTART),
                                  NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                                  NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS)};

constexpr Named values[] = {NAMED(GL_CLIP_ORIGIN),
                            NAMED(GL_CLIP_DEPTH_MODE),
                            NAMED(GL_CULL_FACE_MODE),
                            NAMED(GL_FRONT_FACE),
                            NAMED(GL_POLYGON_MODE),
                            NAMED(GL_POLYGON_OFFSET_FACTOR),
                            NAMED(GL_POLYGON_OFFSET_UNITS),
                            NAMED(GL_LINE_WIDTH),
                            NAMED(GL_POINT_SIZE),
                            NAMED(GL_PROVOKING_VERTEX),
                            NAMED(GL_PRIMITIVE_RESTART_INDEX),
                            NAMED(GL_PATCH_VERTICES),
                            NAMED(GL_SAMPLE_COVERAGE_VALUE),
                            NAMED(GL_SAMPLE_COVERAGE_INVERT),
                            NAMED(GL_MIN_SAMPLE_SHADING_VALUE),
                            NAMED(GL_DEPTH_FUNC),
                            NAMED(GL_DEPTH_WRITEMASK),
                            NAMED(GL_STENCIL_FUNC),
                            NAMED(GL_STENCIL_REF),
                            NAMED(GL_STENCIL_VALUE_MASK),
                            NAMED(GL_STENCIL_FAIL),
                            NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
                            NAMED(GL_STENCIL_PASS_DEPTH_PASS),
                            NAMED(GL_STENCIL_WRITEMASK),
                            NAMED(GL_STENCIL_BACK_FUNC),
                            NAMED(GL_STENCIL_BACK_REF),
                            NAMED(GL_STENCIL_BACK_VALUE_MASK),
                            NAMED(GL_STENCIL_BACK_FAIL),
                            NAMED(GL_STENCIL_BACK_WRITEMASK),
                            NAMED(GL_BLEND_COLOR),
                            NAMED(GL_LOGIC_OP_MODE),
                            NAMED(GL_COLOR_CLEAR_VALUE),
                            NAMED(GL_DEPTH_CLEAR_VALUE),
                            NAMED(GL_STENCIL_CLEAR_VALUE),
                            NAMED(GL_PACK_SWAP_BYTES),
                            NAMED(GL_PACK_ROW_LENGTH),
                            NAMED(GL_PACK_SKIP_ROWS),
                            NAMED(GL_PACK_SKIP_PIXELS),
                            NAMED(GL_PACK_ALIGNMENT),
                            NAMED(GL_UNPACK_SWAP_BYTES),
                            NAMED(GL_UNPACK_ROW_LENGTH),
                            NAMED(GL_UNPACK_SKIP_ROWS),
                            NAMED(GL_UNPACK_SKIP_PIXELS),
                            NAMED(GL_UNPACK_ALIGNMENT),
                            NAMED(GL_UNPACK_IMAGE_HEIGHT),
                            NAMED(GL_CURRENT_PROGRAM),
                            NAMED(GL_PROGRAM_PIPELINE_BINDING),
                            NAMED(GL_VERTEX_ARRAY_BINDING),
                            NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                            NAMED(GL_READ_FRAMEBUFFER_BINDING),
                            NAMED(GL_RENDERBUFFER_BINDING),
                            NAMED(GL_ARRAY_BUFFER_BINDING),
                            NAMED(GL_COPY_READ_BUFFER_BINDING),
                            NAMED(GL_COPY_WRITE_BUFFER_BINDING),
                            NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                            NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                            NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING),
                            NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
                            NAMED(GL_UNIFORM_BUFFER_BINDING),
                            NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                            NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
                            NAMED(GL_ACTIVE_TEXTURE),
                            NAMED(GL_TRANSFORM_FEEDBACK_BINDING)};

struct Indexed {
    Named query;
    GLuint count;
    GLuint ofSdk; // the first so many are bound by the SDK in draw callbacks
};
constexpr Indexed indexed[] = {{NAMED(GL_UNIFORM_BUFFER_BINDING), 8, 1},
                               {NAMED(GL_UNIFORM_BUFFER_START), 8, 1},
                               {NAMED(GL_UNIFORM_BUFFER_SIZE), 8, 1},
                               {NAMED(GL_SHADER_STORAGE_BUFFER_BINDING), 8, 4},
                               {NAMED(GL_SHADER_STORAGE_BUFFER_START), 8, 4},
                               {NAMED(GL_SHADER_STORAGE_BUFFER_SIZE), 8, 4},
                               {NAMED(GL_IMAGE_BINDING_NAME), 8, 0},
                               {NAMED(GL_IMAGE_BINDING_LEVEL), 8, 0},
                               {NAMED(GL_IMAGE_BINDING_LAYERED), 8, 0},
                               {NAMED(GL_IMAGE_BINDING_ACCESS), 8, 0},
                               {NAMED(GL_IMAGE_BINDING_FORMAT), 8, 0},
                               {NAMED(GL_VIEWPORT), 4, 0},
                               {NAMED(GL_SCISSOR_BOX), 4, 0},
                               {NAMED(GL_DEPTH_RANGE), 4, 0},
                               {NAMED(GL_COLOR_WRITEMASK), 4, 0},
                               {NAMED(GL_BLEND_SRC_RGB), 4, 0},
                               {NAMED(GL_BLEND_DST_ALPHA), 4, 0},
                               {NAMED(GL_BLEND_EQUATION_RGB), 4, 0},
                               {NAMED(GL_SAMPLE_MASK_VALUE), 1, 0}};

constexpr Named ofUnits[] = {
    NAMED(GL_TEXTURE_BINDING_2D),     NAMED(GL_TEXTURE_BINDING_2D_ARRAY), NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
    NAMED(GL_TEXTURE_BINDING_BUFFER), NAMED(GL_TEXTURE_BINDING_CUBE_MAP), NAMED(GL_TEXTURE_BINDING_3D),
    NAMED(GL_SAMPLER_BINDING)};
constexpr GLuint units = 18, unitsOfSdk = 5;

std::string at(const char* name, GLuint i) {
    return std::string(name) + "[" + std::to_string(i) + "]";
}

} // namespace

State readState() {
    State state;
    for (const Named& c : capabilities)
        state.push_back({c.name, {double(glIsEnabled(c.value))}});
    for (GLuint i = 0; i < 4; ++i) {
        state.push_back({at("GL_BLEND", i), {double(glIsEnabledi(GL_BLEND, i))}});
        state.push_back({at("GL_SCISSOR_TEST", i), {double(glIsEnabledi(GL_SCISSOR_TEST, i))}});
    }
    for (GLuint i = 0; i < 8; ++i)
        state.push_back({at("GL_CLIP_DISTANCE", i), {double(glIsEnabled(GL_CLIP_DISTANCE0 + i))}});
    for (const Named& v : values) {
        double all[16] = {};
        glGetDoublev(v.value, all);
        state.push_back({v.name, {all, all + 4}});
    }
    for (const Indexed& v : indexed)
        for (GLuint i = 0; i < v.count; ++i) {
            GLint64 all[16] = {};
            glGetInteger64i_v(v.query.value, i, all);
            const std::vector<double> four = {double(all[0]), double(all[1]), double(all[2]), double(all[3])};
            state.push_back({at(v.query.name, i), four, i < v.ofSdk});
        }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (const Named& binding : ofUnits) {
            GLint bound = 0;
            glGetIntegerv(binding.value, &bound);
            state.push_back({at(binding.name, unit), {double(bound)}, unit < unitsOfSdk});
        }
    }
    glActiveTexture(GLenum(active));
    return state;
}

void expectSameState(Test& test, const State& got, const State& expected, bool inCallback, const std::string& when) {
    for (size_t i = 0; i < got.size(); ++i)
        if (got[i].values != expected[i].values && !(inCallback && got[i].isBindingOfSdk))
            test.check(false, got[i].name + " is " + std::to_string(got[i].values[0]) + " in place of " +
                                  std::to_string(expected[i].values[0]) + " " + when + ".");
}

} // namespace agaa::conformance
