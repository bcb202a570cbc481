// Fragments that merge in the shader that draws them, beside lists of the same fragments. Software rasterisers draw the
// fragments of a pixel in order, so that shaders without the interlock's words do there what they do on other devices
// with them. Each graphics API instantiates these.
#pragma once

#include "agreement.h"
#include "carried_cases.h"
#include "setting_share.h"

#include "core/abi/handles.h"

namespace agaa::test {

template <class Host> class InterlockCases : public testing::Test {
protected:
    InterlockCases() : hasInterlock(context.caps().flags & AGAA_DEVICE_FRAGMENT_INTERLOCK) {
        context.get()->caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
    }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }

    typename Host::Context context;
    bool hasInterlock;
};
TYPED_TEST_SUITE_P(InterlockCases);

inline void expectSameFrame(const Kept& got, const Kept& expected, const AgaaDeviceCaps& caps) {
    for (size_t p = 0; p < expected.words.size(); ++p)
        if (isInOrder(caps)) {
            ASSERT_EQ(got.words[p], expected.words[p]) << p;
        } else {
            expectSame(got.pixels[p], expected.pixels[p], p, true);
        }
    expectSameImage(got.rgb, expected.rgb, caps, 1e-4f); // positions follow the slopes
    const AgaaCounters &a = expected.counters, &b = got.counters;
    EXPECT_EQ(b.fragments, a.fragments);
    EXPECT_EQ(b.mergedFirst, a.mergedFirst);
    EXPECT_EQ(b.mergedSecond, a.mergedSecond);
    EXPECT_EQ(b.discarded, a.discarded);
    EXPECT_EQ(b.lostSamples, a.lostSamples);
    EXPECT_EQ(b.shadingEvents, a.shadingEvents);
    EXPECT_EQ(b.visible, a.visible);
    EXPECT_EQ(b.sanitised, a.sanitised);
}

// Merging in order is bit by bit equal to merging lists in the order of the draws, if ids ascend with the draws.
TYPED_TEST_P(InterlockCases, MergesAsLists) {
    if (!this->hasInterlock && !(this->context.caps().flags & AGAA_DEVICE_SOFTWARE))
        GTEST_SKIP() << "the device need not rasterise the fragments of a pixel in order";
    struct Case {
        uint32_t samples, surfaces, merge;
        bool isTangle;
        float masked;
        uint32_t ndf;
    };
    for (size_t setting = 0; const Case& c : {Case{64, 4, AGAA_MERGE_VISIBLE, true, 0, AGAA_NDF_LEAN},
                                              {64, 2, AGAA_MERGE_PAPER, true, 0, AGAA_NDF_TOKSVIG},
                                              {32, 8, AGAA_MERGE_VISIBLE, false, 0.5f, AGAA_NDF_TOKSVIG},
                                              {128, 1, AGAA_MERGE_NONE, true, 0, AGAA_NDF_NONE}}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(c.samples);
        const Shot shot{.triangles =
                            c.isTangle ? tangle(400) : randomTriangles({.triangles = 200, .masked = c.masked}, 61),
                        .change = addAmbient};
        ViewSettings settings = carriedSettings(c.samples, c.surfaces);
        settings.hasInterlock = this->hasInterlock;
        settings.config.coverage.merge = c.merge;
        settings.config.surfaceCosine = 0.9f;
        settings.config.ndf = c.ndf;
        settings.surface = "s.normalDx = vec3(0.3, 0.0, 0.1); s.normalDy = vec3(0.0, 0.02, 0.0);";
        settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
        const Kept lists = this->keep(settings, shot);
        settings.config.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
        const Kept merged = this->keep(settings, shot);
        expectSameFrame(merged, lists, this->context.caps());
        EXPECT_GT(lists.counters.discarded + lists.counters.mergedFirst, c.isTangle ? 20u : 0u);
        for (size_t p = 0; p < merged.lists.size(); ++p)
            ASSERT_TRUE(merged.lists[p].empty()) << p;
        std::printf("%u samples, %u surfaces: %llu + %llu merged, %llu discarded\n", c.samples, c.surfaces,
                    (unsigned long long)merged.counters.mergedFirst, (unsigned long long)merged.counters.mergedSecond,
                    (unsigned long long)merged.counters.discarded);
    }
}

// Merging in order follows the draws, and lists follow the ids.
TYPED_TEST_P(InterlockCases, DrawsDecideTheOrder) {
    if (!this->hasInterlock && !(this->context.caps().flags & AGAA_DEVICE_SOFTWARE))
        GTEST_SKIP() << "the device need not rasterise the fragments of a pixel in order";
    const Shot shot{.triangles = tangle(400), .change = addAmbient};
    ViewSettings settings = carriedSettings(64, 2);
    settings.hasInterlock = this->hasInterlock;
    settings.config.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
    const Kept merged = this->keep(settings, shot);
    settings.surface = "s.primitive = 399u - s.primitive;";
    EXPECT_EQ(this->keep(settings, shot).words, merged.words);
    settings.config.generationTier = AGAA_TIER_MATERIAL_LISTS;
    settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
    EXPECT_NE(this->keep(settings, shot).words, merged.words);
}

TYPED_TEST_P(InterlockCases, IsRefusedWithoutTheFeatureAndForExactFrames) {
    ViewSettings settings = carriedSettings();
    settings.config.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
    settings.config.coverage.flags = AGAA_COVERAGE_EXACT;
    EXPECT_NE(expectRefused(this->context, settings, AGAA_ERROR_UNSUPPORTED, "exact").find("interlock"),
              std::string::npos);
    settings.config.coverage.flags = 0;
    if (this->hasInterlock)
        return;
    typename TypeParam::Context without;
    EXPECT_NE(expectRefused(without, settings, AGAA_ERROR_UNSUPPORTED, "no interlock").find("no interlock"),
              std::string::npos);
}

REGISTER_TYPED_TEST_SUITE_P(InterlockCases, MergesAsLists, DrawsDecideTheOrder,
                            IsRefusedWithoutTheFeatureAndForExactFrames);

} // namespace agaa::test
