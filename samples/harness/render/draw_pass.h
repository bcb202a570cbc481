// Draw passes of a view, each with the struct of the graphics API.
#pragma once

#include "agaa_sdk.h"
#include "render/environment_glsl.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

// Native is AgaaVkDrawPass or AgaaGlDrawPass.
template <class Native> struct DrawPass : AgaaDrawPass { Native native; };

// Returns the outputs that the vertex shader of a pass needs: FOR_CORNERS of material.vert. Geometry shaders read a
// part of them.
inline int cornerOutputs(const AgaaDrawPass& pass) {
    if (!pass.glslGeometry) // the pass needs no geometry shader, or another vertex shader
        return 0;
    return std::string_view(pass.glslDeclarations).find("#define AGAA_NEEDS_MATERIAL 1") == std::string_view::npos ? 1
                                                                                                                   : 2;
}

// Returns the definitions before the sample engine's material shaders, for passes whose materials have a class.
inline std::string classDefineOf(const AgaaDrawPass& pass) {
    const std::string member = std::string("float ") + classAttribute;
    return std::string_view(pass.glslDeclarations).find(member) == std::string_view::npos ? "" : classDefine;
}

// Returns the viewports of a draw in groups: the callback sets those of a group together, and draws everything.
inline std::vector<std::span<const AgaaViewport>> viewportGroups(const AgaaDrawTarget& target) {
    const std::span<const AgaaViewport> all(target.viewports, target.viewportCount);
    if (target.state.multicast)
        return {all};
    std::vector<std::span<const AgaaViewport>> groups;
    for (size_t i = 0; i < all.size(); ++i)
        groups.push_back(all.subspan(i, 1));
    return groups;
}

// `check` throws if a result is an error.
template <class Native>
std::vector<DrawPass<Native>> drawPassesOf(AgaaView view, const Native& initial,
                                           const std::function<void(AgaaResult)>& check) {
    uint32_t count = 0;
    check(agaaGetDrawPasses(view, &count, nullptr));
    std::vector<AgaaDrawPass> passes(count, AgaaDrawPass AGAA_DRAW_PASS_INIT);
    std::vector<Native> natives(count, initial);
    for (uint32_t i = 0; i < count; ++i)
        passes[i].pNext = &natives[i];
    check(agaaGetDrawPasses(view, &count, passes.data()));
    std::vector<DrawPass<Native>> result;
    for (uint32_t i = 0; i < count; ++i) {
        passes[i].pNext = nullptr;
        result.push_back({passes[i], natives[i]});
    }
    return result;
}

} // namespace harness
