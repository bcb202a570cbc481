/* The smallest OpenGL host: draws a few triangles through the SDK, without a window, and writes an image.
 *   minimal_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gl_draw_state.h"

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    uint32_t passCount;
    uint64_t keys[maxPasses];
    GLuint programs[maxPasses];
    GLuint vertexArray, output;
    AgaaFrame frame;
} Host;

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* the host does not call glClipControl */
    CHECK(agaaGlCreateView(host->context, &desc, &host->view));
}

static void createPasses(Host* host) {
    AgaaDrawPass passes[maxPasses];
    for (int i = 0; i < maxPasses; ++i)
        agaaInitDrawPass(&passes[i], sizeof passes[i]);
    host->passCount = maxPasses;
    CHECK(agaaGetDrawPasses(host->view, &host->passCount, passes));
    for (uint32_t i = 0; i < host->passCount; ++i) {
        host->keys[i] = passes[i].pipelineKey;
        host->programs[i] =
            createProgram(passes[i].glslExtensions, passes[i].glslDeclarations, vertexCode, materialCode);
    }
}

static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = user;
    uint32_t pass = 0;
    while (host->keys[pass] != target->pipelineKey)
        if (++pass == host->passCount)
            return AGAA_ERROR_CALLBACK;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    setState(&target->state);
    glUseProgram(host->programs[pass]);
    glUniformMatrix4fv(0, 1, GL_FALSE, host->frame.projection);
    glBindVertexArray(host->vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
    return AGAA_OK;
}

static void renderFrames(Host* host) {
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = host->output;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        host->frame = describeFrame(i, -1.0f);
        host->frame.draw = draw;
        host->frame.drawUser = host;
        CHECK(agaaGlRecordFrame(host->view, &host->frame, &glFrame));
        glFinish();
        reportFrame(host->view, i);
    }
}

/* The context must still be current. */
static void destroy(Host* host) {
    agaaDestroyView(host->view);
    CHECK(agaaDestroyContext(host->context));
    for (uint32_t i = 0; i < host->passCount; ++i)
        glDeleteProgram(host->programs[i]);
    glDeleteVertexArrays(1, &host->vertexArray);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    require(argumentCount == 2, "Usage: minimal_gl IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    glGenVertexArrays(1, &host.vertexArray);
    host.output = createOutput();
    host.context = createContext();
    createView(&host);
    createPasses(&host);
    renderFrames(&host);
    writeOutput(host.output, arguments[1]);
    destroy(&host);
    eglTerminate(display); /* this also destroys the context */
    return EXIT_SUCCESS;
}
