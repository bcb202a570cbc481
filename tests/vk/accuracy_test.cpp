// Error of aggregated shading against shading every one of the same samples.
#include "support.h"

#include "image/metrics.h"
#include "scene/gltf.h"

#include <gtest/gtest.h>

namespace harness::test {
namespace {

std::vector<TestScene> allScenes() {
    std::vector<TestScene> scenes = builtinTestScenes();
    for (const TestScene& scene : sharedTestScenes())
        scenes.push_back(scene);
    return scenes;
}

class Accuracy : public testing::TestWithParam<TestScene> {};

TEST_P(Accuracy, MoreAggregatesErrLessAndTwoErrATenthOfSingle) {
    const Scene scene = loadScene(GetParam().source);
    Renderer& renderer = sharedRenderer();
    renderer.load(scene);
    RenderSettings s = settingsFor(GetParam(), scene, 320, 180);
    const auto render = [&](const char* technique, uint32_t aggregates) {
        s.config.technique = technique;
        s.config.aggregates = aggregates;
        return renderer.render(s).image;
    };
    const Image reference = render("ssaa", 1);
    const double single = compareImages(reference, render("single", 1)).mseTm;
    const double one = compareImages(reference, render("agaa", 1)).mseTm;
    const double two = compareImages(reference, render("agaa", 2)).mseTm;
    const double four = compareImages(reference, render("agaa", 4)).mseTm;
    std::printf("%-24s mseTm single %.3g; of it c=1 %.4f, c=2 %.4f, c=4 %.4f\n",
                GetParam().name.c_str(), single, one / single, two / single, four / single);
    EXPECT_LE(two, one);
    EXPECT_LE(four, two);
    EXPECT_LE(two, 0.1 * single);
    EXPECT_TRUE(renderer.takeMessages().empty());
}

INSTANTIATE_TEST_SUITE_P(All, Accuracy, testing::ValuesIn(allScenes()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace harness::test
