// In whose memory contexts and views live, in which order they go, and which views are refused. Each graphics API
// instantiates these for its host.
#pragma once

#include "frame_misuse.h"
#include "host_bench.h"
#include "host_memory.h"

#include <tuple>
#include <vector>

namespace agaa::test {

template <class Host>
class LifetimeCases : public testing::Test {};
TYPED_TEST_SUITE_P(LifetimeCases);

TYPED_TEST_P(LifetimeCases, HandlesLiveInTheHostsMemory) {
    HostMemory memory;
    {
        BenchOf<TypeParam> bench(benchSettings(), TypeParam::changed([&](auto& desc) { memory.useFor(desc); }));
        EXPECT_EQ(memory.blocks.size(), 3u) << "a context, a view and its handle";
        EXPECT_TRUE(memory.blocks.contains(bench.view.get()));
        bench.picture();
        ViewSettings tooLarge = benchSettings();
        tooLarge.width = 1u << 20;
        expectRefused(bench.context, tooLarge, AGAA_ERROR_TOO_LARGE, "too wide");
        EXPECT_EQ(memory.blocks.size(), 3u) << "what a failure had is given back";
    }
    EXPECT_EQ(memory.calls, 4u);
    EXPECT_TRUE(memory.blocks.empty());
}

TYPED_TEST_P(LifetimeCases, ViewsGoBeforeTheirContext) {
    BenchOf<TypeParam> bench;
    const std::vector<float> expected = bench.picture();
    bench.context.lines.clear();
    EXPECT_EQ(agaaDestroyContext(bench.context.get()), AGAA_ERROR_WRONG_ORDER) << "too early: kept";
    expectOneSentence(bench.context.lines, AGAA_ERROR_WRONG_ORDER, "too early");
    EXPECT_EQ(bench.picture(), expected);
    agaaDestroyView(nullptr);
    EXPECT_EQ(agaaDestroyContext(nullptr), AGAA_OK);
}

inline std::vector<AgaaDrawPass> passesOf(AgaaView view) {
    uint32_t count = 0;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, nullptr), AGAA_OK);
    std::vector<AgaaDrawPass> passes(count, AgaaDrawPass AGAA_DRAW_PASS_INIT);
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes.data()), AGAA_OK);
    return passes;
}

TYPED_TEST_P(LifetimeCases, ViewsAreResized) {
    HostMemory memory;
    {
        const auto options = TypeParam::changed([&](auto& desc) { memory.useFor(desc); });
        BenchOf<TypeParam> bench(benchSettings(), options);
        ViewSettings otherSettings = benchSettings();
        otherSettings.width = 37; // no multiple of a tile
        otherSettings.height = 50;
        BenchOf<TypeParam> other(otherSettings);
        const std::vector<float> small = bench.picture(), expected = other.picture();
        const std::vector<AgaaDrawPass> before = passesOf(bench.view.get());

        for (const auto& [width, height, code] :
             {std::tuple{0u, 5u, AGAA_ERROR_OUT_OF_RANGE}, {5u, 0u, AGAA_ERROR_OUT_OF_RANGE},
              {1u << 20, 5u, AGAA_ERROR_TOO_LARGE}}) {
            bench.context.lines.clear();
            EXPECT_EQ(agaaResizeView(bench.view.get(), width, height), code);
            expectOneSentence(bench.context.lines, code, "resized");
        }
        EXPECT_EQ(bench.picture(), small) << "a failure changes nothing";

        ASSERT_EQ(agaaResizeView(bench.view.get(), 37, 50), AGAA_OK);
        EXPECT_EQ(memory.blocks.size(), 3u);
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), bench.view.frameIndex(), &statistics), AGAA_NOT_READY);
        const std::vector<AgaaDrawPass> after = passesOf(bench.view.get());
        ASSERT_EQ(after.size(), before.size());
        for (size_t i = 0; i < after.size(); ++i) {
            EXPECT_EQ(after[i].pipelineKey, before[i].pipelineKey);
            EXPECT_EQ(after[i].width, 37 * after[i].scaleX);
            EXPECT_EQ(after[i].height, 50 * after[i].scaleY);
        }
        // With the pipelines that there were, into the output of the view that was made at this size.
        other.run([&](auto& native) {
            AgaaFrame frame = bench.frame();
            --frame.frameIndex;
            --frame.completedFrame;
            EXPECT_EQ(TypeParam::recordFrame(bench.view.get(), &frame, &native), AGAA_ERROR_WRONG_ORDER);
            ++frame.frameIndex;
            EXPECT_EQ(TypeParam::recordFrame(bench.view.get(), &frame, &native), AGAA_OK);
        });
        EXPECT_EQ(other.image(), expected);
        EXPECT_GT(bench.view.statistics().counters.visible, 0u);
    }
    EXPECT_TRUE(memory.blocks.empty());
}

TYPED_TEST_P(LifetimeCases, ViewsAreRefusedInASentence) {
    typename TypeParam::Context context;
    ViewSettings settings = benchSettings();
    settings.width = 0;
    expectRefused(context, settings, AGAA_ERROR_OUT_OF_RANGE, "no pixels");
    settings.width = 1u << 20;
    expectRefused(context, settings, AGAA_ERROR_TOO_LARGE, "too wide");
    settings = benchSettings();
    settings.chained = &unknownStruct;
    expectRefused(context, settings, AGAA_ERROR_UNKNOWN_STRUCT, "unknown struct");
    settings = benchSettings();
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    context.lines.clear();
    EXPECT_EQ(TypeParam::createView(context.get(), nullptr, &view), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(context.lines, AGAA_ERROR_INVALID_ARGUMENT, "null");
    context.lines.clear();
    EXPECT_EQ(TypeParam::createView(context.get(), &desc, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(context.lines, AGAA_ERROR_INVALID_ARGUMENT, "no place for the view");
}

REGISTER_TYPED_TEST_SUITE_P(LifetimeCases, HandlesLiveInTheHostsMemory, ViewsGoBeforeTheirContext,
                            ViewsAreResized, ViewsAreRefusedInASentence);

} // namespace agaa::test
