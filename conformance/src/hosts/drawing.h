// The common part of the hosts on both APIs.
#pragma once

#include "device.h"

#include <stdexcept>

namespace agaa::conformance {

// The buffer of a scene, for vertex shaders and fetchCode(): the matrix of clipFromShading(), then the vertices.
constexpr size_t matrixBytes = 16 * sizeof(float);
static_assert(sizeof(Vertex) == 18 * sizeof(float), "fetchShader() reads vertices as words");
size_t sceneBytes(const Scene& scene);
void writeScene(void* to, const float* matrix, const Scene& scene);

constexpr uint32_t maxScenePrimitives = 1u << 16; // upper bound for a scene

// Consecutive vertices that one pipeline draws.
struct DrawRange {
    uint32_t first, count;
    bool isMasked;
};
std::vector<DrawRange> drawRanges(const Scene& scene);

// Returns AgaaFrame::projection with the host's mistakes, times AgaaFrame::view.
void clipFromShading(const AgaaFrame& frame, const Mistakes& mistakes, float* matrix);

// Returns the passes of a view. Native is AgaaVkDrawPass or AgaaGlDrawPass.
template <class Native> struct DrawPasses {
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
    }

private:
    static void check(AgaaResult result) {
        if (result != AGAA_OK)
            throw std::runtime_error("agaaGetDrawPasses returns " + std::to_string(result) + ".");
    }
};

} // namespace agaa::conformance
