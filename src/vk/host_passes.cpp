#include "vk/host_passes.h"

#include "core/abi/draw_passes.h"
#include "core/glsl/host_glsl.h"
#include "vk/formats.h"

#include <algorithm>
#include <array>
#include <vector>

namespace agaa::vk {

namespace {

VkClearValue depthClear(const Pass& pass) {
    VkClearValue value{};
    value.depthStencil = {pass.draw.clear.depth, pass.draw.clear.stencil};
    return value;
}

VkClearValue colorClear(const Pass& pass, size_t target) {
    VkClearValue value{};
    std::copy_n(pass.draw.clear.color[target].begin(), 4, value.color.float32);
    return value;
}

// Each layer of a colour target is an attachment: calls f(resource, index of the target, layer).
template <typename F> void forColorAttachments(const Plan& plan, const Pass& pass, F f) {
    for (size_t i = 0; i < pass.draw.colorTargets.size(); ++i)
        for (uint32_t layer = 0; layer < plan.resources[pass.draw.colorTargets[i]].layers; ++layer)
            f(pass.draw.colorTargets[i], i, layer);
}

VkImageLayout colorLayout(const Pass& pass) {
    return pass.draw.state.readsAttachments ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
}

VkAttachmentDescription attachment(const Resource& resource, bool clear, VkImageLayout layout) {
    const VkAttachmentLoadOp load = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
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
    forColorAttachments(plan, pass, [&](ResourceId target, size_t, uint32_t layer) {
        colors.push_back({uint32_t(attachments.size()), colorLayout(pass)});
        attachments.push_back(attachment(plan.resources[target], pass.draw.clearsColor, colorLayout(pass)));
        views.push_back(resources[target].layerViews[layer]);
    });
    const VkAttachmentReference depth{uint32_t(attachments.size()),
                                      VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    const bool hasDepth = pass.draw.depthTarget != noResource;
    if (hasDepth) {
        attachments.push_back(attachment(plan.resources[pass.draw.depthTarget], pass.draw.clearsDepth, depth.layout));
        views.push_back(resources[pass.draw.depthTarget].layerViews[0]);
    }
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = uint32_t(colors.size());
    subpass.pColorAttachments = colors.data();
    subpass.pDepthStencilAttachment = hasDepth ? &depth : nullptr;
    if (pass.draw.state.readsAttachments) {
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
    check(context.vk.CreateRenderPass(context.device, &info, nullptr, &objects.renderPass),
          "vkCreateRenderPass");
    context.name(VK_OBJECT_TYPE_RENDER_PASS, (uint64_t)objects.renderPass, "agaa " + pass.name);
    VkFramebufferCreateInfo framebuffer{};
    framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    framebuffer.renderPass = objects.renderPass;
    framebuffer.attachmentCount = uint32_t(views.size());
    framebuffer.pAttachments = views.data();
    framebuffer.width = pass.draw.width;
    framebuffer.height = pass.draw.height;
    framebuffer.layers = 1;
    check(context.vk.CreateFramebuffer(context.device, &framebuffer, nullptr, &objects.framebuffer),
          "vkCreateFramebuffer");
    context.name(VK_OBJECT_TYPE_FRAMEBUFFER, (uint64_t)objects.framebuffer, "agaa " + pass.name);
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

// Dynamic rendering of the Vulkan versions that the SDK takes has no input attachments.
bool needsRenderPass(const Context& context, const Pass& pass) {
    return !context.dynamicRendering || pass.draw.state.readsAttachments;
}

} // namespace

std::vector<VkFormat> colorFormats(const Plan& plan, const Pass& pass) {
    std::vector<VkFormat> formats;
    forColorAttachments(plan, pass, [&](ResourceId target, size_t, uint32_t) {
        formats.push_back(vkFormat(plan.resources[target].format));
    });
    return formats;
}

void createHostPass(const Context& context, const Plan& plan, const Pass& pass,
                    const ViewResources& resources, HostPassObjects& objects) {
    HostDialect dialect;
    objects.key = hostPassKey(plan, pass, dialect); // of any set: that is the pipeline layout's
    dialect.descriptorSet = context.descriptorSet;
    objects.extensions = hostExtensions(pass, dialect);
    objects.declarations = hostDeclarations(plan, pass, dialect);
    objects.geometry = hostGeometry(plan, pass, dialect);
    objects.vertex = hostVertex(plan, pass, dialect);
    if (needsRenderPass(context, pass))
        createRenderPass(context, plan, pass, resources, objects);
}

void destroyHostPass(const Context& context, HostPassObjects& objects) {
    if (!objects.renderPass)
        return;
    context.vk.DestroyFramebuffer(context.device, objects.framebuffer, nullptr);
    context.vk.DestroyRenderPass(context.device, objects.renderPass, nullptr);
}

void beginHostRendering(const Context& context, const Plan& plan, const Pass& pass,
                        const HostPassObjects& objects, const ViewResources& resources,
                        VkCommandBuffer commands, bool secondary) {
    const VkRect2D area{{0, 0}, {pass.draw.width, pass.draw.height}};
    const bool hasDepth = pass.draw.depthTarget != noResource;
    if (objects.renderPass) {
        std::vector<VkClearValue> clears;
        forColorAttachments(plan, pass, [&](ResourceId, size_t target, uint32_t) {
            clears.push_back(colorClear(pass, target));
        });
        if (hasDepth)
            clears.push_back(depthClear(pass));
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
    forColorAttachments(plan, pass, [&](ResourceId target, size_t index, uint32_t layer) {
        colors.push_back(renderingAttachment(resources[target].layerViews[layer], colorLayout(pass), pass.draw.clearsColor,
                                             colorClear(pass, index)));
    });
    VkRenderingAttachmentInfo depth{};
    if (hasDepth)
        depth = renderingAttachment(resources[pass.draw.depthTarget].layerViews[0],
                                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, pass.draw.clearsDepth, depthClear(pass));
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.flags = secondary ? VK_RENDERING_CONTENTS_SECONDARY_COMMAND_BUFFERS_BIT : 0;
    info.renderArea = area;
    info.layerCount = 1;
    info.colorAttachmentCount = uint32_t(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = hasDepth ? &depth : nullptr;
    info.pStencilAttachment = hasDepth && hasStencil(plan.resources[pass.draw.depthTarget].format) ? &depth : nullptr;
    context.vk.CmdBeginRendering(commands, &info);
}

void endHostRendering(const Context& context, const HostPassObjects& objects, VkCommandBuffer commands) {
    if (objects.renderPass)
        context.vk.CmdEndRenderPass(commands);
    else
        context.vk.CmdEndRendering(commands);
}

void beginSecondary(const Context& context, const Plan& plan, const Pass& pass,
                    const HostPassObjects& objects, VkCommandBuffer commands) {
    const Format depth = pass.draw.depthTarget != noResource ? plan.resources[pass.draw.depthTarget].format : Format::None;
    const std::vector<VkFormat> colors = colorFormats(plan, pass);
    VkCommandBufferInheritanceRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_RENDERING_INFO;
    rendering.colorAttachmentCount = uint32_t(colors.size());
    rendering.pColorAttachmentFormats = colors.data();
    rendering.depthAttachmentFormat = depth == Format::None ? VK_FORMAT_UNDEFINED : vkFormat(depth);
    rendering.stencilAttachmentFormat = hasStencil(depth) ? vkFormat(depth) : VK_FORMAT_UNDEFINED;
    rendering.rasterizationSamples = VkSampleCountFlagBits(pass.draw.state.samples);
    VkCommandBufferInheritanceInfo inheritance{};
    inheritance.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_INFO;
    inheritance.pNext = objects.renderPass ? nullptr : &rendering;
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
    AgaaDrawTarget target = emptyTarget(plan, pass);
    target.pipelineKey = objects.key;
    target.commandBuffer = commands;
    target.descriptorSet = (uint64_t)set;
    return target;
}

} // namespace agaa::vk
