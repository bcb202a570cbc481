// Scenes and settings for tests of whole frames.
#pragma once

#include "render/renderer.h"

#include <string>
#include <vector>

namespace harness::test {

struct TestScene {
    std::string name;
    std::string source; // built-in name or path
    Camera camera;
    bool hasCamera = false; // else the scene's own
};

// The built-in scenes.
std::vector<TestScene> builtinTestScenes();
// The shared scenes in $AGAA_SCENES or beside the source tree; empty where they are absent.
std::vector<TestScene> sharedTestScenes();

// 17 lights, the scene's facts, counters on.
RenderSettings settingsFor(const TestScene& test, const Scene& scene, uint32_t width,
                           uint32_t height);

// One renderer for the process, with validation.
Renderer& sharedRenderer();

// Pixels that differ in any bit, and the largest difference after tone mapping.
struct Difference {
    size_t pixels = 0;
    double largest = 0;
};
Difference differenceOf(const Image& a, const Image& b);

} // namespace harness::test
