// What the hosts on both APIs do alike.
#pragma once

#include "device.h"

#include <stdexcept>

namespace agaa::conformance {

// Consecutive vertices that one pipeline draws.
struct DrawRange {
    uint32_t first, count;
    bool isMasked;
};
std::vector<DrawRange> drawRanges(const Scene& scene);

// AgaaFrame::projection as the host uses it, times AgaaFrame::view.
void clipFromShading(const AgaaFrame& frame, const Mistakes& mistakes, float* matrix);

// The passes of a view. Native: AgaaVkDrawPass or AgaaGlDrawPass.
template <class Native>
struct DrawPasses {
    std::vector<AgaaDrawPass> passes;
    std::vector<Native> natives;

    DrawPasses(const Functions& sdk, AgaaView view, const AgaaDrawPass& initial, const Native& initialNative) {
        uint32_t count = 0;
        check(sdk.agaaGetDrawPasses(view, &count, nullptr));
        passes.assign(count, initial);
        natives.assign(count, initialNative);
        for (uint32_t i = 0; i < count; ++i)
            passes[i].pNext = &natives[i];
        if (count)
            check(sdk.agaaGetDrawPasses(view, &count, passes.data()));
        for (const AgaaDrawPass& pass : passes)
            if (pass.glslGeometry)
                throw std::runtime_error("the suite's host has no geometry shader for a pass that needs one.");
    }

private:
    static void check(AgaaResult result) {
        if (result != AGAA_OK)
            throw std::runtime_error("agaaGetDrawPasses returns " + std::to_string(result) + ".");
    }
};

} // namespace agaa::conformance
