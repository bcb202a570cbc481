// The GLSL that a host's shaders include for one draw pass, assembled from a plan.
#pragma once

#include "agaa_gl.h"
#include "core/frame/host_pass.h"
#include "core/plan/bindings.h"
#include "core/plan/plan.h"

#include <array>
#include <string>
#include <vector>

namespace agaa {

// The GLSL version and features of a host's shaders, and the bindings of the SDK's resources.
struct HostDialect {
    bool openGl = false;
    uint32_t glslVersion = 450;
    bool storageImages = false; // buffers are accessed as images
    bool hostOutputs = false;   // the host declares the outputs
    AgaaGlConstants constants = AGAA_GL_CONSTANTS_BLOCK;
    uint32_t descriptorSet = 0;                        // Vulkan: index of the SDK's set
    std::array<uint32_t, hostBindingCount> bindings{}; // OpenGL: by host_slot
    // The mask of a colour sample has depth samples that belong to it alone. It is for attachments with fewer samples
    // than depth.
    std::array<uint32_t, 4> colorSampleMasks{1, 2, 4, 8};
};

std::string hostExtensions(const Plan& plan, const Pass& pass, const HostDialect& dialect);
std::string hostDeclarations(const Plan& plan, const Pass& pass, const HostDialect& dialect);
// Return the text for the geometry shader and for the vertex shader, or empty text if the pass has none for it.
std::string hostGeometry(const Plan& plan, const Pass& pass, const HostDialect& dialect);
std::string hostVertex(const Plan& plan, const Pass& pass, const HostDialect& dialect);

// Returns a key that is equal for passes that can share the host's shaders and pipelines, and differs for others.
uint64_t hostPassKey(const Plan& plan, const Pass& pass, const HostDialect& dialect);

// Returns one element for each pass of the plan, by index. Elements of passes that the host does not draw are empty.
std::vector<HostPass> makeHostPasses(const Plan& plan, const HostDialect& dialect);

} // namespace agaa
