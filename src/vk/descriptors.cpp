// Contents of the passes' descriptor sets. Descriptors of the view's own resources are written once. Descriptors of
// imported images are written in each frame.
#include "core/plan/bindings.h"
#include "vk/view.h"

namespace agaa::vk {

VkDescriptorType descriptorType(BindingType type) {
    switch (type) {
    case BindingType::UniformBuffer:
        return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingType::StorageBuffer:
        return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingType::StorageImage:
        return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingType::Texture:
    case BindingType::ShadowTexture:
        break;
    }
    return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

static VkWriteDescriptorSet writeOf(VkDescriptorSet set, uint32_t slot, VkDescriptorType type) {
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = slot;
    write.descriptorCount = 1;
    write.descriptorType = type;
    return write;
}

static void bindBuffer(const Context& context, VkDescriptorSet set, const Binding& binding, VkBuffer buffer) {
    const VkDescriptorBufferInfo info{buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = writeOf(set, binding.slot, descriptorType(binding.type));
    write.pBufferInfo = &info;
    context.vk.UpdateDescriptorSets(context.device, 1, &write, 0, nullptr);
}

static void bindImage(const Context& context, VkDescriptorSet set, const Binding& binding, VkSampler sampler,
                      VkImageView view, VkImageLayout layout) {
    const VkDescriptorImageInfo info{sampler, view, layout};
    VkWriteDescriptorSet write = writeOf(set, binding.slot, descriptorType(binding.type));
    write.pImageInfo = &info;
    context.vk.UpdateDescriptorSets(context.device, 1, &write, 0, nullptr);
}

static void writeAttachments(const Context& context, VkDescriptorSet set, const HostPass& hostPass,
                             const ViewResources& resources) {
    std::vector<VkDescriptorImageInfo> images;
    for (const ColorAttachment& color : hostPass.colors)
        images.push_back({VK_NULL_HANDLE, resources[color.resource].layerViews[color.layer], VK_IMAGE_LAYOUT_GENERAL});
    VkWriteDescriptorSet write = writeOf(set, fetchedTargetsSlot, VK_DESCRIPTOR_TYPE_INPUT_ATTACHMENT);
    write.descriptorCount = uint32_t(images.size());
    write.pImageInfo = images.data();
    context.vk.UpdateDescriptorSets(context.device, 1, &write, 0, nullptr);
}

void View::writeStaticDescriptors() {
    for (size_t i = 0; i < passes.size(); ++i) {
        const Pass& pass = plan.passes[i];
        const bool readsAttachments = pass.kind() == PassKind::HostDraw && pass.draw().state.readsAttachments;
        for (uint32_t slot = 0; slot < passes[i].sets.size(); ++slot) {
            const VkDescriptorSet set = passes[i].sets[slot];
            for (const Binding& binding : pass.bindings)
                if (!plan.resources[binding.resource].isImported())
                    writeStatic(set, binding, slot);
            if (readsAttachments)
                writeAttachments(context, set, hostPasses[i], *resources);
        }
    }
}

void View::writeStatic(VkDescriptorSet set, const Binding& binding, uint32_t slot) {
    const VkImageView view = (*resources)[binding.resource].fetchView;
    switch (binding.type) {
    case BindingType::UniformBuffer:
    case BindingType::StorageBuffer:
        bindBuffer(context, set, binding, resources->buffer(binding.resource, slot));
        break;
    case BindingType::StorageImage:
        bindImage(context, set, binding, VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL);
        break;
    case BindingType::Texture:
        bindImage(context, set, binding,
                  binding.filter == Filter::Linear ? context.linearSampler : context.texelSampler, view,
                  isDepth(plan.resources[binding.resource].format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                                                   : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        break;
    case BindingType::ShadowTexture: // imported
        break;
    }
}

// Writes the sets of the frame's segments only: sets that an earlier segment bound must not change.
void View::writeImportedDescriptors(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, uint32_t slot) {
    uint64_t anyShadow = 0;
    for (const Resource& resource : plan.resources)
        if (resource.kind == ResourceKind::ShadowMap && !anyShadow)
            anyShadow = vkFrame.shadowViews[resource.hostSlot];
    for (size_t i = 0; i < passes.size(); ++i) {
        if (!(plan.passes[i].segment & frame.segments))
            continue;
        for (const Binding& binding : plan.passes[i].bindings) {
            const Resource& resource = plan.resources[binding.resource];
            if (resource.kind == ResourceKind::Output) {
                const bool isFetched = binding.type == BindingType::Texture;
                bindImage(context, passes[i].sets[slot], binding, isFetched ? context.texelSampler : VK_NULL_HANDLE,
                          outputs_[resource.hostSlot].view, VK_IMAGE_LAYOUT_GENERAL);
            } else if (resource.kind == ResourceKind::ShadowMap) {
                // Views beyond the frame's shadow count may be stale.
                const uint64_t view =
                    resource.hostSlot < frame.shadowCount ? vkFrame.shadowViews[resource.hostSlot] : anyShadow;
                bindImage(context, passes[i].sets[slot], binding, context.shadowSampler, (VkImageView)view,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
            }
        }
    }
}

} // namespace agaa::vk
