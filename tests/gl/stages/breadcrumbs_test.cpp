// The breadcrumbs of a frame that OpenGL is within.
#include "bench.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

// A draw callback looks at the memory, after the device has caught up.
TEST(GlBreadcrumbs, NameThePassOfADraw) {
    StageContext context;
    ViewSettings settings;
    settings.config.flags |= AGAA_CONFIG_BREADCRUMBS;
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 8}, 3));
    std::vector<agaa::BreadcrumbBuffer> seen;
    view.beforeDraw = [&] {
        sharedEgl().gl().Finish();
        seen.push_back(view.executor().readBreadcrumbs());
    };
    const AgaaLight light = sun();
    AgaaFrame frame = view.frame();
    setLight(frame, light);
    view.render(frame);
    const auto& passes = view.plan().passes;
    uint32_t draws = 0;
    for (uint32_t i = 0; i < passes.size(); ++i) {
        if (passes[i].kind() != agaa::PassKind::HostDraw)
            continue;
        ASSERT_LT(draws, seen.size());
        const auto& [begun, ended] = seen[draws++];
        EXPECT_EQ(begun.frame, view.frameIndex());
        EXPECT_EQ(begun.pass, i);
        EXPECT_EQ(ended.frame, i == 0 ? 0u : view.frameIndex());
        EXPECT_EQ(ended.pass, i == 0 ? 0u : i - 1);
    }
    EXPECT_EQ(draws, seen.size());
    EXPECT_GT(draws, 1u);
}

} // namespace
} // namespace agaa::test
