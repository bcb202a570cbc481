// Fragments that merge in attachments, beside lists of the same fragments.
#include "show.h"

#include "interlock_cases.h"
#include "pattern_cases.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

class RasterOrder : public testing::Test {
protected:
    RasterOrder() { EXPECT_EQ(agaaGetBuiltinLayout("dcaa28", &layout), AGAA_OK); }

    void SetUp() override {
        if (!(context.caps().flags & AGAA_DEVICE_FRAMEBUFFER_FETCH))
            GTEST_SKIP() << "the context has no GL_EXT_shader_framebuffer_fetch";
    }

    ViewSettings settings(uint32_t tier, uint32_t samples = 64, uint32_t surfaces = 4) {
        ViewSettings settings = dcaaSettings(samples, surfaces, tier);
        settings.config.layout = &layout;
        settings.config.surfaceCosine = 0.9f;
        return settings;
    }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<OpenGLHost>(context, settings, shot); }

    AgaaLayout layout = AGAA_LAYOUT_INIT;
    OpenGLHost::Context context;
};

// Bit by bit, where numbers ascend with the draws. One surface of 128 samples leaves a word of its texels unused.
TEST_F(RasterOrder, MergesAsLists) {
    struct Case {
        uint32_t samples, surfaces, merge;
        bool isTangle;
        float masked;
        uint32_t ndf;
        bool hasOwnPattern = false;
    };
    for (const Case& c : {Case{64, 3, AGAA_MERGE_VISIBLE, true, 0, AGAA_NDF_LEAN}, {64, 4, AGAA_MERGE_PAPER, true, 0, AGAA_NDF_TOKSVIG},
                          {32, 4, AGAA_MERGE_VISIBLE, false, 0.5f, AGAA_NDF_TOKSVIG}, {128, 1, AGAA_MERGE_NONE, true, 0, AGAA_NDF_NONE},
                          {32, 2, AGAA_MERGE_VISIBLE, true, 0, AGAA_NDF_TOKSVIG, true}}) {
        SCOPED_TRACE(c.samples);
        const Shot shot{.triangles = c.isTangle ? tangle(400) : randomTriangles({.triangles = 200, .masked = c.masked}, 61),
                        .change = addAmbient};
        ViewSettings lists = settings(AGAA_TIER_MATERIAL_LISTS, c.samples, c.surfaces),
                     merging = settings(AGAA_TIER_RASTER_ORDER, c.samples, c.surfaces);
        lists.config.coverage.merge = merging.config.coverage.merge = c.merge;
        lists.config.ndf = merging.config.ndf = c.ndf;
        const std::vector<float> pattern = ownPattern(c.samples);
        if (c.hasOwnPattern)
            lists.config.coverage.samplePositions = merging.config.coverage.samplePositions = pattern.data();
        lists.surface = merging.surface = "s.normalDx = vec3(0.3, 0.0, 0.1); s.normalDy = vec3(0.0, 0.02, 0.0);";
        const Kept expected = keep(lists, shot), got = keep(merging, shot);
        expectSameFrame(got, expected);
        EXPECT_GT(expected.counters.discarded + expected.counters.mergedFirst, c.isTangle ? 20u : 0u);
    }
}

// It is that of the draws, whatever their numbers.
TEST_F(RasterOrder, DrawsDecideTheOrder) {
    const Shot shot{.triangles = tangle(400), .change = addAmbient};
    ViewSettings merging = settings(AGAA_TIER_RASTER_ORDER, 64, 2), lists = settings(AGAA_TIER_MATERIAL_LISTS, 64, 2);
    const Kept merged = keep(merging, shot);
    merging.surface = lists.surface = "s.primitive = 399u - s.primitive;";
    EXPECT_EQ(keep(merging, shot).words, merged.words);
    EXPECT_NE(keep(lists, shot).words, merged.words);
}

// A frame leaves nothing of the one before.
TEST_F(RasterOrder, FramesBeginWithoutSurfaces) {
    StageView view(context, settings(AGAA_TIER_RASTER_ORDER));
    view.setTriangles(tangle(100));
    view.render(view.frame());
    EXPECT_NE(view.image(), std::vector<float>(view.image().size()));
    view.setTriangles({});
    view.render(view.frame());
    EXPECT_EQ(view.readBuffer("surfaces"), std::vector<uint32_t>(view.readBuffer("surfaces").size()));
}

// 112 bytes a pixel, with nothing beside them.
TEST_F(RasterOrder, MemoryIsThatOfTheSurfaces) {
    const StageView view(context, settings(AGAA_TIER_RASTER_ORDER));
    EXPECT_EQ(view.plan().totalBytes(), 112u * view.plan().width * view.plan().height);
    EXPECT_EQ(view.executor().resources->payloadBytes(), view.plan().totalBytes());
}

TEST_F(RasterOrder, IsRefusedWhereAttachmentsCannotHoldThePixel) {
    const std::string reason = expectRefused(context, settings(AGAA_TIER_RASTER_ORDER, 64, 5), AGAA_ERROR_UNSUPPORTED, "140 bytes");
    EXPECT_NE(reason.find("5 surfaces of this layout take 140"), std::string::npos) << reason;
}

// Outputs that the host declares are not read.
TEST(RasterOrderOfHostOutputs, IsRefused) {
    OpenGLHost::Context context(OpenGLHost::changed([](OpenGLContextDesc& desc) { desc.device.outputs = AGAA_GL_OUTPUTS_HOST; }));
    const std::string reason = expectRefused(context, dcaaSettings(64, 1, AGAA_TIER_RASTER_ORDER), AGAA_ERROR_UNSUPPORTED, "outputs");
    EXPECT_NE(reason.find("AGAA_GL_OUTPUTS_SDK"), std::string::npos) << reason;
}

} // namespace
} // namespace agaa::test
