/* The smallest host that draws its own multisampled G-buffer: the SDK reads it, aggregates and shades.
 *   gbuffer_gl image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gl.h"

enum { samples = 4, firstUnit = 20, textureCount = 3 }; /* texture units from 17 are the host's */

typedef struct Host {
    AgaaContext context;
    AgaaView view;
    GLuint textures[textureCount]; /* diffuse, normal, depth */
    GLuint framebuffer, program, vertexArray, output;
} Host;

/* The G-buffer pass is the host's alone: no declarations of the SDK's, any layout, any state. */
static const char gbufferCode[] =
    "layout(location = 1) flat in vec3 color;\n"
    "layout(location = 0) out vec4 diffuse;\n"
    "layout(location = 1) out vec4 normal; // w: there is geometry\n"
    "void main() {\n"
    "    diffuse = vec4(color, 0.0);\n"
    "    normal = vec4(0.0, 0.0, 1.0, 1.0); // the blades face the camera\n"
    "}\n";

/* How the SDK's passes read a sample of it. */
static const char sampleCode[] =
    "layout(binding = 20) uniform sampler2DMS diffuse;\n"
    "layout(binding = 21) uniform sampler2DMS normal;\n"
    "layout(binding = 22) uniform sampler2DMS depth;\n"
    "bool agaaHostSample(uvec2 pixel, uint i, inout float z, inout AgaaMaterial m) {\n"
    "    vec4 n = texelFetch(normal, ivec2(pixel), int(i));\n"
    "    z = texelFetch(depth, ivec2(pixel), int(i)).x;\n"
    "    m.diffuse = texelFetch(diffuse, ivec2(pixel), int(i)).rgb;\n"
    "    m.normal = n.xyz;\n"
    "    return n.w > 0.0;\n"
    "}\n";

static void createGBuffer(Host* host) {
    static const GLenum formats[textureCount] = {GL_RGBA8, GL_RGBA16F, GL_DEPTH_COMPONENT32F};
    static const GLenum attachments[textureCount] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT};
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, textureCount, host->textures);
    glCreateFramebuffers(1, &host->framebuffer);
    for (int i = 0; i < textureCount; ++i) {
        glTextureStorage2DMultisample(host->textures[i], samples, formats[i], width, height, GL_TRUE);
        glNamedFramebufferTexture(host->framebuffer, attachments[i], host->textures[i], 0);
        glBindTextureUnit((GLuint)(firstUnit + i), host->textures[i]);
    }
    glNamedFramebufferDrawBuffers(host->framebuffer, 2, attachments);
    require(glCheckNamedFramebufferStatus(host->framebuffer, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
            "The G-buffer cannot be drawn to.");
    host->program = createProgram("", "", gbufferCode);
}

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaConfig config = *desc.config;
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    config.samples = samples;
    function.glsl = sampleCode;
    desc.config = &config;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* glClipControl was not called */
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
        const AgaaFrame frame = describeFrame(i, -1.0f); /* draw stays null: nothing is asked back */
        drawGBuffer(host, &frame);
        CHECK(agaaGlRecordFrame(host->view, &frame, &glFrame));
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
    glDeleteFramebuffers(1, &host->framebuffer);
    glDeleteTextures(textureCount, host->textures);
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
    eglTerminate(display); /* takes the context along */
    return EXIT_SUCCESS;
}
