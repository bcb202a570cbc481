// An OpenGL context of its own, without a window system.
#pragma once

#include <glad/gl.h>

#include <string>
#include <vector>

namespace agaa::test {

struct EglContextDesc {
    bool compatibility = false; // profile
    int major = 4, minor = 5;   // drivers may give a later one
    bool debug = true;
};

// Current in the thread that made it, until another is made current. Throws std::runtime_error.
class EglContext {
public:
    explicit EglContext(const EglContextDesc& desc = {});
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void makeCurrent() const;
    const GladGLContext& gl() const { return gl_; }
    bool compatibility() const { return compatibility_; }
    // What an AgaaGlGetProcAddr with any user pointer does.
    static void (*getProcAddr(void* user, const char* name))();

    // Debug messages of medium or higher severity, but for those on performance, and errors since the
    // last call, a line each: empty in a test that passes.
    std::string takeMessages();

private:
    void* display_;
    void* context_;
    bool compatibility_;
    GladGLContext gl_{};
    std::vector<std::string> messages_;
};

} // namespace agaa::test
