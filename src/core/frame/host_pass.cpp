#include "core/frame/host_pass.h"

#include "core/base/callbacks.h"
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "core/plan/sample_patterns.h"

namespace agaa {

std::vector<ColorAttachment> colorAttachments(const Plan& plan, const Pass& pass) {
    std::vector<ColorAttachment> attachments;
    for (size_t i = 0; i < pass.draw().colorTargets.size(); ++i) {
        const ResourceId target = pass.draw().colorTargets[i];
        for (uint32_t layer = 0; layer < plan.resources[target].layers; ++layer)
            attachments.push_back({target, layer, plan.resources[target].format, pass.draw().clear.color.at(i)});
    }
    return attachments;
}

static const char* textOrNull(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }

void describeHostPass(const HostPass& hostPass, AgaaDrawPass& out) {
    out.pipelineKey = hostPass.pipelineKey;
    out.glslExtensions = hostPass.extensions.c_str();
    out.glslDeclarations = hostPass.declarations.c_str();
    out.glslGeometry = textOrNull(hostPass.geometry);
    out.glslVertex = textOrNull(hostPass.vertex);
}

FrameExtent targetExtent(const Plan& plan, const Pass& pass, FrameExtent extent) {
    return {pass.draw().width / plan.view.width * extent.width, pass.draw().height / plan.view.height * extent.height};
}

AgaaDrawTarget drawTarget(const Plan& plan, const Step& step, const HostPass& hostPass, FrameExtent extent) {
    const Pass& pass = plan.passes[step.pass];
    AgaaDrawTarget target{};
    target.sType = AGAA_STRUCTURE_TYPE_DRAW_TARGET;
    target.structSize = sizeof target;
    target.pass = pass.draw().id;
    const FrameExtent texels = targetExtent(plan, pass, extent);
    target.width = texels.width;
    target.height = texels.height;
    target.scaleX = plan.view.scaleX;
    target.scaleY = plan.view.scaleY;
    target.state = pass.draw().state;
    target.pipelineKey = hostPass.pipelineKey;
    target.batch = step.batch;
    return target;
}

// A layer shows at the centre of its texels another point of the pixels, so that its viewport moves by the difference.
std::vector<AgaaViewport> viewports(const Plan& plan, const Pass& pass, FrameExtent extent) {
    const FrameExtent texels = targetExtent(plan, pass, extent);
    const uint32_t height = texels.height / plan.view.layers;
    std::vector<AgaaViewport> list;
    for (const SamplePosition& centre : layerCentres(plan.view)) {
        const uint32_t top = uint32_t(list.size()) * height;
        list.push_back({0.5f - centre.x, float(top) + 0.5f - centre.y, float(texels.width), float(height), 0, top,
                        texels.width, height});
    }
    return list;
}

AgaaResult callDraw(const Plan& plan, const Pass& pass, const AgaaFrame& frame, AgaaDrawTarget target) {
    const std::vector<AgaaViewport> list = viewports(plan, pass, extentOf(frame, plan));
    target.viewports = list.data();
    target.viewportCount = uint32_t(list.size());
    return contained([&] { return frame.draw(frame.drawUser, &target); });
}

void failDraw(AgaaResult code, AgaaResult returned, const Pass& pass, const char* consequence) {
    fail(code,
         format("the draw callback returned %d in pass \"%s\"; %s.", int(returned), pass.name.c_str(), consequence));
}

} // namespace agaa
