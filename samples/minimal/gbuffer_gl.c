/* The smallest host that draws its own multisampled G-buffer: the SDK reads it, aggregates and shades.
 *   gbuffer_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gbuffer.h"
#include "gl.h"

enum { firstUnit = 20 }; /* first texture unit of sampleCode; units from 17 belong to the host */

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    GLuint textures[imageCount];
    GLuint framebuffer, program, vertexArray, output;
} Host;

static const char sampleCode[] = SAMPLE_CODE("binding = 20", "binding = 21", "binding = 22");

static void createGBuffer(Host* host) {
    static const GLenum formats[imageCount] = {GL_RGBA8, GL_RGBA16F, GL_DEPTH_COMPONENT32F};
    static const GLenum attachments[imageCount] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT};
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, imageCount, host->textures);
    glCreateFramebuffers(1, &host->framebuffer);
    for (int i = 0; i < imageCount; ++i) {
        glTextureStorage2DMultisample(host->textures[i], samples, formats[i], width, height, GL_TRUE);
        glNamedFramebufferTexture(host->framebuffer, attachments[i], host->textures[i], 0);
        glBindTextureUnit((GLuint)(firstUnit + i), host->textures[i]);
    }
    glNamedFramebufferDrawBuffers(host->framebuffer, 2, attachments);
    require(glCheckNamedFramebufferStatus(host->framebuffer, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
            "The G-buffer cannot be drawn to.");
    host->program = createProgram("", "", vertexCode, gbufferCode);
}

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaConfig config = *desc.config;
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    config.samples = samples;
    function.glsl = sampleCode;
    desc.config = &config;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* the host does not call glClipControl */
    desc.pNext = &function;
    CHECK(agaaGlCreateView(host->context, &desc, &host->view));
}

static void drawGBuffer(const Host* host, const AgaaFrame* frame) {
    glBindFramebuffer(GL_FRAMEBUFFER, host->framebuffer);
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(host->program);
    glUniformMatrix4fv(0, 1, GL_FALSE, frame->projection);
    glBindVertexArray(host->vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
}

static void renderFrames(Host* host) {
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = host->output;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        const AgaaFrame frame = describeFrame(i, -1.0f); /* draw stays null: the SDK draws nothing */
        drawGBuffer(host, &frame);
        CHECK(agaaGlRecordFrame(host->view, &frame, &glFrame));
        glFinish();
        reportFrame(host->view, i);
    }
}

/* The context must still be current. */
static void destroy(Host* host) {
    agaaDestroyView(host->view);
    CHECK(agaaDestroyContext(host->context));
    glDeleteProgram(host->program);
    glDeleteVertexArrays(1, &host->vertexArray);
    glDeleteFramebuffers(1, &host->framebuffer);
    glDeleteTextures(imageCount, host->textures);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    require(argumentCount == 2, "Usage: gbuffer_gl IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    glGenVertexArrays(1, &host.vertexArray);
    host.output = createOutput();
    createGBuffer(&host);
    host.context = createContext();
    createView(&host);
    renderFrames(&host);
    writeOutput(host.output, arguments[1]);
    destroy(&host);
    eglTerminate(display); /* this also destroys the context */
    return EXIT_SUCCESS;
}
