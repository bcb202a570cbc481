// In whose memory contexts and views live, in which order they go, and which views are refused. Each graphics API
// instantiates these for its host.
#pragma once

#include "frame_misuse.h"
#include "host_bench.h"
#include "host_memory.h"

namespace agaa::test {

template <class Host>
class LifetimeCases : public testing::Test {};
TYPED_TEST_SUITE_P(LifetimeCases);

TYPED_TEST_P(LifetimeCases, HandlesLiveInTheHostsMemory) {
    HostMemory memory;
    {
        BenchOf<TypeParam> bench(benchSettings(), TypeParam::changed([&](auto& desc) { memory.useFor(desc); }));
        EXPECT_EQ(memory.blocks.size(), 2u);
        EXPECT_TRUE(memory.blocks.contains(bench.view.get()));
        bench.picture();
        ViewSettings tooLarge = benchSettings();
        tooLarge.width = 1u << 20;
        expectRefused(bench.context, tooLarge, AGAA_ERROR_TOO_LARGE, "too wide");
        EXPECT_EQ(memory.blocks.size(), 2u) << "what a failure had is given back";
    }
    EXPECT_EQ(memory.calls, 3u);
    EXPECT_TRUE(memory.blocks.empty());
}

TYPED_TEST_P(LifetimeCases, ViewsGoBeforeTheirContext) {
    BenchOf<TypeParam> bench;
    const std::vector<float> expected = bench.picture();
    bench.context.lines.clear();
    agaaDestroyContext(bench.context.get()); // too early: kept
    expectOneSentence(bench.context.lines, AGAA_ERROR_WRONG_ORDER, "too early");
    EXPECT_EQ(bench.picture(), expected);
    agaaDestroyView(nullptr);
    agaaDestroyContext(nullptr);
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
                            ViewsAreRefusedInASentence);

} // namespace agaa::test
