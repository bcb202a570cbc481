// The Vulkan part of the C ABI.
#include "core/backend_api.h"
#include "vk/formats.h"
#include "vk/view.h"

using namespace agaa;

namespace {

void checkContextDesc(const AgaaVkContextDesc* pointer) {
    const AgaaVkContextDesc& desc =
        checkStruct(pointer, AGAA_STRUCTURE_TYPE_VK_CONTEXT, "AgaaVkContextDesc");
    require(desc.instance && desc.physicalDevice && desc.device && desc.getProcAddr,
            AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkContextDesc lacks an instance, physical device, device or getProcAddr.");
    require(!desc.enabledExtensionCount || desc.enabledExtensions, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkContextDesc::enabledExtensions is null.");
    require(desc.apiVersion >= VK_API_VERSION_1_2, AGAA_ERROR_UNSUPPORTED,
            "AgaaVkContextDesc::apiVersion is below Vulkan 1.2.");
    checkRange(uint64_t(desc.rendering), 0, AGAA_VK_RENDERING_RENDER_PASS,
               "AgaaVkContextDesc::rendering");
    checkRange(uint64_t(desc.recording), 0, AGAA_VK_RECORDING_INLINE,
               "AgaaVkContextDesc::recording");
    checkRange(uint64_t(desc.descriptorSet), 0, 7, "AgaaVkContextDesc::descriptorSet");
    require(desc.reserved == 0 && desc.reserved2 == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaVkContextDesc has a reserved member that is not 0.");
    checkContextCommons(desc, "AgaaVkContextDesc");
}

void describe(const vk::View& view, size_t index, AgaaVkDrawPass& out) {
    const Plan& plan = view.plan;
    const Pass& pass = plan.passes[index];
    const vk::HostPassObjects& host = view.passes[index].host;
    out.pipelineKey = host.key;
    for (size_t i = 0; i < 4; ++i)
        out.colorFormats[i] = i < pass.colorTargets.size()
                                  ? vk::vkFormat(plan.resources[pass.colorTargets[i]].format)
                                  : VK_FORMAT_UNDEFINED;
    out.depthStencilFormat = pass.depthTarget != noResource ? vk::vkFormat(plan.resources[pass.depthTarget].format)
                                                            : VK_FORMAT_UNDEFINED;
    out.renderPass = (uint64_t)host.renderPass;
    out.descriptorSetLayout = (uint64_t)view.passes[index].setLayout;
    out.glslExtensions = host.extensions.c_str();
    out.glslDeclarations = host.declarations.c_str();
    out.glslGeometry = host.geometry.empty() ? nullptr : host.geometry.c_str();
}

// Where contents live on after a segment: in the layout of the last pass up to its end.
VkImageLayout layoutAfter(const Plan& plan, ResourceId id, uint64_t segment) {
    const bool kept = plan.config.flags & AGAA_CONFIG_READBACK ||
                      plan.passes[plan.resources[id].lastPass].segment > segment;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    for (const Pass& pass : plan.passes)
        for (const Access& access : accessesOf(pass))
            if (kept && pass.segment <= segment && access.resource == id)
                layout = vk::vkAccess(plan, access).layout;
    return layout;
}

void describe(const vk::View& view, ResourceId id, AgaaVkSurface& out) {
    const vk::GpuResource& gpu = (*view.resources)[id];
    describeSurface(view.plan, id, out);
    out.image = (uint64_t)gpu.image;
    out.view = (uint64_t)gpu.fetchView;
    out.buffer = gpu.buffers.empty() ? 0 : (uint64_t)gpu.buffers[0];
    out.format = vk::vkFormat(view.plan.resources[id].format);
    for (uint32_t i = 0; i < 3; ++i)
        out.layouts[i] = gpu.image ? layoutAfter(view.plan, id, UINT64_C(1) << i)
                                   : VK_IMAGE_LAYOUT_UNDEFINED;
}

} // namespace

extern "C" {

AgaaResult AGAA_CALL agaaVkCreateContext(uint32_t headerVersion, const AgaaVkContextDesc* desc,
                                         AgaaContext* outContext) {
    return createContext<vk::Context>("agaaVkCreateContext", headerVersion, desc, outContext,
                                      checkContextDesc);
}

AgaaResult AGAA_CALL agaaVkGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps) {
    return writeContextCaps("agaaVkGetContextCaps", context, Backend::Vulkan, outCaps);
}

AgaaResult AGAA_CALL agaaVkCreateView(AgaaContext context, const AgaaViewDesc* desc,
                                      AgaaView* outView) {
    return guarded(logOf(context), "agaaVkCreateView", [&]() -> AgaaResult {
        requireBackend(context, Backend::Vulkan);
        require(outView, AGAA_ERROR_INVALID_ARGUMENT, "the view pointer is null.");
        const ViewSettings settings = resolveView(desc);
        require(!settings.clipZFromMinusOne, AGAA_ERROR_UNSUPPORTED,
                "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE is of OpenGL; Vulkan maps z/w in [0;1] to depth.");
        *outView = construct<vk::View>(context->allocator, static_cast<vk::Context&>(*context), settings);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaVkGetDrawPasses(AgaaView view, uint32_t* count, AgaaVkDrawPass* passes) {
    return guarded(logOf(view), "agaaVkGetDrawPasses", [&]() -> AgaaResult {
        requireBackend(view, Backend::Vulkan);
        return writeDrawPasses(view->plan, count, passes, AGAA_STRUCTURE_TYPE_VK_DRAW_PASS,
                               "AgaaVkDrawPass", [&](size_t index, AgaaVkDrawPass& out) {
                                   describe(static_cast<const vk::View&>(*view), index, out);
                               });
    });
}

AgaaResult AGAA_CALL agaaVkGetSurface(AgaaView view, const char* name, AgaaVkSurface* outSurface) {
    return guarded(logOf(view), "agaaVkGetSurface", [&]() -> AgaaResult {
        requireBackend(view, Backend::Vulkan);
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkStruct(outSurface, AGAA_STRUCTURE_TYPE_VK_SURFACE, "AgaaVkSurface");
        describe(static_cast<const vk::View&>(*view), view->plan.surface(name), *outSurface);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaVkRecordFrame(AgaaView view, const AgaaFrame* frame,
                                       const AgaaVkFrame* vkFrame) {
    return guarded(logOf(view), "agaaVkRecordFrame", [&]() -> AgaaResult {
        requireBackend(view, Backend::Vulkan);
        require(frame && vkFrame, AGAA_ERROR_INVALID_ARGUMENT, "a pointer is null.");
        return static_cast<vk::View*>(view)->record(*frame, *vkFrame);
    });
}

} // extern "C"
