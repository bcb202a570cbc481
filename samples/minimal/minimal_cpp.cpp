/* The smallest OpenGL host in C++, with agaa_gl.hpp: renders what minimal_gl.c renders.
 *   minimal_cpp image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "agaa_gl.hpp"
#include "gl_draw_state.h"

#include <string>

/* Returns the value of a result, or ends the program. An engine would return the code. */
template <class T> static T need(agaa::Result<T> result, const std::string& call) {
    require(result.hasValue(), (call + " failed: " + std::string(agaa::resultString(result.code())) + ".").c_str());
    return std::move(*result);
}

/* Receives the SDK's messages. */
struct Log {
    void operator()(AgaaSeverity severity, AgaaResult, std::string_view message) const noexcept {
        if (severity >= AGAA_SEVERITY_ERROR)
            fprintf(stderr, "%s\n", message.data());
    }
};

/* Members are destroyed from the last to the first: the view before its context, the context before the sink of its
 * log. */
struct Host {
    agaa::LogSink<Log> log{Log{}};
    agaa::Context context;
    agaa::View view;
    std::vector<AgaaDrawPass> passes;
    std::vector<GLuint> programs;
    GLuint vertexArray = 0, output = 0;
    AgaaFrame frame = agaa::init<AgaaFrame>();
    /* Draws the scene in the pass of a target. The SDK calls it through AgaaFrame::draw. */
    AgaaResult operator()(const AgaaDrawTarget* target) noexcept;
};

static void beginContext(Host& host) {
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    AgaaGlDeviceDesc device = agaa::init<AgaaGlDeviceDesc>();
    device.getProcAddr = getProcAddr;
    desc.log = host.log.get();
    desc.framesInFlight = 1; /* the host waits for each frame */
    host.context = need(agaa::gl::createContext(agaa::chain(desc, device)), "createContext");
}

static void beginView(Host& host) {
    AgaaViewDesc view = describeView();
    view.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; /* the host does not call glClipControl */
    host.view = need(agaa::gl::createView(host.context.get(), view), "createView");
    host.passes = need(agaa::getDrawPasses(host.view.get()), "getDrawPasses");
    for (const AgaaDrawPass& pass : host.passes)
        host.programs.push_back(createProgram(pass.glslExtensions, pass.glslDeclarations, vertexCode, materialCode));
}

AgaaResult Host::operator()(const AgaaDrawTarget* target) noexcept {
    size_t pass = 0;
    while (passes[pass].pipelineKey != target->pipelineKey)
        if (++pass == passes.size())
            return AGAA_ERROR_CALLBACK;
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, static_cast<GLsizei>(target->width), static_cast<GLsizei>(target->height));
    setState(&target->state);
    glUseProgram(programs[pass]);
    glUniformMatrix4fv(0, 1, GL_FALSE, frame.projection);
    glBindVertexArray(vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
    return AGAA_OK;
}

static void renderFrames(Host& host) {
    AgaaGlFrame glFrame = agaa::init<AgaaGlFrame>();
    glFrame.outputTexture = host.output;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        host.frame = describeFrame(i, -1.0f);
        agaa::bind(host.frame.draw, host.frame.drawUser, host);
        CHECK(agaa::gl::recordFrame(host.view.get(), host.frame, glFrame));
        glFinish();
        reportFrame(host.view.get(), i);
    }
}

int main(int argumentCount, char** arguments) {
    require(argumentCount == 2, "Usage: minimal_cpp IMAGE.ppm");
    const EGLDisplay display = beginOpenGl();
    {
        Host host; /* ends while the OpenGL context is current */
        glGenVertexArrays(1, &host.vertexArray);
        host.output = createOutput();
        beginContext(host);
        beginView(host);
        renderFrames(host);
        writeOutput(host.output, arguments[1]);
        for (const GLuint program : host.programs)
            glDeleteProgram(program);
        glDeleteVertexArrays(1, &host.vertexArray);
        glDeleteTextures(1, &host.output);
    }
    eglTerminate(display); /* this also destroys the OpenGL context */
    return EXIT_SUCCESS;
}
