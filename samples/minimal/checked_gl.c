/* A host whose integration the conformance suite checks, in the host's OpenGL context and with its draw callback.
 *   checked_gl
 * SPDX-License-Identifier: MIT
 */
#include "gl_draw_state.h"

#include "agaa_conformance.h"

#include <string.h>

enum { maxPrograms = 64 };

typedef struct Host {
    uint32_t programCount;
    uint64_t keys[maxPrograms]; /* all views share programs by the key of their pass */
    GLuint programs[maxPrograms];
    GLuint vertexArray, output;
    float projection[16];
} Host;

static GLuint findProgram(const Host* host, uint64_t key) {
    for (uint32_t i = 0; i < host->programCount; ++i)
        if (host->keys[i] == key)
            return host->programs[i];
    return 0;
}

static AgaaResult prepareView(void* user, AgaaView view) {
    Host* host = user;
    AgaaDrawPass passes[maxPasses];
    uint32_t count = maxPasses;
    for (int i = 0; i < maxPasses; ++i)
        agaaInitDrawPass(&passes[i], sizeof passes[i]);
    CHECK(agaaGetDrawPasses(view, &count, passes));
    for (uint32_t i = 0; i < count; ++i) {
        if (findProgram(host, passes[i].pipelineKey))
            continue;
        require(host->programCount < maxPrograms, "The suite needs more programs than this host expects.");
        host->keys[host->programCount] = passes[i].pipelineKey;
        host->programs[host->programCount++] =
            createProgram(passes[i].glslExtensions, passes[i].glslDeclarations, vertexCode, materialCode);
    }
    return AGAA_OK;
}

static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = user;
    const GLuint program = findProgram(host, target->pipelineKey);
    if (!program)
        return AGAA_ERROR_CALLBACK;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    setState(&target->state);
    glUseProgram(program);
    glUniformMatrix4fv(0, 1, GL_FALSE, host->projection);
    glBindVertexArray(host->vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
    return AGAA_OK;
}

static AgaaResult renderFrame(void* user, AgaaView view, AgaaFrame* frame, float* outPixels) {
    Host* host = user;
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    const AgaaFrame hostFrame = describeFrame(frame->frameIndex, -1.0f);
    memcpy(frame->projection, hostFrame.projection, sizeof hostFrame.projection);
    memcpy(host->projection, hostFrame.projection, sizeof hostFrame.projection);
    frame->draw = draw;
    frame->drawUser = host;
    glFrame.outputTexture = host->output;
    const AgaaResult result = agaaGlRecordFrame(view, frame, &glFrame);
    glGetTextureImage(host->output, 0, GL_RGBA, GL_FLOAT, width * height * 4 * sizeof(float), outPixels);
    return result;
}

static void onResult(void* user, const AgaaConformanceResult* result) {
    static const char* const words[] = {"passed", "failed", "skipped"};
    (void)user;
    printf("%s %s %s\n", words[result->status], result->name, result->reason);
}

int main(void) {
    Host host = {0};
    AgaaConformanceRun run = {0};
    AgaaConformanceHost checked = {0};
    AgaaViewDesc view = describeView();
    const EGLDisplay display = beginOpenGl(); /* debug messages end the program, so takeMessages stays null */
    view.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    glGenVertexArrays(1, &host.vertexArray);
    host.output = createOutput();
    run.structSize = sizeof run;
    run.onResult = onResult;
    checked.structSize = sizeof checked;
    checked.api = AGAA_CONFORMANCE_OPENGL;
    checked.user = &host;
    checked.context = createContext();
    checked.view = &view;
    checked.prepareView = prepareView;
    checked.renderFrame = renderFrame;
    const int32_t failed = agaaConformanceCheckHost(&run, &checked);
    CHECK(agaaDestroyContext(checked.context));
    eglTerminate(display);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
