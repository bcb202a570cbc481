#include "core/abi/draw_passes.h"

#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/glsl/glsl_resources.h"

#include <algorithm>

namespace agaa {

AgaaResult writeDrawPasses(const ViewState& view, uint32_t* count, AgaaDrawPass* passes) {
    require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
    const uint32_t available = view.plan.geometryPasses();
    if (passes) {
        require(*count >= available, AGAA_ERROR_BUFFER_TOO_SMALL, "the array is too small for the draw passes.");
        checkOutputs(passes, available, {view.drawPassRow().sType});
        for (uint32_t i = 0; i < available; ++i)
            nativePart(elementOf(passes, i), view.drawPassRow());
        uint32_t next = 0;
        for (size_t i = 0; i < view.plan.passes.size(); ++i) {
            const Pass& pass = view.plan.passes[i];
            if (pass.kind() != PassKind::HostDraw)
                continue;
            AgaaDrawPass out = AGAA_DRAW_PASS_INIT;
            out.pass = pass.draw().id;
            out.stage = pass.stage;
            out.name = pass.name.c_str();
            out.width = pass.draw().width;
            out.height = pass.draw().height;
            out.scaleX = view.plan.view.scaleX;
            out.scaleY = view.plan.view.scaleY;
            out.state = pass.draw().state;
            describeHostPass(view.hostPasses[i], out);
            AgaaDrawPass* element = elementOf(passes, next++);
            if (void* native = nativePart(element, view.drawPassRow()))
                view.describePass(i, native);
            writeStruct(element, out);
        }
    }
    *count = available;
    return AGAA_OK;
}

AgaaResult writeGlslResources(ViewState& view, uint32_t pass, uint32_t* count, AgaaGlslResource* resources) {
    require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
    if (pass >= view.plan.geometryPasses())
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("the view has %u draw passes, and none with the index %u.", view.plan.geometryPasses(), pass));
    size_t index = 0;
    for (uint32_t draws = 0; view.plan.passes[index].kind() != PassKind::HostDraw || draws++ != pass;)
        ++index;
    HostPass& hostPass = view.hostPasses[index];
    if (!hostPass.resources)
        hostPass.resources = glslResources(hostPass);
    const uint32_t available = uint32_t(hostPass.resources->size());
    if (resources) {
        require(*count >= available, AGAA_ERROR_BUFFER_TOO_SMALL, "the array is too small for the resources.");
        std::copy(hostPass.resources->begin(), hostPass.resources->end(), resources);
    }
    *count = available;
    return AGAA_OK;
}

} // namespace agaa
