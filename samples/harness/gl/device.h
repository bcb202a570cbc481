// The sample engine's OpenGL context: EGL without a surface, so that no window system is needed.
#pragma once

#include "agaa_gl.h"
#include "render/messages.h"

#include <glad/gl.h>

namespace harness::gl {

class Device {
public:
    explicit Device(const RendererOptions& options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const GladGLContext& gl() const { return gl_; }
    void makeCurrent() const;
    std::vector<ApiMessage> takeMessages() { return messages_.take(); }

    // For AgaaGlContextDesc.
    static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name);

private:
    void createContext(const RendererOptions& options);
    void destroy();

    MessageCollector messages_;
    void* display_ = nullptr; // EGLDisplay
    void* context_ = nullptr; // EGLContext
    GladGLContext gl_{};
};

} // namespace harness::gl
