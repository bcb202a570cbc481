#include "vk/output_images.h"

#include "core/base/error.h"
#include "vk/structs.h"

#include <algorithm>

namespace agaa::vk {

static void checkLayoutOut(VkImageLayout layout, const char* name) {
    if (layout == VK_IMAGE_LAYOUT_UNDEFINED || layout == VK_IMAGE_LAYOUT_PREINITIALIZED)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not a layout to be left in.", name));
}

OutputImages outputImages(const Plan& plan, const AgaaVkFrame& frame) {
    OutputImages outputs;
    outputs[0] = {(VkImage)frame.outputImage, (VkImageView)frame.outputView, VkImageLayout(frame.outputLayoutIn),
                  VkImageLayout(frame.outputLayoutOut)};
    require(frame.outputImage && frame.outputView, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkFrame has no output image or view.");
    checkLayoutOut(outputs[0].layoutOut, "AgaaVkFrame::outputLayoutOut");
    const size_t count = plan.view.resolvedOutputs.size();
    if (count == 0)
        return outputs;
    const std::optional<AgaaVkResolvedImages> resolved = readChained<AgaaVkResolvedImages>(&frame);
    require(resolved.has_value(), AGAA_ERROR_INVALID_ARGUMENT,
            "the view has AgaaResolvedOutputs, and AgaaVkFrame chains no AgaaVkResolvedImages.");
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
