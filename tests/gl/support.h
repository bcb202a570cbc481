// What the whole-frame tests of OpenGL share.
#pragma once

#include "test_scenes.h"

namespace harness::test {

// One renderer for the process, with debug messages.
inline Renderer& sharedGlRenderer() {
    static const std::unique_ptr<Renderer> renderer = makeGlRenderer(RendererOptions{});
    return *renderer;
}

} // namespace harness::test
