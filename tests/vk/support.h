// What the whole-frame tests of Vulkan share.
#pragma once

#include "test_scenes.h"

namespace harness::test {

// One renderer for the process, with validation.
inline Renderer& sharedRenderer() {
    static const std::unique_ptr<Renderer> renderer = makeVulkanRenderer(RendererOptions{});
    return *renderer;
}

} // namespace harness::test
