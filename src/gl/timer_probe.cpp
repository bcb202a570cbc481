#include "gl/timer_probe.h"

#include "core/base/error.h"
#include "gl/errors.h"
#include "gl/pass_clock.h"
#include "gl/program.h"
#include "gl/query_buffer.h"

#include <chrono>

namespace agaa::gl {

namespace {

// A compiler cannot shorten the work per fragment.
constexpr const char* fragmentText = R"(#version 430
layout(location = 0) uniform uint rounds;
layout(location = 0) out vec4 color;
void main() {
    uint x = uint(gl_FragCoord.x) * 747796405u + uint(gl_FragCoord.y);
    for (uint i = 0u; i < rounds; ++i)
        x = x * 747796405u + 2891336453u ^ x >> 7;
    color = vec4(x & 255u) / 255.0;
}
)";
constexpr GLsizei side = 256;

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

// The work is a draw because drivers that rasterise on the CPU defer draws, but not dispatches.
class Work {
public:
    explicit Work(const GladGLContext& context) : gl(context) {
        try {
            create();
        } catch (...) {
            destroy();
            throw;
        }
        gl.UseProgram(program);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        gl.BindVertexArray(vertexArray);
        gl.Viewport(0, 0, side, side);
        for (GLenum capability : {GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD,
                                  GL_BLEND, GL_SAMPLE_SHADING})
            gl.Disable(capability);
        GLint distances = 0; // enabled distances that the shader does not write are undefined
        gl.GetIntegerv(GL_MAX_CLIP_DISTANCES, &distances);
        for (GLint i = 0; i < distances; ++i)
            gl.Disable(GLenum(GL_CLIP_DISTANCE0 + i));
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    ~Work() { destroy(); }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    // Returns the milliseconds of the CPU's clock and those of the driver's timestamps.
    void run(GLuint rounds, uint32_t bits, double& clock, double& driver) {
        gl.ProgramUniform1ui(program, 0, rounds);
        gl.Finish();
        const auto begin = std::chrono::steady_clock::now();
        gl.QueryCounter(stamps[0], GL_TIMESTAMP);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        gl.QueryCounter(stamps[1], GL_TIMESTAMP);
        gl.Finish();
        clock = milliseconds(std::chrono::steady_clock::now() - begin);
        GLuint64 ticks[2] = {0, 0};
        for (int i = 0; i < 2; ++i)
            gl.GetQueryObjectui64v(stamps[i], GL_QUERY_RESULT, &ticks[i]);
        driver = millisecondsBetween(ticks[0], ticks[1], bits);
    }

private:
    void create() {
        program = linkProgram(gl, {{GL_VERTEX_SHADER, wholeTargetText}, {GL_FRAGMENT_SHADER, fragmentText}},
                              "the timer probe", AGAA_ERROR_UNSUPPORTED);
        gl.CreateTextures(GL_TEXTURE_2D, 1, &target);
        gl.TextureStorage2D(requireObject(gl, target, "glCreateTextures"), 1, GL_RGBA8, side, side);
        gl.CreateFramebuffers(1, &framebuffer);
        requireObject(gl, framebuffer, "glCreateFramebuffers");
        gl.NamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, target, 0);
        gl.CreateVertexArrays(1, &vertexArray);
        requireObject(gl, vertexArray, "glCreateVertexArrays");
        gl.CreateQueries(GL_TIMESTAMP, 2, stamps);
        requireObject(gl, stamps[0] != 0 ? stamps[1] : 0, "glCreateQueries");
        checkErrors(gl, "probing timestamps"); // nothing is drawn into a target without memory
    }
    void destroy() {
        gl.DeleteProgram(program);
        gl.DeleteFramebuffers(1, &framebuffer);
        gl.DeleteTextures(1, &target);
        gl.DeleteVertexArrays(1, &vertexArray);
        gl.DeleteQueries(2, stamps);
    }

    const GladGLContext& gl;
    GLuint program = 0;
    GLuint target = 0;
    GLuint framebuffer = 0;
    GLuint vertexArray = 0;
    GLuint stamps[2] = {0, 0};
};

} // namespace

static bool isAccurate(const GladGLContext& gl, uint32_t bits) {
    const NoQueryBuffer none(gl);
    Work work(gl);
    double clock = 0, driver = 0;
    work.run(1, bits, clock, driver); // includes compilation, so that its time is not used
    // The work grows until submission takes a negligible part of its time.
    for (GLuint rounds = 256; rounds <= 1u << 20; rounds *= 4) {
        work.run(rounds, bits, clock, driver);
        // The shortest of three runs is used: the system may have paused the others.
        for (int again = 0; clock >= 4.0 && again < 2; ++again) {
            double otherClock = 0, otherDriver = 0;
            work.run(rounds, bits, otherClock, otherDriver);
            if (otherClock < clock) {
                clock = otherClock;
                driver = otherDriver;
            }
        }
        if (clock >= 4.0)
            break;
    }
    return driver >= 0.5 * clock && driver <= 1.5 * clock;
}

bool probeTimer(const GladGLContext& gl, uint32_t bits) {
    try {
        return bits != 0 && isAccurate(gl, bits);
    } catch (const Error& error) {
        if (error.code != AGAA_ERROR_UNSUPPORTED)
            throw;
        return false; // the probe does not compile; the SDK works without timestamps
    }
}

} // namespace agaa::gl
