// The Vulkan part of the C ABI.
#include "core/abi/backend_api.h"
#include "core/abi/init.h"
#include "core/base/error.h"
#include "core/plan/planner.h"
#include "vk/structs.h"
#include "vk/view.h"

using namespace agaa;

namespace {

void checkDevice(const AgaaVkDeviceDesc& desc) {
    require(desc.instance && desc.physicalDevice && desc.device && desc.getProcAddr, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkDeviceDesc lacks an instance, physical device, device or getProcAddr.");
    require(!desc.enabledExtensionCount || desc.enabledExtensions, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkDeviceDesc::enabledExtensions is null.");
    require(desc.apiVersion >= VK_API_VERSION_1_2, AGAA_ERROR_UNSUPPORTED,
            "AgaaVkDeviceDesc::apiVersion is below Vulkan 1.2.");
    checkRange(uint64_t(desc.rendering), 0, AGAA_VK_RENDERING_RENDER_PASS, "AgaaVkDeviceDesc::rendering");
    checkRange(uint64_t(desc.recording), 0, AGAA_VK_RECORDING_INLINE, "AgaaVkDeviceDesc::recording");
    checkRange(uint64_t(desc.descriptorSet), 0, 7, "AgaaVkDeviceDesc::descriptorSet");
}

} // namespace

extern "C" {

#define AGAA_VK_STRUCT AGAA_INIT_FUNCTION
#include "core/base/structs.inc"

AgaaResult AGAA_CALL agaaVkCreateContext(uint32_t headerVersion, const AgaaContextDesc* desc, AgaaContext* outContext) {
    return guarded(logOfDesc(desc), "agaaVkCreateContext", [&]() -> AgaaResult {
        checkHeaderVersion(headerVersion);
        require(outContext, AGAA_ERROR_INVALID_ARGUMENT, "the context pointer is null.");
        const AgaaContextDesc common =
            readContextDesc(desc, {AGAA_STRUCTURE_TYPE_VK_DEVICE_DESC, AGAA_STRUCTURE_TYPE_VK_ALLOCATOR});
        const AgaaVkDeviceDesc device = readDeviceDesc<AgaaVkDeviceDesc>(common);
        checkDevice(device);
        const std::optional<AgaaVkAllocator> allocator = readChained<AgaaVkAllocator>(&common);
        require(!allocator || (allocator->allocate && allocator->free), AGAA_ERROR_INVALID_ARGUMENT,
                "AgaaVkAllocator::allocate or ::free is null.");
        *outContext =
            construct<vk::Context>({common.allocate, common.free, common.allocateUser}, common, device, allocator);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaVkGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps) {
    return writeContextCaps("agaaVkGetContextCaps", context, Backend::Vulkan, outCaps);
}

AgaaResult AGAA_CALL agaaVkCreateView(AgaaContext context, const AgaaViewDesc* desc, AgaaView* outView) {
    return guarded(logOf(context), "agaaVkCreateView", [&]() -> AgaaResult {
        requireBackend(context, Backend::Vulkan);
        require(outView, AGAA_ERROR_INVALID_ARGUMENT, "the view pointer is null.");
        const ViewSettings settings = resolveView(desc, techniques());
        require(!settings.clipZFromMinusOne, AGAA_ERROR_UNSUPPORTED,
                "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE is of OpenGL; Vulkan maps z/w in [0;1] to depth.");
        *outView = createView<vk::View>(static_cast<vk::Context&>(*context), settings, settings);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaVkRecordFrame(AgaaView view, const AgaaFrame* frame, const AgaaVkFrame* vkFrame) {
    return guarded(logOf(view), "agaaVkRecordFrame", [&]() -> AgaaResult {
        requireBackend(view, Backend::Vulkan);
        return static_cast<vk::View*>(view->current)
            ->record(readStruct(frame, {AGAA_STRUCTURE_TYPE_TEMPORAL_FRAME}),
                     readStruct(vkFrame, {AGAA_STRUCTURE_TYPE_VK_RESOLVED_IMAGES}));
    });
}

} // extern "C"
