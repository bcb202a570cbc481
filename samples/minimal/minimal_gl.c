/* The smallest OpenGL host: draws a few triangles through the SDK, without a window, and writes an image.
 *   minimal_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#define GL_GLEXT_PROTOTYPES
#include "agaa_gl.h"
#include "host.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    uint32_t passCount;
    uint64_t keys[maxPasses];
    GLuint programs[maxPasses];
    GLuint vertexArray, output;
    AgaaFrame frame;
} Host;

/* A context that needs no window, of the version that has all the SDK asks for. */
static EGLDisplay createDisplay(const AgaaGlRequirements* sdk) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, (EGLint)sdk->completeMajorVersion,
                                 EGL_CONTEXT_MINOR_VERSION, (EGLint)sdk->completeMinorVersion,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    require(eglInitialize(display, NULL, NULL) && eglBindAPI(EGL_OPENGL_API), "EGL offers no OpenGL without a window.");
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    require(context != EGL_NO_CONTEXT, "EGL has no OpenGL of the version that the SDK asks for.");
    require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context), "EGL demands a surface.");
    return display;
}

static void APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                               const GLchar* message, const void* user) {
    (void)source, (void)id, (void)severity, (void)length, (void)user;
    require(type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, message);
}

static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name) {
    (void)user;
    return (AgaaGlFunction)eglGetProcAddress(name);
}

static void createContext(Host* host) {
    AgaaLog log = AGAA_LOG_INIT;
    AgaaGlContextDesc desc = AGAA_GL_CONTEXT_DESC_INIT;
    log.callback = onLog;
    desc.getProcAddr = getProcAddr;
    desc.glslVersion = 450;
    desc.statePolicy = AGAA_GL_STATE_RESTORE;
    desc.framesInFlight = 1; /* this host waits for each frame */
    desc.log = &log;
    CHECK(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &host->context));
    AgaaViewDesc view = describeView();
    view.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* glClipControl was not called */
    CHECK(agaaGlCreateView(host->context, &view, &host->view));
}

static void attach(GLuint program, GLenum stage, const char* extensions, const char* declarations,
                   const char* code) {
    const char* const pieces[] = {"#version 450\n", extensions, declarations, code};
    const GLuint shader = glCreateShader(stage);
    char message[1024] = "";
    GLint isCompiled;
    glShaderSource(shader, 4, pieces, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    glGetShaderInfoLog(shader, sizeof message, NULL, message);
    require(isCompiled, message);
    glAttachShader(program, shader);
    glDeleteShader(shader); /* goes with the program */
}

static GLuint createProgram(const AgaaGlDrawPass* sdk) {
    const GLuint program = glCreateProgram();
    GLint isLinked;
    attach(program, GL_VERTEX_SHADER, "#define VERTEX gl_VertexID\n",
           "layout(location = 0) uniform mat4 clipFromShading;\n", vertexCode);
    attach(program, GL_FRAGMENT_SHADER, sdk->glslExtensions, sdk->glslDeclarations, materialCode);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    require(isLinked, "A program does not link.");
    return program;
}

static void createPasses(Host* host) {
    AgaaGlDrawPass passes[maxPasses] = {AGAA_GL_DRAW_PASS_INIT, AGAA_GL_DRAW_PASS_INIT, AGAA_GL_DRAW_PASS_INIT,
                                        AGAA_GL_DRAW_PASS_INIT};
    host->passCount = maxPasses;
    CHECK(agaaGlGetDrawPasses(host->view, &host->passCount, passes));
    for (uint32_t i = 0; i < host->passCount; ++i) {
        host->keys[i] = passes[i].pipelineKey;
        host->programs[i] = createProgram(&passes[i]);
    }
}

static void enable(GLenum capability, uint32_t isEnabled) {
    if (isEnabled)
        glEnable(capability);
    else
        glDisable(capability);
}

static void setState(const AgaaDrawState* state) {
    static const GLenum compareOps[] = {GL_LESS, GL_GREATER, GL_EQUAL, GL_ALWAYS};
    const GLboolean writes[4] = {state->colorWriteMask & 1, state->colorWriteMask >> 1 & 1,
                                 state->colorWriteMask >> 2 & 1, state->colorWriteMask >> 3 & 1};
    enable(GL_DEPTH_TEST, 1);
    glDepthFunc(compareOps[state->depthCompare]);
    glDepthMask((GLboolean)state->depthWrite);
    enable(GL_STENCIL_TEST, state->stencilTest);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glStencilMask(0xFF);
    glColorMask(writes[0], writes[1], writes[2], writes[3]);
    enable(GL_SAMPLE_SHADING, state->sampleShading);
    glMinSampleShading(1.0f);
    enable(GL_MULTISAMPLE, 1);
    enable(GL_BLEND, 0);
    enable(GL_SCISSOR_TEST, 0);
    enable(GL_CULL_FACE, 0); /* the host's choice, but the same in every pass */
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

static GLuint createOutput(void) {
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA32F, width, height);
    return texture;
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

/* The context is still current. */
static void destroy(Host* host) {
    agaaDestroyView(host->view);
    agaaDestroyContext(host->context);
    for (uint32_t i = 0; i < host->passCount; ++i)
        glDeleteProgram(host->programs[i]);
    glDeleteVertexArrays(1, &host->vertexArray);
    glDeleteTextures(1, &host->output);
}

int main(int argumentCount, char** arguments) {
    static float pixels[4 * width * height];
    AgaaGlRequirements requirements = AGAA_GL_REQUIREMENTS_INIT;
    Host host = {0};
    require(argumentCount == 2, "Usage: minimal_gl IMAGE.ppm");
    CHECK(agaaGlGetRequirements(&requirements));
    const EGLDisplay display = createDisplay(&requirements);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, NULL);
    glGenVertexArrays(1, &host.vertexArray);
    host.output = createOutput();
    createContext(&host);
    createPasses(&host);
    renderFrames(&host);
    glGetTextureImage(host.output, 0, GL_RGBA, GL_FLOAT, sizeof pixels, pixels);
    writeImage(arguments[1], pixels);
    destroy(&host);
    eglTerminate(display); /* takes the context along */
    return EXIT_SUCCESS;
}
