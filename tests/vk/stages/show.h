// Shots by the Vulkan host.
#pragma once

#include "shown.h"
#include "stage_host.h"

namespace agaa::test {

Shown show(StageContext& context, ViewSettings settings, const Shot& shot);

struct VulkanHost {
    using Context = StageContext;
    using View = StageView;
    static std::vector<float> rgba(const View& view) { return withAlpha(view.image().rgb); }
};

// By render passes, and callbacks that record into the host's command buffer.
struct RenderPassContext : StageContext {
    RenderPassContext() : StageContext({.renderPass = true, .inlineRecording = true}) {}
};
struct VulkanRenderPassHost {
    using Context = RenderPassContext;
    using View = StageView;
    static std::vector<float> rgba(const View& view) { return VulkanHost::rgba(view); }
};

} // namespace agaa::test
