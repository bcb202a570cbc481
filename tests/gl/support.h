// What the whole-frame tests of OpenGL share.
#pragma once

#include "test_scenes.h"

#include <gtest/gtest.h>

namespace harness::test {

// One renderer for the process, with debug messages.
inline Renderer& sharedGlRenderer() {
    static const std::unique_ptr<Renderer> renderer = makeGlRenderer(RendererOptions{});
    return *renderer;
}

inline void expectNoMessages(Renderer& renderer) {
    for (const ApiMessage& message : renderer.takeMessages())
        ADD_FAILURE() << message.severity << " " << message.id << ": " << message.text;
}

} // namespace harness::test
