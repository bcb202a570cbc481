// Host passes: draw passes that the host records. A view keeps one HostPass for each of them.
#pragma once

#include "core/plan/plan.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace agaa {

// One colour attachment. Each layer of a colour target is an attachment of its own.
struct ColorAttachment {
    ResourceId resource = noResource;
    uint32_t layer = 0;
    Format format = Format::None;
    std::array<float, 4> clear{}; // read only if DrawPart::clearsColor
};

// Data of a host pass that does not depend on the graphics API. makeHostPasses() (core/glsl/host_glsl.h) creates it.
struct HostPass {
    uint64_t pipelineKey = 0;
    std::string extensions;   // GLSL
    std::string declarations; // GLSL
    std::string geometry;     // GLSL; empty unless the pass expands primitives in a geometry shader
    std::string vertex;       // GLSL; empty unless the pass pulls vertices
    // A fragment shader with the function of the host that the declarations contain. Backends compile it and do not use
    // it, so that its errors fail the view. Empty if there is no function.
    std::string functionCheck;
    std::string functionOrigin;          // the public member that holds the function, for messages
    std::vector<ColorAttachment> colors; // in the order of attachments
    Format depthFormat = Format::None;   // None if there is no depth attachment
    // The resources that the texts declare. The first agaaGetGlslResources() sets them.
    std::optional<std::vector<AgaaGlslResource>> resources;
};

std::vector<ColorAttachment> colorAttachments(const Plan& plan, const Pass& pass);

// Sets the pipeline key and the GLSL members. The pointers are valid as long as hostPass.
void describeHostPass(const HostPass& hostPass, AgaaDrawPass& out);

// Returns the texels of the pass's target that a frame of this size draws.
FrameExtent targetExtent(const Plan& plan, const Pass& pass, FrameExtent extent);

// Returns the draw callback's argument. Members that depend on the graphics API are 0: the backend sets them,
// and callDraw() sets the viewports.
AgaaDrawTarget drawTarget(const Plan& plan, const Step& step, const HostPass& hostPass, FrameExtent extent);

// Returns the viewports of a frame of this size: one for each layer of the target.
std::vector<AgaaViewport> viewports(const Plan& plan, const Pass& pass, FrameExtent extent);

// Calls the frame's draw callback with the viewports of a pass. A callback that throws counts as failed.
AgaaResult callDraw(const Plan& plan, const Pass& pass, const AgaaFrame& frame, AgaaDrawTarget target);

// Reports that the draw callback of a pass returned `returned`. consequence: the end of the sentence.
[[noreturn]] void failDraw(AgaaResult code, AgaaResult returned, const Pass& pass, const char* consequence);

} // namespace agaa
