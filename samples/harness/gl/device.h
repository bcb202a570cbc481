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
    // Throws std::runtime_error "OpenGL could not <what>: <error>." if a call failed. Without validation, nothing else
    // reports it.
    void checkErrors(const char* what) const;
    // Throws the same error for sizes that textures cannot have.
    void checkTextureSize(uint32_t width, uint32_t height) const;
    std::vector<ApiMessage> takeMessages() { return messages_.take(); }

    // The callback for AgaaGlDeviceDesc.
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
