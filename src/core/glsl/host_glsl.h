// The GLSL that a host's shaders include for one draw pass, assembled from a plan.
#pragma once

#include "core/frame/host_pass.h"
#include "core/plan/bindings.h"
#include "core/plan/plan.h"

#include <array>
#include <string>
#include <vector>

namespace agaa {

// What a host's shaders are written in and where it wants the SDK's resources.
struct HostDialect {
    bool openGl = false;
    uint32_t glslVersion = 450;
    bool storageImages = false; // buffers are reached as images
    bool hostOutputs = false;   // the host declares the outputs
    AgaaGlConstants constants = AGAA_GL_CONSTANTS_BLOCK;
    uint32_t descriptorSet = 0; // Vulkan: of the SDK's set
    std::array<uint32_t, hostBindingCount> bindings{}; // OpenGL: by host_slot
};

std::string hostExtensions(const Pass& pass, const HostDialect& dialect);
std::string hostDeclarations(const Plan& plan, const Pass& pass, const HostDialect& dialect);
// Of the geometry shader and of the vertex shader; empty where the pass has no text for them.
std::string hostGeometry(const Plan& plan, const Pass& pass, const HostDialect& dialect);
std::string hostVertex(const Plan& plan, const Pass& pass, const HostDialect& dialect);

// Differs between passes for which a host needs other shaders or pipelines, and only then.
uint64_t hostPassKey(const Plan& plan, const Pass& pass, const HostDialect& dialect);

// Returns one element for each pass of the plan, by index. Elements of passes that the host does not draw are empty.
std::vector<HostPass> makeHostPasses(const Plan& plan, const HostDialect& dialect);

} // namespace agaa
