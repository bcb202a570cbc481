// Descriptions of draw passes and surfaces for hosts.
#include "vk/formats.h"
#include "vk/structs.h"
#include "vk/view.h"

namespace agaa::vk {

const StructRow& View::drawPassRow() const { return StructOf<AgaaVkDrawPass>::row; }
const StructRow& View::surfaceRow() const { return StructOf<AgaaVkSurface>::row; }

void View::describePass(size_t index, void* native) const {
    const HostPass& hostPass = hostPasses[index];
    AgaaVkDrawPass description = AGAA_VK_DRAW_PASS_INIT;
    for (size_t i = 0; i < hostPass.colors.size(); ++i)
        description.colorFormats[i] = vkFormat(hostPass.colors[i].format);
    description.depthStencilFormat = vkFormat(hostPass.depthFormat);
    description.renderPass = (uint64_t)passes[index].target.renderPass;
    description.descriptorSetLayout = (uint64_t)passes[index].setLayout;
    writeStruct(static_cast<AgaaVkDrawPass*>(native), description);
}

// Returns the layout of an image after a segment, or VK_IMAGE_LAYOUT_UNDEFINED if its contents are lost. The layout is
// that of the last pass up to the segment's end that accesses the image.
static VkImageLayout layoutAfter(const Plan& plan, ResourceId id, uint64_t segment) {
    const bool kept =
        plan.view.config.flags & AGAA_CONFIG_READBACK || plan.passes[plan.resources[id].lastPass].segment > segment;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    for (const Pass& pass : plan.passes)
        for (const Access& access : accessesOf(pass))
            if (kept && pass.segment <= segment && access.resource == id)
                layout = vkAccess(plan, access).layout;
    return layout;
}

void View::describeSurface(ResourceId id, void* native) const {
    const GpuResource& gpu = (*resources)[id];
    AgaaVkSurface description = AGAA_VK_SURFACE_INIT;
    description.image = (uint64_t)gpu.image;
    description.view = (uint64_t)gpu.fetchView;
    description.buffer = gpu.buffers.empty() ? 0 : (uint64_t)gpu.buffers[0];
    description.format = vkFormat(plan.resources[id].format);
    for (uint32_t i = 0; i < 3; ++i)
        description.layouts[i] = gpu.image ? layoutAfter(plan, id, UINT64_C(1) << i) : VK_IMAGE_LAYOUT_UNDEFINED;
    writeStruct(static_cast<AgaaVkSurface*>(native), description);
}

} // namespace agaa::vk
