#include "frame_gl_state.h"

namespace agaa::conformance {

namespace {

#define NAMED(e)                                                                                   \
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

constexpr Named ofUnits[] = {NAMED(GL_TEXTURE_BINDING_2D),
                             NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
                             NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                             NAMED(GL_TEXTURE_BINDING_BUFFER),
                             NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
                             NAMED(GL_TEXTURE_BINDING_3D),
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
            const std::vector<double> four = {double(all[0]), double(all[1]), double(all[2]),
                                              double(all[3])};
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

void expectSameState(Test& test, const State& got, const State& expected, bool inCallback,
                     const std::string& when) {
    for (size_t i = 0; i < got.size(); ++i)
        if (got[i].values != expected[i].values && !(inCallback && got[i].isBindingOfSdk))
            test.check(false, got[i].name + " is " + std::to_string(got[i].values[0]) +
                                  " in place of " + std::to_string(expected[i].values[0]) + " " +
                                  when + ".");
}

UnusualState::UnusualState() {
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, 65536, nullptr, 0);
    const GLenum targets[] = {
        GL_ARRAY_BUFFER,         GL_COPY_READ_BUFFER,         GL_COPY_WRITE_BUFFER,
        GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_PIXEL_UNPACK_BUFFER};
    for (const GLenum target : targets)
        glBindBuffer(target, buffer_);
    for (GLuint i = 0; i < 8; ++i) {
        glBindBufferRange(GL_UNIFORM_BUFFER, i, buffer_, 256 * i, 512);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer_, 256 * i, 1024);
    }
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 2, GL_RGBA8, 8, 8);
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &array_);
    glTextureStorage3D(array_, 1, GL_RGBA8, 8, 8, 2);
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &multisampled_);
    glTextureStorage2DMultisample(multisampled_, 4, GL_RGBA8, 8, 8, GL_TRUE);
    glCreateSamplers(1, &sampler_);
    for (GLuint unit = 0; unit < units; ++unit) {
        for (const GLuint texture : {texture_, array_, multisampled_})
            glBindTextureUnit(unit, texture);
        glBindSampler(unit, sampler_);
    }
    for (GLuint i = 0; i < 8; ++i)
        glBindImageTexture(i, texture_, 1, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA8);
    glActiveTexture(GL_TEXTURE0 + 7);
    glCreateVertexArrays(1, &vertexArray_);
    glBindVertexArray(vertexArray_);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    for (const GLenum capability :
         {GL_DEPTH_CLAMP, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_CULL_FACE,
          GL_POLYGON_OFFSET_FILL, GL_SAMPLE_MASK, GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE,
          GL_SAMPLE_SHADING, GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_BLEND, GL_FRAMEBUFFER_SRGB,
          GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_PROGRAM_POINT_SIZE})
        glEnable(capability);
    glDisable(GL_DITHER);
    glDisable(GL_MULTISAMPLE);
    glViewportIndexedf(0, 3, 4, 5, 6);
    glViewportIndexedf(2, 1, 1, 9, 9);
    glScissor(1, 2, 3, 4);
    glDepthRange(0.25, 0.5);
    glDepthFunc(GL_NOTEQUAL);
    glDepthMask(GL_FALSE);
    glColorMaski(0, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glColorMaski(1, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glStencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x0F);
    glStencilFuncSeparate(GL_BACK, GL_GREATER, 5, 0xF0);
    glStencilMask(0x33);
    glStencilOp(GL_ZERO, GL_INVERT, GL_DECR);
    glSampleMaski(0, 0x5);
    glSampleCoverage(0.25f, GL_TRUE);
    glMinSampleShading(0.25f);
    glBlendFunc(GL_DST_COLOR, GL_ONE_MINUS_SRC_COLOR);
    glBlendEquation(GL_MAX);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    glLogicOp(GL_XOR);
    glClearColor(0.5f, 0.25f, 0.125f, 0.0625f);
    glClearDepth(0.125);
    glClearStencil(9);
    glPolygonOffset(2, 3);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glFrontFace(GL_CW);
    glCullFace(GL_FRONT);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glPrimitiveRestartIndex(77);
    glPatchParameteri(GL_PATCH_VERTICES, 5);
    for (const GLenum store : {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH})
        glPixelStorei(store, 100);
    for (const GLenum store : {GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
        glPixelStorei(store, 2);
    for (const GLenum store : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
        glPixelStorei(store, 1);
}

void setHarmlessState() {
    for (const GLenum capability :
         {GL_DEPTH_CLAMP, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_CULL_FACE,
          GL_POLYGON_OFFSET_FILL, GL_SAMPLE_MASK, GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE,
          GL_SAMPLE_SHADING, GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_BLEND, GL_FRAMEBUFFER_SRGB,
          GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_PROGRAM_POINT_SIZE})
        glDisable(capability);
    glEnable(GL_MULTISAMPLE);
    glDepthRange(0, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glFrontFace(GL_CCW);
}

UnusualState::~UnusualState() {
    setHarmlessState();
    glEnable(GL_DITHER);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(~0u);
    for (const GLenum store : {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS,
                               GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
        glPixelStorei(store, 0);
    for (const GLenum store : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
        glPixelStorei(store, 4);
    for (GLuint i = 0; i < 8; ++i)
        glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_); // what is deleted is bound no more
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteSamplers(1, &sampler_);
    for (const GLuint* texture : {&texture_, &array_, &multisampled_})
        glDeleteTextures(1, texture);
    for (GLuint i = 0; i < 8; ++i) {
        glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
    }
    glDeleteBuffers(1, &buffer_);
}

} // namespace agaa::conformance
