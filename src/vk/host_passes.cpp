#include "vk/host_passes.h"

#include "core/host_glsl.h"
#include "vk/formats.h"

#include <array>
#include <vector>

namespace agaa::vk {

namespace {

VkClearValue clearValue(const Plan& plan, Format format) {
    VkClearValue value{};
    if (isDepth(format))
        value.depthStencil = {plan.reversedZ ? 0.0f : 1.0f, 0};
    return value;
}

VkAttachmentDescription attachment(const Resource& resource, bool clear) {
    const bool depth = isDepth(resource.format);
    const VkAttachmentLoadOp load = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    const VkImageLayout layout = depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL
                                       : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    return {0,
            vkFormat(resource.format),
            VkSampleCountFlagBits(resource.samples),
            load,
            VK_ATTACHMENT_STORE_OP_STORE,
            hasStencil(resource.format) ? load : VK_ATTACHMENT_LOAD_OP_DONT_CARE,
            hasStencil(resource.format) ? VK_ATTACHMENT_STORE_OP_STORE
                                        : VK_ATTACHMENT_STORE_OP_DONT_CARE,
            layout,
            layout};
}

// The SDK's barriers stand outside, so that the pass itself needs no dependencies.
void createRenderPass(const Context& context, const Plan& plan, const Pass& pass,
                      const ViewResources& resources, HostPassObjects& objects) {
    std::vector<VkAttachmentDescription> attachments;
    std::vector<VkAttachmentReference> colors;
    std::vector<VkImageView> views;
    for (ResourceId target : pass.colorTargets) {
        colors.push_back(
            {uint32_t(attachments.size()), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
        attachments.push_back(attachment(plan.resources[target], pass.clearsColor));
        views.push_back(resources[target].attachmentView);
    }
    const VkAttachmentReference depth{uint32_t(attachments.size()),
                                      VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    attachments.push_back(attachment(plan.resources[pass.depthTarget], pass.clearsDepth));
    views.push_back(resources[pass.depthTarget].attachmentView);
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = uint32_t(colors.size());
    subpass.pColorAttachments = colors.data();
    subpass.pDepthStencilAttachment = &depth;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = uint32_t(attachments.size());
    info.pAttachments = attachments.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    check(context.vk.CreateRenderPass(context.device, &info, nullptr, &objects.renderPass),
          "vkCreateRenderPass");
    context.name(VK_OBJECT_TYPE_RENDER_PASS, (uint64_t)objects.renderPass, "agaa " + pass.name);
    VkFramebufferCreateInfo framebuffer{};
    framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    framebuffer.renderPass = objects.renderPass;
    framebuffer.attachmentCount = uint32_t(views.size());
    framebuffer.pAttachments = views.data();
    framebuffer.width = plan.resources[pass.depthTarget].width;
    framebuffer.height = plan.resources[pass.depthTarget].height;
    framebuffer.layers = 1;
    check(context.vk.CreateFramebuffer(context.device, &framebuffer, nullptr, &objects.framebuffer),
          "vkCreateFramebuffer");
    context.name(VK_OBJECT_TYPE_FRAMEBUFFER, (uint64_t)objects.framebuffer, "agaa " + pass.name);
}

VkRenderingAttachmentInfo renderingAttachment(const Plan& plan, const Pass& pass, ResourceId target,
                                              const ViewResources& resources) {
    const Format format = plan.resources[target].format;
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = resources[target].attachmentView;
    info.imageLayout = isDepth(format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL
                                       : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const bool clears = isDepth(format) ? pass.clearsDepth : pass.clearsColor;
    info.loadOp = clears ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = clearValue(plan, format);
    return info;
}

} // namespace

void createHostPass(const Context& context, const Plan& plan, const Pass& pass,
                    const ViewResources& resources, HostPassObjects& objects) {
    HostDialect dialect;
    objects.key = hostPassKey(plan, pass, dialect); // of any set: that is the pipeline layout's
    dialect.descriptorSet = context.descriptorSet;
    objects.extensions = hostExtensions(pass, dialect);
    objects.declarations = hostDeclarations(plan, pass, dialect);
    if (!context.dynamicRendering)
        createRenderPass(context, plan, pass, resources, objects);
}

void destroyHostPass(const Context& context, HostPassObjects& objects) {
    if (context.dynamicRendering)
        return;
    context.vk.DestroyFramebuffer(context.device, objects.framebuffer, nullptr);
    context.vk.DestroyRenderPass(context.device, objects.renderPass, nullptr);
}

void beginHostRendering(const Context& context, const Plan& plan, const Pass& pass,
                        const HostPassObjects& objects, const ViewResources& resources,
                        VkCommandBuffer commands, bool secondary) {
    const Resource& depthResource = plan.resources[pass.depthTarget];
    const VkRect2D area{{0, 0}, {depthResource.width, depthResource.height}};
    if (!context.dynamicRendering) {
        std::vector<VkClearValue> clears;
        for (ResourceId target : pass.colorTargets)
            clears.push_back(clearValue(plan, plan.resources[target].format));
        clears.push_back(clearValue(plan, depthResource.format));
        VkRenderPassBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
        info.renderPass = objects.renderPass;
        info.framebuffer = objects.framebuffer;
        info.renderArea = area;
        info.clearValueCount = uint32_t(clears.size());
        info.pClearValues = clears.data();
        context.vk.CmdBeginRenderPass(commands, &info,
                                      secondary ? VK_SUBPASS_CONTENTS_SECONDARY_COMMAND_BUFFERS
                                                : VK_SUBPASS_CONTENTS_INLINE);
        return;
    }
    std::vector<VkRenderingAttachmentInfo> colors;
    for (ResourceId target : pass.colorTargets)
        colors.push_back(renderingAttachment(plan, pass, target, resources));
    const VkRenderingAttachmentInfo depth =
        renderingAttachment(plan, pass, pass.depthTarget, resources);
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.flags = secondary ? VK_RENDERING_CONTENTS_SECONDARY_COMMAND_BUFFERS_BIT : 0;
    info.renderArea = area;
    info.layerCount = 1;
    info.colorAttachmentCount = uint32_t(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = &depth;
    info.pStencilAttachment = hasStencil(depthResource.format) ? &depth : nullptr;
    context.vk.CmdBeginRendering(commands, &info);
}

void endHostRendering(const Context& context, VkCommandBuffer commands) {
    if (context.dynamicRendering)
        context.vk.CmdEndRendering(commands);
    else
        context.vk.CmdEndRenderPass(commands);
}

void beginSecondary(const Context& context, const Plan& plan, const Pass& pass,
                    const HostPassObjects& objects, VkCommandBuffer commands) {
    const Format depth = plan.resources[pass.depthTarget].format;
    std::vector<VkFormat> colors;
    for (ResourceId target : pass.colorTargets)
        colors.push_back(vkFormat(plan.resources[target].format));
    VkCommandBufferInheritanceRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_RENDERING_INFO;
    rendering.colorAttachmentCount = uint32_t(colors.size());
    rendering.pColorAttachmentFormats = colors.data();
    rendering.depthAttachmentFormat = vkFormat(depth);
    rendering.stencilAttachmentFormat = hasStencil(depth) ? vkFormat(depth) : VK_FORMAT_UNDEFINED;
    rendering.rasterizationSamples = VkSampleCountFlagBits(plan.hwSamples);
    VkCommandBufferInheritanceInfo inheritance{};
    inheritance.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_INFO;
    inheritance.pNext = context.dynamicRendering ? &rendering : nullptr;
    inheritance.renderPass = objects.renderPass;
    inheritance.framebuffer = objects.framebuffer;
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT |
                 VK_COMMAND_BUFFER_USAGE_RENDER_PASS_CONTINUE_BIT;
    info.pInheritanceInfo = &inheritance;
    check(context.vk.BeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}

AgaaDrawTarget drawTarget(const Plan& plan, const Pass& pass, const HostPassObjects& objects,
                          VkCommandBuffer commands, VkDescriptorSet set) {
    const Resource& depth = plan.resources[pass.depthTarget];
    return {uint32_t(pass.drawPass), depth.width,  depth.height, plan.scaleX, plan.scaleY,
            pass.drawState,          objects.key, commands,     (uint64_t)set, 0, 0};
}

} // namespace agaa::vk
