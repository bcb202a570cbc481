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

enum { maxPasses = 4 };

typedef struct Pass {
    uint64_t key;
    GLuint program;
} Pass;

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    Pass passes[maxPasses];
    uint32_t passCount;
    GLuint vertexArray, output;
    float clipFromShading[16];
} Host;

/* [requirements] */
/* A context that needs no window, of the version that has all the SDK asks for. */
static EGLDisplay createDisplay(const AgaaGlRequirements* sdk) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, (EGLint)sdk->completeMajorVersion,
                                 EGL_CONTEXT_MINOR_VERSION, (EGLint)sdk->completeMinorVersion,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLContext context;
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
        fail("EGL offers no OpenGL without a window.");
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        fail("There is no OpenGL %u.%u.", sdk->completeMajorVersion, sdk->completeMinorVersion);
    return display;
}
/* [/requirements] */

static void APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                               const GLchar* message, const void* user) {
    (void)source, (void)id, (void)severity, (void)length, (void)user;
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
        fail("OpenGL reports: %s", message);
}

/* [context] */
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
    checkSdk(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &host->context), "agaaGlCreateContext");
}
/* [/context] */

/* [view] */
static void createView(Host* host) {
    const AgaaConfig config = sceneConfig();
    const AgaaSceneFacts facts = sceneFacts();
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT;
    desc.width = width;
    desc.height = height;
    desc.config = &config;
    desc.facts = &facts;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* glClipControl was not called */
    checkSdk(agaaGlGetContextCaps(host->context, &caps), "agaaGlGetContextCaps");
    checkSdk(agaaQueryMemory(&desc, &caps, NULL, &memory, NULL, NULL), "agaaQueryMemory");
    printf("%s: %.0f bytes per pixel\n", caps.deviceName, memory.bytesPerPixel);
    checkSdk(agaaGlCreateView(host->context, &desc, &host->view), "agaaGlCreateView");
}
/* [/view] */

/* [compile] */
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
    if (!isCompiled)
        fail("A shader does not compile: %s", message);
    glAttachShader(program, shader);
    glDeleteShader(shader); /* goes with the program */
}
/* [/compile] */

/* [passes] */
static Pass createPass(const AgaaGlDrawPass* sdk) {
    const Pass pass = {sdk->pipelineKey, glCreateProgram()};
    GLint isLinked;
    attach(pass.program, GL_VERTEX_SHADER, "#define VERTEX gl_VertexID\n",
           "layout(location = 0) uniform mat4 clipFromShading;\n", vertexCode);
    attach(pass.program, GL_FRAGMENT_SHADER, sdk->glslExtensions, sdk->glslDeclarations, materialCode);
    glLinkProgram(pass.program);
    glGetProgramiv(pass.program, GL_LINK_STATUS, &isLinked);
    if (!isLinked)
        fail("The program of the pass \"%s\" does not link.", sdk->name);
    return pass;
}

static void createPasses(Host* host) {
    AgaaGlDrawPass passes[maxPasses] = {AGAA_GL_DRAW_PASS_INIT, AGAA_GL_DRAW_PASS_INIT,
                                        AGAA_GL_DRAW_PASS_INIT, AGAA_GL_DRAW_PASS_INIT};
    uint32_t i;
    host->passCount = maxPasses;
    checkSdk(agaaGlGetDrawPasses(host->view, &host->passCount, passes), "agaaGlGetDrawPasses");
    for (i = 0; i < host->passCount; ++i)
        host->passes[i] = createPass(&passes[i]);
}
/* [/passes] */

/* [state] */
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
/* [/state] */

/* [draw] */
static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = (const Host*)user;
    const Pass* pass = host->passes;
    while (pass->key != target->pipelineKey)
        if (++pass == host->passes + host->passCount)
            return AGAA_ERROR_CALLBACK;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
    setState(&target->state);
    glUseProgram(pass->program);
    glUniformMatrix4fv(0, 1, GL_FALSE, host->clipFromShading);
    glBindVertexArray(host->vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
    return AGAA_OK;
}
/* [/draw] */

/* [frames] */
static void renderFrame(Host* host, uint64_t frameIndex) {
    AgaaFrame frame = sceneFrame(-1.0f);
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    memcpy(host->clipFromShading, frame.projection, sizeof host->clipFromShading);
    frame.frameIndex = frameIndex;
    frame.completedFrame = frameIndex - 1; /* the one before has been waited for */
    frame.draw = draw;
    frame.drawUser = host;
    glFrame.outputTexture = host->output;
    checkSdk(agaaGlRecordFrame(host->view, &frame, &glFrame), "agaaGlRecordFrame");
    glFinish();
    reportFrame(host->view, frameIndex);
}
/* [/frames] */

/* [output] */
static GLuint createOutput(void) {
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA32F, width, height);
    return texture;
}
/* [/output] */

/* [destroy] */
/* The context is still current. */
static void destroy(Host* host) {
    uint32_t i;
    agaaDestroyView(host->view);
    agaaDestroyContext(host->context);
    for (i = 0; i < host->passCount; ++i)
        glDeleteProgram(host->passes[i].program);
    glDeleteVertexArrays(1, &host->vertexArray);
    glDeleteTextures(1, &host->output);
}
/* [/destroy] */

int main(int argumentCount, char** arguments) {
    static float pixels[4 * width * height];
    AgaaGlRequirements requirements = AGAA_GL_REQUIREMENTS_INIT;
    Host host = {0};
    EGLDisplay display;
    uint64_t i;
    if (argumentCount != 2)
        fail("Usage: minimal_gl IMAGE.ppm");
    checkSdk(agaaGlGetRequirements(&requirements), "agaaGlGetRequirements");
    display = createDisplay(&requirements);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, NULL);
    glGenVertexArrays(1, &host.vertexArray);
    host.output = createOutput();
    createContext(&host);
    createView(&host);
    createPasses(&host);
    for (i = 1; i <= frameCount; ++i)
        renderFrame(&host, i);
    glGetTextureImage(host.output, 0, GL_RGBA, GL_FLOAT, sizeof pixels, pixels);
    writeImage(arguments[1], pixels);
    destroy(&host);
    eglTerminate(display); /* takes the context along */
    return EXIT_SUCCESS;
}
