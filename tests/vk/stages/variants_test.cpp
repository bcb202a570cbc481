// Variants that another thread prepares while frames are recorded. Validation layers check the calls of both threads.
#include "variant_cases.h"

#include "agreement.h"
#include "show.h"

#include <atomic>
#include <thread>

namespace agaa::test {
namespace {

// Facts of every kind, in an order that leaves frames without a variant of their own for long.
std::vector<AgaaSceneFacts> everyFacts() {
    std::vector<AgaaSceneFacts> list;
    for (uint64_t flags : {0x0u, 0x8u, 0x1u, 0x9u, 0x2u, 0xAu, 0x3u, 0xBu})
        for (uint32_t shadows : {0u, 1u})
            list.push_back(sceneFacts(AGAA_FACT_ALPHA_MASKED | flags, shadows));
    return list;
}

// frames(rig) begins with the thread, and ends after it.
void expectEqualFramesWhile(const ViewSettings& settings, bool fromTwoThreads) {
    StageContext context;
    FactsRig<VulkanHost> rig(context, settings, trianglesWithin(AGAA_FACT_ALL_SHADED));
    const std::vector<AgaaSceneFacts> list = everyFacts();
    std::vector<std::vector<float>> expected;
    for (const AgaaSceneFacts& facts : list)
        expected.push_back(rig.show(facts));
    EXPECT_EQ(rig.statistics().variantCount, 1u);

    std::atomic<uint32_t> running = fromTwoThreads ? 2 : 1;
    const AgaaView view = rig.view().get();
    const auto prepare = [&](bool backwards) {
        for (size_t i = 0; i < list.size(); ++i)
            EXPECT_EQ(agaaPrepareVariants(view, 1, &list[backwards ? list.size() - 1 - i : i]), AGAA_OK);
        --running;
    };
    std::thread first(prepare, false), second;
    if (fromTwoThreads)
        second = std::thread(prepare, true);
    uint32_t frames = 0;
    for (bool isLast = false; !isLast; ++frames) {
        isLast = running == 0 && frames >= list.size();
        const size_t which = (frames * 5) % list.size();
        SCOPED_TRACE(frames);
        expectSameImage(rig.show(list[which]), expected[which], context.caps());
        EXPECT_LE(rig.statistics().variantCount, list.size());
    }
    first.join();
    if (second.joinable())
        second.join();
    const AgaaFrameStatistics statistics = rig.statistics();
    EXPECT_EQ(statistics.variantCount, list.size()) << "the last of the list is that of the view";
    for (size_t i = 0; i < list.size(); ++i) {
        expectSameImage(rig.show(list[i]), expected[i], context.caps());
        EXPECT_EQ(rig.statistics().variantFlags, list[i].flags);
        EXPECT_EQ(rig.statistics().variantShadowMaps, list[i].shadowMapCount);
    }
    EXPECT_EQ(rig.statistics().compiledPipelines, statistics.compiledPipelines);
    std::printf("%u frames beside the preparation of %zu variants, %u pipelines\n", frames, list.size(),
                statistics.compiledPipelines);
}

TEST(VariantThreads, FramesRunWhileVariantsCompile) { expectEqualFramesWhile(settingsOf({"ssaa", 4}), false); }

// Passes with code of the host's, which the library's own compiler translates.
TEST(VariantThreads, TwoThreadsPrepareTheSame) {
    expectEqualFramesWhile(settingsOf({"agaa", 2, AGAA_TIER_IDS}), true); // of few samples, which compile sooner
}

} // namespace
} // namespace agaa::test
