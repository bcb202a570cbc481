// Host draws: what hosts must know to build pipelines, and how rendering begins and ends around them.
#pragma once

#include "core/plan/plan.h"
#include "vk/context.h"
#include "vk/resources.h"

#include <string>
#include <vector>

namespace agaa::vk {

struct HostPassObjects {
    uint64_t key = 0;
    std::string extensions;   // GLSL
    std::string declarations; // GLSL
    std::string geometry;     // GLSL, or empty
    std::string vertex;       // GLSL, or empty
    VkRenderPass renderPass = VK_NULL_HANDLE; // null with dynamic rendering, unless the shader reads attachments
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
};

std::vector<VkFormat> colorFormats(const Plan& plan, const Pass& pass); // of the attachments

// Fills objects as it goes, so that what was made before a failure is destroyed with them.
void createHostPass(const Context& context, const Plan& plan, const Pass& pass,
                    const ViewResources& resources, HostPassObjects& objects);
void destroyHostPass(const Context& context, HostPassObjects& objects);

void beginHostRendering(const Context& context, const Plan& plan, const Pass& pass,
                        const HostPassObjects& objects, const ViewResources& resources,
                        VkCommandBuffer commands, bool secondary);
void endHostRendering(const Context& context, const HostPassObjects& objects, VkCommandBuffer commands);
// Begins a secondary command buffer for use inside the pass's rendering.
void beginSecondary(const Context& context, const Plan& plan, const Pass& pass,
                    const HostPassObjects& objects, VkCommandBuffer commands);

AgaaDrawTarget drawTarget(const Plan& plan, const Pass& pass, const HostPassObjects& objects,
                          VkCommandBuffer commands, VkDescriptorSet set);

} // namespace agaa::vk
