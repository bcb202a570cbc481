/* The parts that the minimal OpenGL hosts share: a context without a window, the SDK's context, programs and the
 * output.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#define GL_GLEXT_PROTOTYPES
#include "agaa_gl.h"
#include "host.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

/* Returns the display of the first device that EGL lists (Mesa lists its software rasteriser last), else the
 * surfaceless one. */
static EGLDisplay findDisplay(void) {
    const PFNEGLQUERYDEVICESEXTPROC queryDevices = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    EGLDeviceEXT device;
    EGLint count = 0;
    const EGLBoolean isNamed = queryDevices && queryDevices(1, &device, &count) && count > 0;
    const EGLDisplay display = isNamed ? eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, NULL) : EGL_NO_DISPLAY;
    return eglInitialize(display, NULL, NULL)
               ? display
               : eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
}

/* Creates a context without a window, of the version that needs no extensions for the SDK. */
static EGLDisplay createDisplay(const AgaaGlRequirements* sdk) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 (EGLint)sdk->completeMajorVersion,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 (EGLint)sdk->completeMinorVersion,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    const EGLDisplay display = findDisplay();
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

/* Creates a context and makes it current. Debug messages of errors end the program. */
static EGLDisplay beginOpenGl(void) {
    AgaaGlRequirements requirements = AGAA_GL_REQUIREMENTS_INIT;
    CHECK(agaaGlGetRequirements(&requirements));
    const EGLDisplay display = createDisplay(&requirements);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, NULL);
    return display;
}

static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name) {
    (void)user;
    return (AgaaGlFunction)eglGetProcAddress(name);
}

static AgaaContext createContext(void) {
    AgaaLog log = AGAA_LOG_INIT;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    AgaaGlDeviceDesc device = AGAA_GL_DEVICE_DESC_INIT;
    AgaaContext context;
    log.callback = onLog;
    device.getProcAddr = getProcAddr;
    device.glslVersion = 450;
    device.statePolicy = AGAA_GL_STATE_RESTORE;
    desc.pNext = &device, desc.log = &log;
    desc.framesInFlight = 1; /* the hosts wait for each frame */
    CHECK(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context));
    return context;
}

static void attach(GLuint program, GLenum stage, const char* extensions, const char* declarations, const char* code) {
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
    glDeleteShader(shader); /* the program keeps the shader */
}

/* vertices   code of the vertex shader, which all passes share
 * materials  code of the fragment shader */
static GLuint createProgram(const char* extensions, const char* declarations, const char* vertices,
                            const char* materials) {
    const GLuint program = glCreateProgram();
    GLint isLinked;
    attach(program, GL_VERTEX_SHADER, "#define VERTEX gl_VertexID\n",
           "layout(location = 0) uniform mat4 clipFromShading;\n", vertices);
    attach(program, GL_FRAGMENT_SHADER, extensions, declarations, materials);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    require(isLinked, "A program does not link.");
    return program;
}

static GLuint createOutput(void) {
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA32F, width, height);
    return texture;
}

static void writeOutput(GLuint output, const char* path) {
    static float pixels[4 * width * height];
    glGetTextureImage(output, 0, GL_RGBA, GL_FLOAT, sizeof pixels, pixels);
    writeImage(path, pixels);
}
