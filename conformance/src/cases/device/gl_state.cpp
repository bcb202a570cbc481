#include "gl_state.h"

#include "hosts/gl_device.h"

#include <algorithm>
#include <cstdio>

namespace agaa::conformance {

namespace {

struct Row {
    GLenum name;
    const char* text;
    int count = 1;
};
#define ROW(name)                                                                                                      \
    { name, #name }
#define ROWS(name, count)                                                                                              \
    { name, #name, count }

constexpr Row switches[] = {ROW(GL_DEPTH_TEST),
                            ROW(GL_DEPTH_CLAMP),
                            ROW(GL_STENCIL_TEST),
                            ROW(GL_RASTERIZER_DISCARD),
                            ROW(GL_CULL_FACE),
                            ROW(GL_POLYGON_OFFSET_FILL),
                            ROW(GL_POLYGON_OFFSET_LINE),
                            ROW(GL_POLYGON_OFFSET_POINT),
                            ROW(GL_POLYGON_SMOOTH),
                            ROW(GL_LINE_SMOOTH),
                            ROW(GL_PROGRAM_POINT_SIZE),
                            ROW(GL_MULTISAMPLE),
                            ROW(GL_SAMPLE_ALPHA_TO_COVERAGE),
                            ROW(GL_SAMPLE_ALPHA_TO_ONE),
                            ROW(GL_SAMPLE_COVERAGE),
                            ROW(GL_SAMPLE_MASK),
                            ROW(GL_SAMPLE_SHADING),
                            ROW(GL_COLOR_LOGIC_OP),
                            ROW(GL_DITHER),
                            ROW(GL_FRAMEBUFFER_SRGB),
                            ROW(GL_PRIMITIVE_RESTART),
                            ROW(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                            ROW(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                            ROW(GL_CLIP_DISTANCE0),
                            ROW(GL_CLIP_DISTANCE1),
                            ROW(GL_CLIP_DISTANCE2),
                            ROW(GL_CLIP_DISTANCE3),
                            ROW(GL_CLIP_DISTANCE4),
                            ROW(GL_CLIP_DISTANCE5),
                            ROW(GL_CLIP_DISTANCE6),
                            ROW(GL_CLIP_DISTANCE7),
                            ROW(GL_DEBUG_OUTPUT),
                            ROW(GL_DEBUG_OUTPUT_SYNCHRONOUS)};

// Numbers and names are read as doubles, which hold every int.
constexpr Row values[] = {ROW(GL_CURRENT_PROGRAM),
                          ROW(GL_PROGRAM_PIPELINE_BINDING),
                          ROW(GL_VERTEX_ARRAY_BINDING),
                          ROW(GL_ARRAY_BUFFER_BINDING),
                          ROW(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                          ROW(GL_COPY_READ_BUFFER_BINDING),
                          ROW(GL_COPY_WRITE_BUFFER_BINDING),
                          ROW(GL_DRAW_INDIRECT_BUFFER_BINDING),
                          ROW(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
                          ROW(GL_PIXEL_PACK_BUFFER_BINDING),
                          ROW(GL_PIXEL_UNPACK_BUFFER_BINDING),
                          ROW(GL_QUERY_BUFFER_BINDING),
                          ROW(GL_TEXTURE_BUFFER_BINDING),
                          ROW(GL_UNIFORM_BUFFER_BINDING),
                          ROW(GL_SHADER_STORAGE_BUFFER_BINDING),
                          ROW(GL_ATOMIC_COUNTER_BUFFER_BINDING),
                          ROW(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
                          ROW(GL_DRAW_FRAMEBUFFER_BINDING),
                          ROW(GL_READ_FRAMEBUFFER_BINDING),
                          ROW(GL_RENDERBUFFER_BINDING),
                          ROW(GL_ACTIVE_TEXTURE),
                          ROWS(GL_VIEWPORT, 4),
                          ROWS(GL_SCISSOR_BOX, 4),
                          ROW(GL_CLIP_ORIGIN),
                          ROW(GL_CLIP_DEPTH_MODE),
                          ROW(GL_CULL_FACE_MODE),
                          ROW(GL_FRONT_FACE),
                          ROWS(GL_POLYGON_MODE, 1),
                          ROW(GL_DEPTH_FUNC),
                          ROW(GL_DEPTH_WRITEMASK),
                          ROW(GL_STENCIL_FUNC),
                          ROW(GL_STENCIL_REF),
                          ROW(GL_STENCIL_VALUE_MASK),
                          ROW(GL_STENCIL_FAIL),
                          ROW(GL_STENCIL_PASS_DEPTH_FAIL),
                          ROW(GL_STENCIL_PASS_DEPTH_PASS),
                          ROW(GL_STENCIL_WRITEMASK),
                          ROW(GL_STENCIL_BACK_FUNC),
                          ROW(GL_STENCIL_BACK_REF),
                          ROW(GL_STENCIL_BACK_VALUE_MASK),
                          ROW(GL_STENCIL_BACK_FAIL),
                          ROW(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                          ROW(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                          ROW(GL_STENCIL_BACK_WRITEMASK),
                          ROW(GL_STENCIL_CLEAR_VALUE),
                          ROW(GL_LOGIC_OP_MODE),
                          ROW(GL_PRIMITIVE_RESTART_INDEX),
                          ROW(GL_PROVOKING_VERTEX),
                          ROW(GL_PATCH_VERTICES),
                          ROW(GL_PACK_SWAP_BYTES),
                          ROW(GL_PACK_LSB_FIRST),
                          ROW(GL_PACK_ROW_LENGTH),
                          ROW(GL_PACK_IMAGE_HEIGHT),
                          ROW(GL_PACK_SKIP_ROWS),
                          ROW(GL_PACK_SKIP_PIXELS),
                          ROW(GL_PACK_SKIP_IMAGES),
                          ROW(GL_PACK_ALIGNMENT),
                          ROW(GL_UNPACK_SWAP_BYTES),
                          ROW(GL_UNPACK_LSB_FIRST),
                          ROW(GL_UNPACK_ROW_LENGTH),
                          ROW(GL_UNPACK_IMAGE_HEIGHT),
                          ROW(GL_UNPACK_SKIP_ROWS),
                          ROW(GL_UNPACK_SKIP_PIXELS),
                          ROW(GL_UNPACK_SKIP_IMAGES),
                          ROW(GL_UNPACK_ALIGNMENT),
                          ROW(GL_DRAW_BUFFER0),
                          ROW(GL_READ_BUFFER),
                          ROW(GL_SAMPLE_COVERAGE_INVERT),
                          ROW(GL_CLAMP_READ_COLOR),
                          ROW(GL_LINE_SMOOTH_HINT),
                          ROW(GL_POLYGON_SMOOTH_HINT),
                          ROW(GL_TEXTURE_COMPRESSION_HINT),
                          ROW(GL_FRAGMENT_SHADER_DERIVATIVE_HINT),
                          ROW(GL_POINT_SPRITE_COORD_ORIGIN),
                          ROW(GL_TRANSFORM_FEEDBACK_BINDING),
                          ROWS(GL_DEPTH_RANGE, 2),
                          ROWS(GL_BLEND_COLOR, 4),
                          ROWS(GL_COLOR_CLEAR_VALUE, 4),
                          ROW(GL_DEPTH_CLEAR_VALUE),
                          ROW(GL_LINE_WIDTH),
                          ROW(GL_POINT_SIZE),
                          ROW(GL_POINT_FADE_THRESHOLD_SIZE),
                          ROW(GL_POLYGON_OFFSET_FACTOR),
                          ROW(GL_POLYGON_OFFSET_UNITS),
                          ROW(GL_SAMPLE_COVERAGE_VALUE),
                          ROW(GL_MIN_SAMPLE_SHADING_VALUE),
                          ROWS(GL_PATCH_DEFAULT_INNER_LEVEL, 2),
                          ROWS(GL_PATCH_DEFAULT_OUTER_LEVEL, 4)};

constexpr Row textureTargets[] = {ROW(GL_TEXTURE_BINDING_1D),
                                  ROW(GL_TEXTURE_BINDING_2D),
                                  ROW(GL_TEXTURE_BINDING_3D),
                                  ROW(GL_TEXTURE_BINDING_1D_ARRAY),
                                  ROW(GL_TEXTURE_BINDING_2D_ARRAY),
                                  ROW(GL_TEXTURE_BINDING_RECTANGLE),
                                  ROW(GL_TEXTURE_BINDING_CUBE_MAP),
                                  ROW(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
                                  ROW(GL_TEXTURE_BINDING_BUFFER),
                                  ROW(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                                  ROW(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY),
                                  ROW(GL_SAMPLER_BINDING)};

// State per draw buffer.
constexpr Row blending[] = {ROW(GL_BLEND_SRC_RGB),   ROW(GL_BLEND_DST_RGB),      ROW(GL_BLEND_SRC_ALPHA),
                            ROW(GL_BLEND_DST_ALPHA), ROW(GL_BLEND_EQUATION_RGB), ROW(GL_BLEND_EQUATION_ALPHA)};

struct Points {
    GLenum limit, binding, start, size;
    const char* text;
    GLint sdkBindings; // number of binding points, from 0 on, that the SDK binds in draw callbacks
};
constexpr Points bufferPoints[] = {
    {GL_MAX_UNIFORM_BUFFER_BINDINGS, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
     "uniform buffer ", 1},
    {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
     GL_SHADER_STORAGE_BUFFER_SIZE, "storage buffer ", 4},
    {GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS, GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START,
     GL_ATOMIC_COUNTER_BUFFER_SIZE, "atomic counter buffer ", 0},
    {GL_MAX_TRANSFORM_FEEDBACK_BUFFERS, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START,
     GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, "transform feedback buffer ", 0}};

constexpr GLint textureUnitsOfSdk = 5;

constexpr Row imageMembers[] = {ROW(GL_IMAGE_BINDING_NAME),    ROW(GL_IMAGE_BINDING_LEVEL),
                                ROW(GL_IMAGE_BINDING_LAYERED), ROW(GL_IMAGE_BINDING_LAYER),
                                ROW(GL_IMAGE_BINDING_ACCESS),  ROW(GL_IMAGE_BINDING_FORMAT)};
#undef ROW
#undef ROWS

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::vector<double> valuesOf(const Row& row) {
    double all[4] = {};
    glGetDoublev(row.name, all);
    return {all, all + row.count};
}

void readIndexed(State& state) {
    for (GLint i = 0; i < integer(GL_MAX_VIEWPORTS); ++i) {
        const std::string at = " of viewport " + std::to_string(i);
        GLfloat viewport[4];
        GLint scissor[4];
        GLdouble range[2];
        glGetFloati_v(GL_VIEWPORT, GLuint(i), viewport);
        glGetIntegeri_v(GL_SCISSOR_BOX, GLuint(i), scissor);
        glGetDoublei_v(GL_DEPTH_RANGE, GLuint(i), range);
        state.push_back({"rectangle" + at, {viewport, viewport + 4}});
        state.push_back({"scissor rectangle" + at, {scissor, scissor + 4}});
        state.push_back({"depth range" + at, {range, range + 2}});
        state.push_back({"GL_SCISSOR_TEST" + at, {double(glIsEnabledi(GL_SCISSOR_TEST, GLuint(i)))}});
    }
    for (GLint i = 0; i < integer(GL_MAX_DRAW_BUFFERS); ++i) {
        const std::string at = " of draw buffer " + std::to_string(i);
        GLboolean mask[4];
        glGetBooleani_v(GL_COLOR_WRITEMASK, GLuint(i), mask);
        state.push_back({"GL_COLOR_WRITEMASK" + at, {mask, mask + 4}});
        state.push_back({"GL_BLEND" + at, {double(glIsEnabledi(GL_BLEND, GLuint(i)))}});
        for (const Row& row : blending) {
            GLint value = 0;
            glGetIntegeri_v(row.name, GLuint(i), &value);
            state.push_back({row.text + at, {double(value)}});
        }
    }
    for (const Points& points : bufferPoints)
        for (GLint i = 0; i < integer(points.limit); ++i) {
            GLint name = 0;
            GLint64 start = 0, size = 0;
            glGetIntegeri_v(points.binding, GLuint(i), &name);
            glGetInteger64i_v(points.start, GLuint(i), &start);
            glGetInteger64i_v(points.size, GLuint(i), &size);
            state.push_back(
                {points.text + std::to_string(i), {double(name), double(start), double(size)}, i < points.sdkBindings});
        }
    for (GLint i = 0; i < integer(GL_MAX_IMAGE_UNITS); ++i)
        for (const Row& row : imageMembers) {
            GLint value = 0;
            glGetIntegeri_v(row.name, GLuint(i), &value);
            state.push_back({row.text + (" of image unit " + std::to_string(i)), {double(value)}});
        }
    GLint mask = 0;
    glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
    state.push_back({"GL_SAMPLE_MASK_VALUE", {double(mask)}});
}

void readTextures(State& state) {
    const GLint active = integer(GL_ACTIVE_TEXTURE);
    const GLint units = std::min(integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS), 64);
    for (GLint i = 0; i < units; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        for (const Row& row : textureTargets)
            state.push_back({row.text + (" of unit " + std::to_string(i)), valuesOf(row), i < textureUnitsOfSdk});
    }
    glActiveTexture(GLenum(active));
}

std::string textOf(const std::vector<double>& all) {
    std::string text;
    for (const double value : all) {
        char number[40];
        std::snprintf(number, sizeof number, "%s%.10g", text.empty() ? "" : ", ", value);
        text += number;
    }
    return text;
}

} // namespace

State readState() {
    State state;
    for (const Row& row : switches)
        state.push_back({row.text, {double(glIsEnabled(row.name))}});
    for (const Row& row : values)
        state.push_back({row.text, valuesOf(row)});
    // The depth differs in callbacks, because the SDK's passes are debug groups.
    state.push_back({"GL_DEBUG_GROUP_STACK_DEPTH", {double(integer(GL_DEBUG_GROUP_STACK_DEPTH))}, true});
    readIndexed(state);
    readTextures(state);
    return state;
}

void expectSameState(Test& test, const State& got, const State& expected, bool inCallback, const std::string& when) {
    for (size_t i = 0; i < got.size(); ++i)
        if (got[i].values != expected[i].values && !(inCallback && got[i].isBindingOfSdk))
            test.check(false, got[i].name + " is " + textOf(got[i].values) + " in place of " +
                                  textOf(expected[i].values) + " " + when + ".");
}

SeparateOpenGl::SeparateOpenGl(Test& outer)
    : device(makeOpenGlDevice(outer.device().deviceName())), test(outer.sdk, device.get()), outer_(outer) {}

SeparateOpenGl::~SeparateOpenGl() {
    for (const std::string& failure : test.failures())
        outer_.check(false, failure);
}

} // namespace agaa::conformance
