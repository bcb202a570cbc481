/* The smallest OpenGL host that fetches materials by id: the SDK draws once, for depth and ids, and asks for the rest.
 *   ids_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gl_draw_state.h"
#include "ids.h"

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    GLuint program; /* of the only pass */
    GLuint vertexArray, camera, output;
    AgaaFrame frame;
} Host;

enum { cameraBinding = 6 }; /* beyond those that the SDK's passes use */

static const char fetchCode[] = FETCH_CODE("binding = 6"); /* cameraBinding */

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = fetchCode;
    function.maxDraws = 1;
    function.maxPrimitives = vertexCount / 3;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* glClipControl was not called */
    desc.pNext = &function;
    CHECK(agaaGlCreateView(host->context, &desc, &host->view));
}

static void createPass(Host* host) {
    AgaaGlDrawPass pass = AGAA_GL_DRAW_PASS_INIT;
    uint32_t count = 1;
    CHECK(agaaGlGetDrawPasses(host->view, &count, &pass));
    host->program = createProgram(pass.glslExtensions, pass.glslDeclarations, idCode);
}

static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = user;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    setState(&target->state);
    glUseProgram(host->program);
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
        glNamedBufferData(host->camera, sizeof host->frame.projection, host->frame.projection, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, cameraBinding, host->camera);
        CHECK(agaaGlRecordFrame(host->view, &host->frame, &glFrame));
        glFinish();
        reportFrame(host->view, i);
    }
}

/* The context is still current. */
static void destroy(Host* host) {
    agaaDestroyView(host->view);
    agaaDestroyContext(host->context);
    glDeleteProgram(host->program);
    glDeleteVertexArrays(1, &host->vertexArray);
    glDeleteBuffers(1, &host->camera);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    require(argumentCount == 2, "Usage: ids_gl IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    glGenVertexArrays(1, &host.vertexArray);
    glCreateBuffers(1, &host.camera);
    host.output = createOutput();
    host.context = createContext();
    createView(&host);
    createPass(&host);
    renderFrames(&host);
    writeOutput(host.output, arguments[1]);
    destroy(&host);
    eglTerminate(display); /* takes the context along */
    return EXIT_SUCCESS;
}
