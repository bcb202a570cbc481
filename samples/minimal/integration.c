/* The calls of an integration on Vulkan, without the engine's own code. The README quotes them; minimal_vk.c runs.
 * SPDX-License-Identifier: MIT
 */
#include "agaa_vk.h"

/* Once: device has the engine's VkDevice, view the size of the image and the facts of the scene. */
AgaaResult begin(const AgaaVkDeviceDesc* device, const AgaaViewDesc* view, AgaaContext* outContext, AgaaView* outView,
                 uint32_t* passCount, AgaaDrawPass* outPasses) {
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    desc.pNext = device;
    AgaaResult result = agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, outContext);
    if (result >= 0)
        result = agaaVkCreateView(*outContext, view, outView);
    /* The engine makes one pipeline of each pass: its own vertex shader, and GLSL of the pass before its material. */
    return result < 0 ? result : agaaGetDrawPasses(*outView, passCount, outPasses);
}

/* Each frame: drawScene binds the pipeline of the pass that it is called for, and draws the engine's scene. */
AgaaResult render(AgaaView view, AgaaFrame* frame, const AgaaVkFrame* target, AgaaDrawCallback drawScene,
                  void* engine) {
    frame->draw = drawScene, frame->drawUser = engine;
    return agaaVkRecordFrame(view, frame, target);
}
