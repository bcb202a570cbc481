// A compute program, in groups of 8 x 8.
#pragma once

#include <glad/gl.h>

#include <gtest/gtest.h>

#include <string>

namespace agaa::test {

class ComputePass {
public:
    ComputePass(const GladGLContext& gl, const std::string& text) : gl_(gl) {
        const char* source = text.c_str();
        program_ = gl.CreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
        char log[2048] = "";
        gl.GetProgramInfoLog(program_, sizeof log, nullptr, log);
        GLint linked = 0;
        gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
        EXPECT_TRUE(linked) << log;
    }
    ~ComputePass() { gl_.DeleteProgram(program_); }
    ComputePass(const ComputePass&) = delete;
    ComputePass& operator=(const ComputePass&) = delete;

    void run(uint32_t width, uint32_t height) const {
        gl_.MemoryBarrier(GL_ALL_BARRIER_BITS);
        gl_.UseProgram(program_);
        gl_.DispatchCompute((width + 7) / 8, (height + 7) / 8, 1);
        gl_.MemoryBarrier(GL_ALL_BARRIER_BITS);
        gl_.UseProgram(0);
    }

private:
    const GladGLContext& gl_;
    GLuint program_ = 0;
};

} // namespace agaa::test
