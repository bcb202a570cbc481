// Scenes and settings for tests of whole frames, and what a frame of any graphics API must hold.
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
// Returns the shared scenes that exist, each as NAME/NAME.glb in $AGAA_SCENES. If the variable is not set, the folder
// is beside the source tree.
std::vector<TestScene> sharedTestScenes();
std::vector<TestScene> allTestScenes();
// Returns whether tests render setting number `index` of a product. They render every second one, and with
// AGAA_ALL_SETTINGS in the environment all of them.
bool rendersSetting(size_t index);
// Returns whether the test is of `scene`. With AGAA_ALL_SETTINGS in the environment it may be of `other`, too, which
// the other graphics API renders.
bool isSceneOf(const TestScene& test, const char* scene, const char* other);
// Returns whether large tests render the scene: built-in ones and every second shared one. With AGAA_ALL_SETTINGS in
// the environment they render all of them.
bool isSampled(const TestScene& test);
// Returns whether tests of a graphics API render the scene: every second built-in scene. The tests of the other one
// render the rest. With AGAA_ALL_SETTINGS in the environment both render all built-in scenes.
bool isInShare(const TestScene& test, size_t share);
constexpr size_t openGlShare = 0, vulkanShare = 1;
constexpr const char* otherApi = "the other graphics API covers it, or scripts/test --exhaustive";
// Returns the number of a built-in scene, or 0.
size_t sceneNumber(const std::string& name);
// Skips the running test if a shared scene is missing.
void expectSharedScenes();

// 17 lights, the scene's facts, counters on.
RenderSettings settingsFor(const TestScene& test, const Scene& scene, uint32_t width, uint32_t height);

// Pixels that differ in any bit, and the largest difference after tone mapping.
struct Difference {
    size_t pixels = 0;
    double largest = 0;
};
Difference differenceOf(const Image& a, const Image& b);
// Expects images of two programs to be equal: bit by bit on software rasterisers, which contract no sums. On other
// devices a rounding may move an edge across a sample in a few pixels.
void expectSameBySamples(const Image& got, const Image& expected, const Renderer& renderer);
bool isSoftware(const Renderer& renderer);
// After tone mapping, so that no highlight speaks for the image.
double meanDifference(const Image& a, const Image& b);
// Pixels a channel of which differs by more, after tone mapping, as a share of all.
double shareAbove(const Image& a, const Image& b, double bound);

// Of the API, its validation or its driver.
void expectNoMessages(Renderer& renderer);

void expectEverySampleOnce(const AgaaCounters& counters);
// The above; no pixel with more events than aggregates; as many bytes as predicted; nothing infinite.
void expectWholeFrame(const RenderResult& result, uint32_t aggregates);
// Expects two frames to be equal bit by bit, with ssaa and agaa, or with each technique and with the tiers that keep
// lists.
void expectImagesRepeat(Renderer& renderer, const RenderSettings& settings, bool inEveryTier);
// Expects equal images for two orders of the draws, for G-buffers and for lists of fragments. The scene must have no
// equal depths.
void expectOrderOfDrawsIsFree(Renderer& renderer, RenderSettings settings);
// Expects the image of the world a thousand kilometres from its origin to be that at the origin.
void expectSameFarFromTheOrigin(Renderer& renderer, RenderSettings settings);
// Bit by bit, of each tier with coverage samples and in both depth conventions: vertex shaders that expand triangles,
// beside geometry shaders. pulling: may have no geometry shaders. Both have loaded the scene. share: 0 or 1, of the
// pairs of a tier and a depth convention those that the test renders.
void expectExpansionsAgree(Renderer& geometry, Renderer& pulling, RenderSettings settings, size_t share);
// The generation tiers' images, within a stated mean difference; prints it under the scene's name.
void expectTiersAgree(Renderer& renderer, RenderSettings settings, const char* name);
// Aggregates in memory or not, draws fetched or not, the preset accurate by id or from a G-buffer: within stated mean
// differences; prints them under the scene's name.
void expectWaysAgree(Renderer& renderer, RenderSettings settings, const char* name);
// The techniques that agaa is compared with: errors against ssaa that their kind allows, events that their
// kind makes; prints them under the scene's name.
void expectRivals(Renderer& renderer, RenderSettings settings, const char* name);

} // namespace harness::test
