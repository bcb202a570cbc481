#include "vk/host_passes.h"

#include "vk/formats.h"

#include <algorithm>
#include <array>
#include <vector>

namespace agaa::vk {

namespace {

VkClearValue depthClear(const Pass& pass) {
    VkClearValue value{};
    value.depthStencil = {pass.draw().clear.depth, pass.draw().clear.stencil};
    return value;
}

VkClearValue colorClear(const ColorAttachment& color) {
    VkClearValue value{};
    std::ranges::copy(color.clear, value.color.float32);
    return value;
}

VkImageLayout colorLayout(const Pass& pass) {
    return pass.draw().state.readsAttachments ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
}

VkAttachmentDescription attachment(const Resource& resource, bool clear, VkImageLayout layout) {
    const VkAttachmentLoadOp load = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    return {0,
            vkFormat(resource.format),
            VkSampleCountFlagBits(resource.samples),
            load,
            VK_ATTACHMENT_STORE_OP_STORE,
            hasStencil(resource.format) ? load : VK_ATTACHMENT_LOAD_OP_DONT_CARE,
            hasStencil(resource.format) ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE,
            layout,
            layout};
}

// The render pass needs no dependencies: the SDK records barriers outside of it.
void createRenderPass(const Context& context, const Plan& plan, const Pass& pass, const HostPass& hostPass,
                      const ViewResources& resources, HostRenderTarget& out) {
    std::vector<VkAttachmentDescription> attachments;
    std::vector<VkAttachmentReference> colors;
    std::vector<VkImageView> views;
    for (const ColorAttachment& color : hostPass.colors) {
        colors.push_back({uint32_t(attachments.size()), colorLayout(pass)});
        attachments.push_back(attachment(plan.resources[color.resource], pass.draw().clearsColor, colorLayout(pass)));
        views.push_back(resources[color.resource].layerViews[color.layer]);
    }
    const VkAttachmentReference depth{uint32_t(attachments.size()), VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    const bool hasDepth = pass.draw().depthTarget != noResource;
    if (hasDepth) {
        attachments.push_back(
            attachment(plan.resources[pass.draw().depthTarget], pass.draw().clearsDepth, depth.layout));
        views.push_back(resources[pass.draw().depthTarget].layerViews[0]);
    }
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = uint32_t(colors.size());
    subpass.pColorAttachments = colors.data();
    subpass.pDepthStencilAttachment = hasDepth ? &depth : nullptr;
    if (pass.draw().state.readsAttachments) {
        subpass.flags = VK_SUBPASS_DESCRIPTION_RASTERIZATION_ORDER_ATTACHMENT_COLOR_ACCESS_BIT_EXT;
        subpass.inputAttachmentCount = subpass.colorAttachmentCount;
        subpass.pInputAttachments = colors.data();
    }
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = uint32_t(attachments.size());
    info.pAttachments = attachments.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    check(context.vk.CreateRenderPass(context.device, &info, nullptr, &out.renderPass), "vkCreateRenderPass");
    context.name(VK_OBJECT_TYPE_RENDER_PASS, (uint64_t)out.renderPass, "agaa " + pass.name);
    VkFramebufferCreateInfo framebuffer{};
    framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    framebuffer.renderPass = out.renderPass;
    framebuffer.attachmentCount = uint32_t(views.size());
    framebuffer.pAttachments = views.data();
    framebuffer.width = pass.draw().width;
    framebuffer.height = pass.draw().height;
    framebuffer.layers = 1;
    check(context.vk.CreateFramebuffer(context.device, &framebuffer, nullptr, &out.framebuffer), "vkCreateFramebuffer");
    context.name(VK_OBJECT_TYPE_FRAMEBUFFER, (uint64_t)out.framebuffer, "agaa " + pass.name);
}

VkRenderingAttachmentInfo renderingAttachment(VkImageView view, VkImageLayout layout, bool clears, VkClearValue value) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = view;
    info.imageLayout = layout;
    info.loadOp = clears ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = value;
    return info;
}

// Dynamic rendering has no input attachments in the Vulkan versions that the SDK supports.
bool needsRenderPass(const Context& context, const Pass& pass) {
    return !context.dynamicRendering || pass.draw().state.readsAttachments;
}

} // namespace

void createHostRenderTarget(const Context& context, const Plan& plan, const Pass& pass, const HostPass& hostPass,
                            const ViewResources& resources, HostRenderTarget& out) {
    if (needsRenderPass(context, pass))
        createRenderPass(context, plan, pass, hostPass, resources, out);
}

void destroyHostRenderTarget(const Context& context, HostRenderTarget& target) {
    if (!target.renderPass)
        return;
    context.vk.DestroyFramebuffer(context.device, target.framebuffer, nullptr);
    context.vk.DestroyRenderPass(context.device, target.renderPass, nullptr);
}

void beginHostRendering(const Context& context, const Pass& pass, FrameExtent extent, const HostPass& hostPass,
                        const HostRenderTarget& target, const ViewResources& resources, VkCommandBuffer commands) {
    const VkRect2D area{{0, 0}, {extent.width, extent.height}};
    const bool hasDepth = hostPass.depthFormat != Format::None;
    if (target.renderPass) {
        std::vector<VkClearValue> clears;
        for (const ColorAttachment& color : hostPass.colors)
            clears.push_back(colorClear(color));
        if (hasDepth)
            clears.push_back(depthClear(pass));
        VkRenderPassBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
        info.renderPass = target.renderPass;
        info.framebuffer = target.framebuffer;
        info.renderArea = area;
        info.clearValueCount = uint32_t(clears.size());
        info.pClearValues = clears.data();
        context.vk.CmdBeginRenderPass(commands, &info,
                                      context.secondary ? VK_SUBPASS_CONTENTS_SECONDARY_COMMAND_BUFFERS
                                                        : VK_SUBPASS_CONTENTS_INLINE);
        return;
    }
    std::vector<VkRenderingAttachmentInfo> colors;
    for (const ColorAttachment& color : hostPass.colors)
        colors.push_back(renderingAttachment(resources[color.resource].layerViews[color.layer], colorLayout(pass),
                                             pass.draw().clearsColor, colorClear(color)));
    VkRenderingAttachmentInfo depth{};
    if (hasDepth)
        depth = renderingAttachment(resources[pass.draw().depthTarget].layerViews[0],
                                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, pass.draw().clearsDepth,
                                    depthClear(pass));
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.flags = context.secondary ? VK_RENDERING_CONTENTS_SECONDARY_COMMAND_BUFFERS_BIT : 0;
    info.renderArea = area;
    info.layerCount = 1;
    info.colorAttachmentCount = uint32_t(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = hasDepth ? &depth : nullptr;
    info.pStencilAttachment = hasStencil(hostPass.depthFormat) ? &depth : nullptr;
    context.vk.CmdBeginRendering(commands, &info);
}

void endHostRendering(const Context& context, const HostRenderTarget& target, VkCommandBuffer commands) {
    if (target.renderPass)
        context.vk.CmdEndRenderPass(commands);
    else
        context.vk.CmdEndRendering(commands);
}

void beginSecondary(const Context& context, const Pass& pass, const HostPass& hostPass, const HostRenderTarget& target,
                    bool repeats, VkCommandBuffer commands) {
    const VkFormat depth = vkFormat(hostPass.depthFormat);
    std::vector<VkFormat> colors;
    for (const ColorAttachment& color : hostPass.colors)
        colors.push_back(vkFormat(color.format));
    VkCommandBufferInheritanceRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_RENDERING_INFO;
    rendering.colorAttachmentCount = uint32_t(colors.size());
    rendering.pColorAttachmentFormats = colors.data();
    rendering.depthAttachmentFormat = depth;
    rendering.stencilAttachmentFormat = hasStencil(hostPass.depthFormat) ? depth : VK_FORMAT_UNDEFINED;
    rendering.rasterizationSamples = VkSampleCountFlagBits(pass.draw().state.samples);
    const std::vector<VkSampleCountFlagBits> colorSamples(colors.size(),
                                                          VkSampleCountFlagBits(pass.draw().state.colorSamples));
    VkAttachmentSampleCountInfoNV mixed{};
    mixed.sType = VK_STRUCTURE_TYPE_ATTACHMENT_SAMPLE_COUNT_INFO_NV;
    mixed.colorAttachmentCount = uint32_t(colorSamples.size());
    mixed.pColorAttachmentSamples = colorSamples.data();
    mixed.depthStencilAttachmentSamples = rendering.rasterizationSamples;
    if (pass.draw().state.colorSamples)
        rendering.pNext = &mixed;
    VkCommandBufferInheritanceInfo inheritance{};
    inheritance.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_INFO;
    inheritance.pNext = target.renderPass ? nullptr : &rendering;
    inheritance.renderPass = target.renderPass;
    inheritance.framebuffer = target.framebuffer;
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_RENDER_PASS_CONTINUE_BIT |
                 (repeats ? VK_COMMAND_BUFFER_USAGE_SIMULTANEOUS_USE_BIT : VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
    info.pInheritanceInfo = &inheritance;
    check(context.vk.BeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}

} // namespace agaa::vk
