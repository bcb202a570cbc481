#include "gl/timer_probe.h"

#include "gl/program.h"
#include "gl/query_buffer.h"

#include <chrono>

namespace agaa::gl {

namespace {

// Work that the compiler cannot shorten, as long as asked for.
constexpr const char* workText = R"(#version 430
layout(local_size_x = 64) in;
layout(location = 0) uniform uint rounds;
layout(std430, binding = 0) buffer Sink { uint sink[]; };
void main() {
    uint x = gl_GlobalInvocationID.x;
    for (uint i = 0u; i < rounds; ++i)
        x = x * 747796405u + 2891336453u ^ x >> 7;
    sink[gl_GlobalInvocationID.x] = x;
}
)";
constexpr GLuint groups = 64;

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

struct Work {
    explicit Work(const GladGLContext& context) : gl(context), program(compileCompute(context, workText, "timer probe")) {
        gl.CreateBuffers(1, &sink);
        gl.NamedBufferData(sink, 64 * groups * sizeof(GLuint), nullptr, GL_STATIC_DRAW);
        gl.CreateQueries(GL_TIMESTAMP, 2, stamps);
    }
    ~Work() {
        gl.DeleteProgram(program);
        gl.DeleteBuffers(1, &sink);
        gl.DeleteQueries(2, stamps);
    }
    // By the CPU's clock and by the driver's timestamps.
    void run(GLuint rounds, double& clock, double& driver) {
        gl.UseProgram(program);
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sink);
        gl.ProgramUniform1ui(program, 0, rounds);
        gl.Finish();
        const auto begin = std::chrono::steady_clock::now();
        gl.QueryCounter(stamps[0], GL_TIMESTAMP);
        gl.DispatchCompute(groups, 1, 1);
        gl.QueryCounter(stamps[1], GL_TIMESTAMP);
        gl.Finish();
        clock = milliseconds(std::chrono::steady_clock::now() - begin);
        GLuint64 ticks[2] = {0, 0};
        for (int i = 0; i < 2; ++i)
            gl.GetQueryObjectui64v(stamps[i], GL_QUERY_RESULT, &ticks[i]);
        driver = double(ticks[1] - ticks[0]) * 1e-6;
    }

    const GladGLContext& gl;
    GLuint program = 0;
    GLuint sink = 0;
    GLuint stamps[2] = {0, 0};
};

} // namespace

bool probeTimer(const GladGLContext& gl) {
    GLint bits = 0;
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0)
        return false;
    const NoQueryBuffer none(gl);
    Work work(gl);
    double clock = 0, driver = 0;
    work.run(1, clock, driver); // compiles
    // Long enough for submission not to matter; what a driver takes for it grows until it is.
    for (GLuint rounds = 1024; rounds <= 1u << 24; rounds *= 4) {
        work.run(rounds, clock, driver);
        if (clock >= 4.0)
            break;
    }
    return driver >= 0.5 * clock && driver <= 1.5 * clock;
}

} // namespace agaa::gl
