// The SDK's state for one OpenGL context of the host.
#pragma once

#include "agaa_gl.h"
#include "core/abi/handles.h"
#include "core/glsl/host_glsl.h"
#include "gl/buffer_fill.h"
#include "gl/host_bindings.h"
#include "gl/program_cache.h"
#include "gl/state_guard.h"

#include <glad/gl.h>

#include <array>
#include <optional>

namespace agaa::gl {

// Loads the functions of the current context. Throws AGAA_ERROR_UNSUPPORTED if no context is current or its version is
// too low.
GladGLContext loadFunctions(AgaaGlGetProcAddr getProcAddr, void* user);
// Returns glGetString(); an empty text if the context is lost.
std::string textOf(const GladGLContext& gl, GLenum name);
AgaaDeviceCaps queryCaps(const GladGLContext& gl);

class Context : public AgaaContext_T {
public:
    // cache: bytes of an earlier run that the host stored, if any.
    Context(const AgaaContextDesc& common, const AgaaGlDeviceDesc& desc,
            const std::optional<AgaaGlProgramCache>& cache);
    ~Context() override;

    void label(GLenum kind, GLuint name, const std::string& text) const;
    // Logs and clears pending errors of the host. One error of the kind `ours` is cleared without a message.
    void clearHostErrors(const char* call, GLenum ours = GL_NO_ERROR) const;
    // Throws if the OpenGL context is lost or not current. A lost context stays lost: some report it only once.
    void requireAlive();
    // Throws if an OpenGL call since clearHostErrors() failed.
    void checkErrors(const char* what) const;

    // Returns HostDialect::colorSampleMasks of framebuffers with these numbers of samples. Throws
    // AGAA_ERROR_UNSUPPORTED if a colour sample has no coverage sample of its own.
    std::array<uint32_t, 4> colorSampleMasks(uint32_t samples, uint32_t colorSamples);

    GladGLContext gl{};
    HostDialect dialect;
    AgaaGlStatePolicy statePolicy;
    AgaaGlStateCallback pushState;
    AgaaGlStateCallback popState;
    void* stateUser;
    std::optional<StateGuard> guard;          // of all states that frames change
    std::optional<HostBindings> hostBindings; // with AGAA_GL_STATE_CALLBACKS
    std::optional<BufferFill> bufferFill;
    AgaaTimeSource timeSource = AGAA_TIME_DEVICE;
    uint32_t timestampBits = 64; // width of the driver's counter
    GLuint shadowSampler = 0;
    GLuint linearSampler = 0;
    GLuint texelSampler = 0;     // for host textures, whose filter may need mip levels
    GLuint emptyFramebuffer = 0; // has no images: passes must not fetch from the bound framebuffer (OpenGL 4.5, 9.3.1)
    GLint maxDebugGroups = 0;    // depth of the context's stack
    ProgramCache programs;       // filled if keepsPrograms
    bool keepsPrograms = false;  // the host stores the cache
    std::vector<uint32_t> binaryFormats; // formats that the driver loads
    GLuint emptyShadowMap = 0; // bound if a frame has no shadow map: binding 0 would unbind all targets of the unit

private:
    void createObjects();
    void createFill(); // clears by the API if the driver does not compile the shader
    void destroyObjects();

    bool notifiesReset_ = false; // the context was created with GL_LOSE_CONTEXT_ON_RESET
    bool isLost_ = false;
};

} // namespace agaa::gl
