// Fragments that merge in attachments, beside lists of the same fragments. Each graphics API instantiates these.
#pragma once

#include "interlock_cases.h"
#include "pattern_cases.h"
#include "setting_share.h"

namespace agaa::test {

template <class Host> class RasterOrderCases : public testing::Test {
protected:
    RasterOrderCases() { EXPECT_EQ(agaaGetBuiltinLayout("dcaa28", &layout), AGAA_OK); }

    void SetUp() override {
        if (!(context.caps().flags & AGAA_DEVICE_FRAMEBUFFER_FETCH))
            GTEST_SKIP() << "the device does not order what shaders read of attachments";
    }

    ViewSettings settings(uint32_t tier, uint32_t samples = 64, uint32_t surfaces = 4) {
        ViewSettings settings = dcaaSettings(samples, surfaces, tier);
        settings.config.layout = &layout;
        settings.config.surfaceCosine = 0.9f;
        return settings;
    }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }

    AgaaLayout layout = AGAA_LAYOUT_INIT;
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(RasterOrderCases);

// Merging in order is bit by bit equal to merging lists in the order of the draws, if ids ascend with the draws. One
// surface of 128 samples leaves a word of its texels unused.
TYPED_TEST_P(RasterOrderCases, MergesAsLists) {
    struct Case {
        uint32_t samples, surfaces, merge;
        bool isTangle;
        float masked;
        uint32_t ndf;
        bool hasOwnPattern = false;
    };
    for (size_t setting = 0; const Case& c : {Case{64, 3, AGAA_MERGE_VISIBLE, true, 0, AGAA_NDF_LEAN},
                                              {64, 4, AGAA_MERGE_PAPER, true, 0, AGAA_NDF_TOKSVIG},
                                              {32, 4, AGAA_MERGE_VISIBLE, false, 0.5f, AGAA_NDF_TOKSVIG},
                                              {128, 1, AGAA_MERGE_NONE, true, 0, AGAA_NDF_NONE},
                                              {32, 2, AGAA_MERGE_VISIBLE, true, 0, AGAA_NDF_TOKSVIG, true}}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(c.samples);
        const Shot shot{.triangles =
                            c.isTangle ? tangle(400) : randomTriangles({.triangles = 200, .masked = c.masked}, 61),
                        .change = addAmbient};
        ViewSettings lists = this->settings(AGAA_TIER_MATERIAL_LISTS, c.samples, c.surfaces),
                     merging = this->settings(AGAA_TIER_RASTER_ORDER, c.samples, c.surfaces);
        lists.config.coverage.merge = merging.config.coverage.merge = c.merge;
        lists.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
        lists.config.ndf = merging.config.ndf = c.ndf;
        const std::vector<float> pattern = ownPattern(c.samples);
        if (c.hasOwnPattern)
            lists.config.coverage.samplePositions = merging.config.coverage.samplePositions = pattern.data();
        lists.surface = merging.surface = "s.normalDx = vec3(0.3, 0.0, 0.1); s.normalDy = vec3(0.0, 0.02, 0.0);";
        const Kept expected = this->keep(lists, shot), got = this->keep(merging, shot);
        expectSameFrame(got, expected, this->context.caps());
        EXPECT_GT(expected.counters.discarded + expected.counters.mergedFirst, c.isTangle ? 20u : 0u);
    }
}

// Merging in order follows the draws, and lists follow the ids.
TYPED_TEST_P(RasterOrderCases, DrawsDecideTheOrder) {
    const Shot shot{.triangles = tangle(400), .change = addAmbient};
    ViewSettings merging = this->settings(AGAA_TIER_RASTER_ORDER, 64, 2),
                 lists = this->settings(AGAA_TIER_MATERIAL_LISTS, 64, 2);
    lists.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
    const Kept merged = this->keep(merging, shot);
    merging.surface = lists.surface = "s.primitive = 399u - s.primitive;";
    EXPECT_EQ(this->keep(merging, shot).words, merged.words);
    EXPECT_NE(this->keep(lists, shot).words, merged.words);
}

// A frame leaves nothing of the one before.
TYPED_TEST_P(RasterOrderCases, FramesBeginWithoutSurfaces) {
    ViewSettings merging = this->settings(AGAA_TIER_RASTER_ORDER);
    merging.config.flags |= AGAA_CONFIG_READBACK;
    typename TypeParam::View view(this->context, merging);
    view.setTriangles(tangle(100));
    view.render(view.frame());
    const std::vector<float> rgb = withoutAlpha(TypeParam::rgba(view));
    EXPECT_NE(rgb, std::vector<float>(rgb.size()));
    view.setTriangles({});
    view.render(view.frame());
    EXPECT_EQ(view.readBuffer("surfaces"), std::vector<uint32_t>(view.readBuffer("surfaces").size()));
}

// 112 bytes a pixel, with nothing beside them.
TYPED_TEST_P(RasterOrderCases, MemoryIsThatOfTheSurfaces) {
    const typename TypeParam::View view(this->context, this->settings(AGAA_TIER_RASTER_ORDER));
    EXPECT_EQ(view.plan().totalBytes(), 112u * view.plan().view.width * view.plan().view.height);
    EXPECT_EQ(view.executor().resources->payloadBytes(), view.plan().totalBytes());
}

TYPED_TEST_P(RasterOrderCases, IsRefusedWhereAttachmentsCannotHoldThePixel) {
    const std::string reason = expectRefused(this->context, this->settings(AGAA_TIER_RASTER_ORDER, 64, 5),
                                             AGAA_ERROR_UNSUPPORTED, "140 bytes");
    EXPECT_NE(reason.find("5 surfaces of this layout take 140"), std::string::npos) << reason;
}

REGISTER_TYPED_TEST_SUITE_P(RasterOrderCases, MergesAsLists, DrawsDecideTheOrder, FramesBeginWithoutSurfaces,
                            MemoryIsThatOfTheSurfaces, IsRefusedWhereAttachmentsCannotHoldThePixel);

} // namespace agaa::test
