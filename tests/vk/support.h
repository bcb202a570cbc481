// What the whole-frame tests of Vulkan share.
#pragma once

#include "render/messages.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

namespace harness::test {

inline std::unique_ptr<Renderer> heldRenderer;

// When the device goes, the layers tell of objects that were left.
class RendererEnd : public testing::Environment {
    void TearDown() override {
        heldRenderer.reset();
        for (const ApiMessage& message : takeLeftoverMessages())
            ADD_FAILURE() << message.id << ": " << message.text;
    }
};
inline const testing::Environment* const rendererEnd = testing::AddGlobalTestEnvironment(new RendererEnd);

// One renderer for the process, with validation.
inline Renderer& sharedRenderer() {
    if (!heldRenderer)
        heldRenderer = makeVulkanRenderer(RendererOptions{});
    return *heldRenderer;
}

} // namespace harness::test
