/* The smallest OpenGL host with materials by id: the scene is drawn once, for depth and ids, and the SDK fetches the
 * materials.
 *   ids_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gl_draw_state.h"
#include "ids.h"

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    GLuint program; /* program of the only pass */
    GLuint vertexArray, geometry, output;
    AgaaFrame frame;
} Host;

enum { geometryBinding = 6 }; /* the SDK's passes use lower bindings */
#define GEOMETRY_AT "binding = 6"

static const char numberedVertexCode[] = "layout(location = 1) uniform uint DRAW;\n" ID_VERTEX_CODE(GEOMETRY_AT);
static const char fetchCode[] = FETCH_CODE(GEOMETRY_AT);

static void createGeometry(Host* host) {
    const Geometry geometry = describeGeometry(-1.0f);
    glCreateBuffers(1, &host->geometry);
    glNamedBufferStorage(host->geometry, sizeof geometry, &geometry, 0);
}

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = fetchCode;
    function.maxDraws = drawCount;
    function.maxPrimitives = vertexCount / 3;     /* upper bound for one draw */
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* the host does not call glClipControl */
    desc.pNext = &function;
    CHECK(agaaGlCreateView(host->context, &desc, &host->view));
}

static void createPass(Host* host) {
    AgaaDrawPass pass = AGAA_DRAW_PASS_INIT;
    uint32_t count = 1;
    CHECK(agaaGetDrawPasses(host->view, &count, &pass));
    host->program = createProgram(pass.glslExtensions, pass.glslDeclarations, numberedVertexCode, idCode);
}

static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = user;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    setState(&target->state);
    glUseProgram(host->program);
    glBindVertexArray(host->vertexArray);
    for (uint32_t i = 0; i < drawCount; ++i) {
        glUniform1ui(1, i);
        glDrawArrays(GL_TRIANGLES, (GLint)drawBegin[i], (GLsizei)(drawBegin[i + 1] - drawBegin[i]));
    }
    return AGAA_OK;
}

static void renderFrames(Host* host) {
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = host->output;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        host->frame = describeFrame(i, -1.0f);
        host->frame.draw = draw;
        host->frame.drawUser = host;
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, geometryBinding, host->geometry);
        CHECK(agaaGlRecordFrame(host->view, &host->frame, &glFrame));
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
    glDeleteBuffers(1, &host->geometry);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    require(argumentCount == 2, "Usage: ids_gl IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    glGenVertexArrays(1, &host.vertexArray);
    createGeometry(&host);
    host.output = createOutput();
    host.context = createContext();
    createView(&host);
    createPass(&host);
    renderFrames(&host);
    writeOutput(host.output, arguments[1]);
    destroy(&host);
    eglTerminate(display); /* this also destroys the context */
    return EXIT_SUCCESS;
}
