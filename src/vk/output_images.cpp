#include "vk/output_images.h"

#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "vk/structs.h"

#include <algorithm>

namespace agaa::vk {

static void checkLayoutOut(VkImageLayout layout, const char* name) {
    if (layout == VK_IMAGE_LAYOUT_UNDEFINED || layout == VK_IMAGE_LAYOUT_PREINITIALIZED)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not a layout to be left in.", name));
}

// Returns whether storage images of the format take floats.
static bool storesFloats(VkFormat texels) {
    static constexpr VkFormat formats[] = {VK_FORMAT_R8_UNORM,
                                           VK_FORMAT_R8_SNORM,
                                           VK_FORMAT_R8G8_UNORM,
                                           VK_FORMAT_R8G8_SNORM,
                                           VK_FORMAT_R8G8B8A8_UNORM,
                                           VK_FORMAT_R8G8B8A8_SNORM,
                                           VK_FORMAT_B8G8R8A8_UNORM,
                                           VK_FORMAT_A8B8G8R8_UNORM_PACK32,
                                           VK_FORMAT_R16_UNORM,
                                           VK_FORMAT_R16_SNORM,
                                           VK_FORMAT_R16_SFLOAT,
                                           VK_FORMAT_R16G16_UNORM,
                                           VK_FORMAT_R16G16_SNORM,
                                           VK_FORMAT_R16G16_SFLOAT,
                                           VK_FORMAT_R16G16B16A16_UNORM,
                                           VK_FORMAT_R16G16B16A16_SNORM,
                                           VK_FORMAT_R16G16B16A16_SFLOAT,
                                           VK_FORMAT_R32_SFLOAT,
                                           VK_FORMAT_R32G32_SFLOAT,
                                           VK_FORMAT_R32G32B32A32_SFLOAT,
                                           VK_FORMAT_B10G11R11_UFLOAT_PACK32,
                                           VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                                           VK_FORMAT_A2R10G10B10_UNORM_PACK32};
    return std::ranges::find(formats, texels) != std::end(formats);
}

// Checks what the host says of its images.
static void checkTold(const Plan& plan, const AgaaFrame& frame, const AgaaVkResolvedImages& resolved) {
    const FrameExtent extent = extentOf(frame, plan);
    const uint64_t right = uint64_t(frame.outputX) + extent.width, bottom = uint64_t(frame.outputY) + extent.height;
    if ((resolved.width && resolved.width < right) || (resolved.height && resolved.height < bottom))
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaVkResolvedImages::width and height are %u and %u; the frame ends at %llu, %llu.",
                    resolved.width, resolved.height, static_cast<unsigned long long>(right),
                    static_cast<unsigned long long>(bottom)));
    for (size_t i = 0; i < plan.view.resolvedOutputs.size(); ++i)
        if (resolved.formats[i] && !storesFloats(VkFormat(resolved.formats[i])))
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("AgaaVkResolvedImages::formats[%zu] is %u, which images cannot store as floats, as R32_SFLOAT "
                        "can.",
                        i, resolved.formats[i]));
}

OutputImages outputImages(const Plan& plan, const AgaaFrame& frame, const AgaaVkFrame& vkFrame) {
    OutputImages outputs;
    outputs[0] = {(VkImage)vkFrame.outputImage, (VkImageView)vkFrame.outputView, VkImageLayout(vkFrame.outputLayoutIn),
                  VkImageLayout(vkFrame.outputLayoutOut)};
    require(vkFrame.outputImage && vkFrame.outputView, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkFrame has no output image or view.");
    checkLayoutOut(outputs[0].layoutOut, "AgaaVkFrame::outputLayoutOut");
    const size_t count = plan.view.resolvedOutputs.size();
    if (count == 0)
        return outputs;
    const std::optional<AgaaVkResolvedImages> resolved = readChained<AgaaVkResolvedImages>(&vkFrame);
    require(resolved.has_value(), AGAA_ERROR_INVALID_ARGUMENT,
            "the view has AgaaResolvedOutputs, and AgaaVkFrame chains no AgaaVkResolvedImages.");
    checkTold(plan, frame, *resolved);
    for (size_t i = 0; i < count; ++i) {
        if (!resolved->images[i] || !resolved->views[i])
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("AgaaVkResolvedImages has no image or view %zu.", i));
        OutputImage& output = outputs[i + 1];
        output = {(VkImage)resolved->images[i], (VkImageView)resolved->views[i], VkImageLayout(resolved->layoutsIn[i]),
                  VkImageLayout(resolved->layoutsOut[i])};
        checkLayoutOut(output.layoutOut, "AgaaVkResolvedImages::layoutsOut");
        require(std::none_of(outputs.begin(), outputs.begin() + long(i) + 1,
                             [&](const OutputImage& other) { return other.image == output.image; }),
                AGAA_ERROR_INVALID_ARGUMENT, "AgaaVkResolvedImages has an image twice, or the output.");
    }
    return outputs;
}

} // namespace agaa::vk
