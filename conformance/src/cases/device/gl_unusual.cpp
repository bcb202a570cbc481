// State that differs from the initial state of all contexts.
#include "gl_state.h"

#include "hosts/gl_device.h"

#include <algorithm>

namespace agaa::conformance {

namespace {

GLint stateInteger(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLuint program() {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER), program = glCreateProgram();
    const char* text = "#version 430\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glLinkProgram(program);
    glDeleteShader(shader);
    return program;
}

GLuint buffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, 4096, nullptr, GL_DYNAMIC_STORAGE_BIT);
    return name;
}

void bindBuffers() {
    for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER,
                                GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_PIXEL_PACK_BUFFER,
                                GL_PIXEL_UNPACK_BUFFER, GL_QUERY_BUFFER, GL_TEXTURE_BUFFER})
        glBindBuffer(target, buffer());
    const std::pair<GLenum, GLenum> points[] = {{GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS},
                                                {GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
                                                {GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS},
                                                {GL_TRANSFORM_FEEDBACK_BUFFER, GL_MAX_TRANSFORM_FEEDBACK_BUFFERS}};
    for (const auto& [target, limit] : points) {
        for (GLint i = 0; i < stateInteger(limit); ++i)
            glBindBufferRange(target, GLuint(i), buffer(), 256, 512);
        glBindBuffer(target, buffer());
    }
}

void bindTextures() {
    const GLint units = std::min(stateInteger(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS), 64);
    for (GLint i = 0; i < units; ++i) {
        for (const GLenum target :
             {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_1D_ARRAY, GL_TEXTURE_2D_ARRAY,
              GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BUFFER,
              GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_2D_MULTISAMPLE_ARRAY}) {
            GLuint name = 0;
            glCreateTextures(target, 1, &name);
            glBindTextureUnit(GLuint(i), name);
        }
        GLuint sampler = 0;
        glCreateSamplers(1, &sampler);
        glBindSampler(GLuint(i), sampler);
    }
    for (GLint i = 0; i < stateInteger(GL_MAX_IMAGE_UNITS); ++i) {
        GLuint name = 0;
        glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
        glTextureStorage3D(name, 2, GL_R32UI, 4, 4, 3);
        glBindImageTexture(GLuint(i), name, 1, GL_FALSE, 2, GL_READ_WRITE, GL_R32I);
    }
    glActiveTexture(GL_TEXTURE5);
}

GLuint framebuffer() {
    GLuint name = 0, texture = 0;
    glCreateFramebuffers(1, &name);
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA8, 8, 8);
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, texture, 0);
    glNamedFramebufferDrawBuffer(name, GL_COLOR_ATTACHMENT1);
    glNamedFramebufferReadBuffer(name, GL_COLOR_ATTACHMENT1);
    return name;
}

void setFragments() {
    for (const GLenum name : {GL_DEPTH_TEST,
                              GL_DEPTH_CLAMP,
                              GL_STENCIL_TEST,
                              GL_RASTERIZER_DISCARD,
                              GL_CULL_FACE,
                              GL_POLYGON_OFFSET_FILL,
                              GL_POLYGON_OFFSET_LINE,
                              GL_POLYGON_OFFSET_POINT,
                              GL_POLYGON_SMOOTH,
                              GL_LINE_SMOOTH,
                              GL_PROGRAM_POINT_SIZE,
                              GL_SAMPLE_ALPHA_TO_COVERAGE,
                              GL_SAMPLE_ALPHA_TO_ONE,
                              GL_SAMPLE_COVERAGE,
                              GL_SAMPLE_MASK,
                              GL_SAMPLE_SHADING,
                              GL_COLOR_LOGIC_OP,
                              GL_FRAMEBUFFER_SRGB,
                              GL_PRIMITIVE_RESTART,
                              GL_PRIMITIVE_RESTART_FIXED_INDEX,
                              GL_TEXTURE_CUBE_MAP_SEAMLESS,
                              GL_CLIP_DISTANCE0,
                              GL_CLIP_DISTANCE3})
        glEnable(name);
    glDisable(GL_MULTISAMPLE);
    glDisable(GL_DITHER);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glStencilFuncSeparate(GL_FRONT, GL_LEQUAL, 3, 0x0F);
    glStencilFuncSeparate(GL_BACK, GL_GREATER, 5, 0xF0);
    glStencilOpSeparate(GL_FRONT, GL_INCR, GL_DECR, GL_INVERT);
    glStencilOpSeparate(GL_BACK, GL_ZERO, GL_REPLACE, GL_INCR_WRAP);
    glStencilMaskSeparate(GL_FRONT, 0x33);
    glStencilMaskSeparate(GL_BACK, 0xCC);
    glClearStencil(7);
    glClearDepth(0.25);
    glClearColor(0.125f, 0.25f, 0.5f, 0.75f);
    glBlendColor(0.75f, 0.5f, 0.25f, 0.125f);
    glLogicOp(GL_XOR);
    glSampleCoverage(0.5f, GL_TRUE);
    glSampleMaski(0, 0x5A);
    glMinSampleShading(0.75f);
    for (GLint i = 0; i < stateInteger(GL_MAX_DRAW_BUFFERS); ++i) {
        glColorMaski(GLuint(i), i % 2 == 0, GL_FALSE, i % 3 == 0, GL_TRUE);
        glBlendFuncSeparatei(GLuint(i), GL_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR);
        glBlendEquationSeparatei(GLuint(i), GL_FUNC_SUBTRACT, GL_MAX);
        (i % 2 ? glDisablei : glEnablei)(GL_BLEND, GLuint(i));
    }
}

void setRasteriser() {
    for (GLint i = 0; i < stateInteger(GL_MAX_VIEWPORTS); ++i) {
        glViewportIndexedf(GLuint(i), float(i), float(i + 1), float(i + 2), float(i + 3));
        glScissorIndexed(GLuint(i), i + 1, i + 2, i + 3, i + 4);
        glDepthRangeIndexed(GLuint(i), 0.25, 0.5);
        (i % 2 ? glDisablei : glEnablei)(GL_SCISSOR_TEST, GLuint(i));
    }
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPolygonOffset(2, 3);
    glPointSize(3);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 2);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
    glPrimitiveRestartIndex(77);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    const float inner[2] = {2, 3}, outer[4] = {4, 5, 6, 7};
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, inner);
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, outer);
}

void setPixels() {
    for (const GLenum first : {GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES}) {
        const bool isPack = first == GL_PACK_SWAP_BYTES;
        glPixelStorei(first, GL_TRUE);
        glPixelStorei(isPack ? GL_PACK_LSB_FIRST : GL_UNPACK_LSB_FIRST, GL_TRUE);
        glPixelStorei(isPack ? GL_PACK_ROW_LENGTH : GL_UNPACK_ROW_LENGTH, 3);
        glPixelStorei(isPack ? GL_PACK_IMAGE_HEIGHT : GL_UNPACK_IMAGE_HEIGHT, 5);
        glPixelStorei(isPack ? GL_PACK_SKIP_ROWS : GL_UNPACK_SKIP_ROWS, 1);
        glPixelStorei(isPack ? GL_PACK_SKIP_PIXELS : GL_UNPACK_SKIP_PIXELS, 2);
        glPixelStorei(isPack ? GL_PACK_SKIP_IMAGES : GL_UNPACK_SKIP_IMAGES, 1);
        glPixelStorei(isPack ? GL_PACK_ALIGNMENT : GL_UNPACK_ALIGNMENT, 1);
    }
    for (const GLenum hint :
         {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT, GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
        glHint(hint, GL_NICEST);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
}

} // namespace

void makeStateUnusual() {
    GLuint vertexArray = 0, pipeline = 0, renderbuffer = 0, feedback = 0;
    glCreateVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glCreateProgramPipelines(1, &pipeline);
    glBindProgramPipeline(pipeline);
    glCreateRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glCreateTransformFeedbacks(1, &feedback); // the object holds the transform feedback buffers
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    bindBuffers();
    bindTextures();
    glUseProgram(program());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer());
    setFragments();
    setRasteriser();
    setPixels();
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 1, -1, "a group of the host");
}

void setHarmlessState() {
    // Fragment state; the host sets all other state for each pass.
    for (const GLenum name :
         {GL_DEPTH_CLAMP, GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL, GL_POLYGON_SMOOTH, GL_SAMPLE_ALPHA_TO_COVERAGE,
          GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK, GL_COLOR_LOGIC_OP, GL_FRAMEBUFFER_SRGB,
          GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE3})
        glDisable(name);
    glDepthRange(0, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glFrontFace(GL_CCW);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    // State of the pixels that the host reads and clears.
    for (const GLenum target : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
        glBindBuffer(target, 0);
    for (const GLenum name :
         {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS,
          GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH,
          GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(name, 0);
}

} // namespace agaa::conformance
