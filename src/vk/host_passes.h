// Rendering of host passes: render passes, framebuffers and dynamic rendering.
#pragma once

#include "core/frame/host_pass.h"
#include "vk/context.h"
#include "vk/resources.h"

namespace agaa::vk {

// Both handles are null with dynamic rendering, unless the shader reads attachments.
struct HostRenderTarget {
    VkRenderPass renderPass = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
};

// Sets each handle of `out` as soon as it exists: after a failure destroyHostRenderTarget() destroys what was created.
void createHostRenderTarget(const Context& context, const Plan& plan, const Pass& pass, const HostPass& hostPass,
                            const ViewResources& resources, HostRenderTarget& out);
void destroyHostRenderTarget(const Context& context, HostRenderTarget& target);

void beginHostRendering(const Context& context, const Pass& pass, FrameExtent extent, const HostPass& hostPass,
                        const HostRenderTarget& target, const ViewResources& resources, VkCommandBuffer commands);
void endHostRendering(const Context& context, const HostRenderTarget& target, VkCommandBuffer commands);
// Begins a secondary command buffer for use inside the pass's rendering.
// repeats   A frame executes it more than once.
void beginSecondary(const Context& context, const Pass& pass, const HostPass& hostPass, const HostRenderTarget& target,
                    bool repeats, VkCommandBuffer commands);

} // namespace agaa::vk
