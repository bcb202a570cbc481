/* The smallest OpenGL host that draws nothing: the SDK's compute passes fetch the triangles and expand them to coverage
 * samples.
 *   triangles_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gl.h"
#include "ids.h"

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    GLuint geometry, output;
} Host;

enum { geometryBinding = 6 }; /* the SDK's passes use lower bindings */

static const char fetchCode[] = FETCH_CODE("binding = 6") TRIANGLES_CODE;

static void createGeometry(Host* host) {
    const Geometry geometry = describeGeometry(-1.0f);
    glCreateBuffers(1, &host->geometry);
    glNamedBufferStorage(host->geometry, sizeof geometry, &geometry, 0);
}

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaConfig config = *desc.config;
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    config.technique = "dcaa";
    config.samples = 64;
    function.glsl = fetchCode;
    function.maxDraws = drawCount;
    function.maxPrimitives = vertexCount / 3;     /* upper bound for one draw */
    function.maxTriangles = vertexCount / 3;      /* upper bound for all draws together */
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* the host does not call glClipControl */
    desc.config = &config;
    desc.pNext = &function;
    CHECK(agaaGlCreateView(host->context, &desc, &host->view));
}

static void renderFrames(Host* host) {
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = host->output;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        const AgaaFrame frame = describeFrame(i, -1.0f); /* draw stays null */
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, geometryBinding, host->geometry);
        CHECK(agaaGlRecordFrame(host->view, &frame, &glFrame));
        glFinish();
        reportFrame(host->view, i);
    }
}

/* The context must still be current. */
static void destroy(Host* host) {
    agaaDestroyView(host->view);
    CHECK(agaaDestroyContext(host->context));
    glDeleteBuffers(1, &host->geometry);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    require(argumentCount == 2, "Usage: triangles_gl IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    createGeometry(&host);
    host.output = createOutput();
    host.context = createContext();
    createView(&host);
    renderFrames(&host);
    writeOutput(host.output, arguments[1]);
    destroy(&host);
    eglTerminate(display); /* this also destroys the context */
    return EXIT_SUCCESS;
}
