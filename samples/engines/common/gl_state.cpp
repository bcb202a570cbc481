/* SPDX-License-Identifier: MIT */
#include "common/gl_state.h"

#include "engine_gl.h"

#include <cstdio>

namespace {

struct Query {
    const char* name;
    GLenum token;
    int values;
};
#define QUERY(token, values)                                                                                           \
    { #token, token, values }

constexpr Query capabilities[] = {
    QUERY(GL_BLEND, 1),
    QUERY(GL_COLOR_LOGIC_OP, 1),
    QUERY(GL_CULL_FACE, 1),
    QUERY(GL_DEPTH_CLAMP, 1),
    QUERY(GL_DEPTH_TEST, 1),
    QUERY(GL_DITHER, 1),
    QUERY(GL_FRAMEBUFFER_SRGB, 1),
    QUERY(GL_MULTISAMPLE, 1),
    QUERY(GL_POLYGON_OFFSET_FILL, 1),
    QUERY(GL_PRIMITIVE_RESTART, 1),
    QUERY(GL_RASTERIZER_DISCARD, 1),
    QUERY(GL_SAMPLE_ALPHA_TO_COVERAGE, 1),
    QUERY(GL_SAMPLE_COVERAGE, 1),
    QUERY(GL_SAMPLE_MASK, 1),
    QUERY(GL_SAMPLE_SHADING, 1),
    QUERY(GL_SCISSOR_TEST, 1),
    QUERY(GL_STENCIL_TEST, 1),
    QUERY(GL_PROGRAM_POINT_SIZE, 1),
    QUERY(GL_TEXTURE_CUBE_MAP_SEAMLESS, 1),
    QUERY(GL_CLIP_DISTANCE0, 1),
};
constexpr Query integers[] = {
    QUERY(GL_ACTIVE_TEXTURE, 1),
    QUERY(GL_CURRENT_PROGRAM, 1),
    QUERY(GL_PROGRAM_PIPELINE_BINDING, 1),
    QUERY(GL_VERTEX_ARRAY_BINDING, 1),
    QUERY(GL_ARRAY_BUFFER_BINDING, 1),
    QUERY(GL_DRAW_FRAMEBUFFER_BINDING, 1),
    QUERY(GL_READ_FRAMEBUFFER_BINDING, 1),
    QUERY(GL_RENDERBUFFER_BINDING, 1),
    QUERY(GL_UNIFORM_BUFFER_BINDING, 1),
    QUERY(GL_SHADER_STORAGE_BUFFER_BINDING, 1),
    QUERY(GL_ATOMIC_COUNTER_BUFFER_BINDING, 1),
    QUERY(GL_PIXEL_PACK_BUFFER_BINDING, 1),
    QUERY(GL_PIXEL_UNPACK_BUFFER_BINDING, 1),
    QUERY(GL_COPY_READ_BUFFER_BINDING, 1),
    QUERY(GL_COPY_WRITE_BUFFER_BINDING, 1),
    QUERY(GL_DISPATCH_INDIRECT_BUFFER_BINDING, 1),
    QUERY(GL_DRAW_INDIRECT_BUFFER_BINDING, 1),
    QUERY(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1),
    QUERY(GL_VIEWPORT, 4),
    QUERY(GL_SCISSOR_BOX, 4),
    QUERY(GL_BLEND_SRC_RGB, 1),
    QUERY(GL_BLEND_DST_RGB, 1),
    QUERY(GL_BLEND_SRC_ALPHA, 1),
    QUERY(GL_BLEND_DST_ALPHA, 1),
    QUERY(GL_BLEND_EQUATION_RGB, 1),
    QUERY(GL_BLEND_EQUATION_ALPHA, 1),
    QUERY(GL_COLOR_WRITEMASK, 4),
    QUERY(GL_DEPTH_WRITEMASK, 1),
    QUERY(GL_DEPTH_FUNC, 1),
    QUERY(GL_STENCIL_FUNC, 1),
    QUERY(GL_STENCIL_REF, 1),
    QUERY(GL_STENCIL_VALUE_MASK, 1),
    QUERY(GL_STENCIL_WRITEMASK, 1),
    QUERY(GL_STENCIL_FAIL, 1),
    QUERY(GL_STENCIL_PASS_DEPTH_FAIL, 1),
    QUERY(GL_STENCIL_PASS_DEPTH_PASS, 1),
    QUERY(GL_STENCIL_BACK_FUNC, 1),
    QUERY(GL_STENCIL_BACK_WRITEMASK, 1),
    QUERY(GL_STENCIL_BACK_PASS_DEPTH_PASS, 1),
    QUERY(GL_CULL_FACE_MODE, 1),
    QUERY(GL_FRONT_FACE, 1),
    QUERY(GL_POLYGON_MODE, 1),
    QUERY(GL_LOGIC_OP_MODE, 1),
    QUERY(GL_DRAW_BUFFER, 1),
    QUERY(GL_READ_BUFFER, 1),
    QUERY(GL_CLIP_ORIGIN, 1),
    QUERY(GL_CLIP_DEPTH_MODE, 1),
    QUERY(GL_PROVOKING_VERTEX, 1),
    QUERY(GL_PATCH_VERTICES, 1),
    QUERY(GL_PRIMITIVE_RESTART_INDEX, 1),
    QUERY(GL_PACK_ALIGNMENT, 1),
    QUERY(GL_PACK_ROW_LENGTH, 1),
    QUERY(GL_UNPACK_ALIGNMENT, 1),
    QUERY(GL_UNPACK_ROW_LENGTH, 1),
    QUERY(GL_UNPACK_SKIP_PIXELS, 1),
    QUERY(GL_UNPACK_SKIP_ROWS, 1),
};
constexpr Query floats[] = {
    QUERY(GL_COLOR_CLEAR_VALUE, 4),
    QUERY(GL_DEPTH_CLEAR_VALUE, 1),
    QUERY(GL_DEPTH_RANGE, 2),
    QUERY(GL_BLEND_COLOR, 4),
    QUERY(GL_POLYGON_OFFSET_FACTOR, 1),
    QUERY(GL_POLYGON_OFFSET_UNITS, 1),
    QUERY(GL_LINE_WIDTH, 1),
    QUERY(GL_POINT_SIZE, 1),
    QUERY(GL_MIN_SAMPLE_SHADING_VALUE, 1),
    QUERY(GL_SAMPLE_COVERAGE_VALUE, 1),
};
constexpr Query textures[] = {
    QUERY(GL_TEXTURE_BINDING_2D, 1),     QUERY(GL_TEXTURE_BINDING_2D_ARRAY, 1),
    QUERY(GL_TEXTURE_BINDING_3D, 1),     QUERY(GL_TEXTURE_BINDING_CUBE_MAP, 1),
    QUERY(GL_TEXTURE_BINDING_BUFFER, 1), QUERY(GL_TEXTURE_BINDING_2D_MULTISAMPLE, 1),
    QUERY(GL_SAMPLER_BINDING, 1),
};
constexpr Query indexed[] = {
    QUERY(GL_IMAGE_BINDING_NAME, 1),
    QUERY(GL_IMAGE_BINDING_FORMAT, 1),
    QUERY(GL_UNIFORM_BUFFER_BINDING, 1),
    QUERY(GL_SHADER_STORAGE_BUFFER_BINDING, 1),
};
constexpr unsigned textureUnits = 24, indexedBindings = 8;

unsigned severe = 0;

void ENGINE_GL_CALL onMessage(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* message, const void*) {
    if (severity != GL_DEBUG_SEVERITY_HIGH)
        return;
    ++severe;
    std::fprintf(stderr, "OpenGL: %s\n", message);
}

} // namespace

GlState readGlState() {
    GlState state;
    for (const Query& each : capabilities)
        state[each.name] = {glIsEnabled(each.token)};
    for (const Query& each : integers) {
        GLint values[4] = {};
        glGetIntegerv(each.token, values);
        state[each.name].assign(values, values + each.values);
    }
    for (const Query& each : floats) {
        GLfloat values[4] = {};
        glGetFloatv(each.token, values);
        for (int i = 0; i < each.values; ++i)
            state[each.name].push_back(static_cast<long long>(values[i] * 1e6f));
    }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (unsigned unit = 0; unit < textureUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (const Query& each : textures) {
            GLint value = 0;
            glGetIntegerv(each.token, &value);
            state[each.name].push_back(value);
        }
    }
    glActiveTexture(static_cast<GLenum>(active));
    for (const Query& each : indexed)
        for (unsigned i = 0; i < indexedBindings; ++i) {
            GLint value = 0;
            glGetIntegeri_v(each.token, i, &value);
            state[std::string(each.name) + "[]"].push_back(value);
        }
    return state;
}

std::string differingStates(const GlState& before, const GlState& after) {
    std::string names;
    for (const auto& [name, values] : before)
        if (after.at(name) != values)
            names += (names.empty() ? "" : " ") + name;
    return names;
}

unsigned takeGlErrors() {
    unsigned count = 0;
    while (glGetError() != GL_NO_ERROR)
        ++count;
    return count;
}

void countSevereMessages() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

unsigned severeMessages() { return severe; }
