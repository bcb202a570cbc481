#include "frame_gl_state.h"

namespace agaa::conformance {

namespace {
constexpr GLuint units = 18;
}

UnusualState::UnusualState() {
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, 65536, nullptr, 0);
    const GLenum targets[] = {GL_ARRAY_BUFFER,         GL_COPY_READ_BUFFER,         GL_COPY_WRITE_BUFFER,
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
         {GL_DEPTH_CLAMP, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_SAMPLE_MASK,
          GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_SHADING, GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_BLEND,
          GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_PROGRAM_POINT_SIZE})
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
         {GL_DEPTH_CLAMP, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_SAMPLE_MASK,
          GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_SHADING, GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_BLEND,
          GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_PROGRAM_POINT_SIZE})
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
    for (const GLenum store :
         {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
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
