// The SDK inside one host OpenGL context.
#pragma once

#include "agaa_gl.h"
#include "core/abi/handles.h"
#include "core/glsl/host_glsl.h"
#include "gl/host_bindings.h"
#include "gl/program_cache.h"
#include "gl/state_guard.h"

#include <glad/gl.h>

#include <optional>

namespace agaa::gl {

// Functions of the current context. Throws AGAA_ERROR_UNSUPPORTED where there is none or it is too old.
GladGLContext loadFunctions(AgaaGlGetProcAddr getProcAddr, void* user);
AgaaDeviceCaps queryCaps(const GladGLContext& gl);

class Context : public AgaaContext_T {
public:
    // cache: the host's, or none.
    Context(const AgaaContextDesc& common, const AgaaGlDeviceDesc& desc, const std::optional<AgaaGlProgramCache>& cache);
    ~Context() override;

    void label(GLenum kind, GLuint name, const std::string& text) const;
    // Tells the log about errors of the host's that would be taken for ours. One of the kind given is ours.
    void takeHostErrors(const char* call, GLenum ours = GL_NO_ERROR) const;
    // Throws where a call of ours since takeHostErrors() failed.
    void checkErrors(const char* what) const;

    GladGLContext gl{};
    HostDialect dialect;
    AgaaGlStatePolicy statePolicy;
    AgaaGlStateCallback pushState;
    AgaaGlStateCallback popState;
    void* stateUser;
    std::optional<StateGuard> guard; // of all that frames touch
    std::optional<HostBindings> hostBindings; // with AGAA_GL_STATE_CALLBACKS
    AgaaTimeSource timeSource = AGAA_TIME_DEVICE;
    uint32_t timestampBits = 64; // of the driver's counter
    GLuint shadowSampler = 0;
    GLuint linearSampler = 0;
    GLuint texelSampler = 0; // for textures of the host, whose own filter may need mip levels
    GLuint noTarget = 0;     // framebuffer without images: what is fetched from must not be drawn into (4.5, 9.3.1)
    GLint maxDebugGroups = 0; // of the context's stack
    ProgramCache programs;   // kept where the host keeps them
    bool keepsPrograms = false;
    std::vector<uint32_t> binaryFormats; // that the driver loads
    GLuint noShadow = 0;     // where a frame has no map at all: binding 0 to a unit unbinds all its targets

private:
    void createObjects();
    void destroyObjects();
};

} // namespace agaa::gl
