// The state of the sample engine's pipelines for mixed samples, viewport multicast and sample locations. No device here
// has the extensions, so no pipeline is created.
#include "vk/pipeline_state.h"

#include <gtest/gtest.h>

namespace harness::vk {

namespace {

DrawPass<AgaaVkDrawPass> passOf(uint32_t samples, uint32_t colorSamples, bool additive) {
    DrawPass<AgaaVkDrawPass> pass{};
    pass.state.samples = samples;
    pass.state.colorSamples = colorSamples;
    pass.state.additive = additive;
    pass.state.colorAttachmentCount = 3;
    pass.state.colorWriteMask = 0xF;
    pass.state.depthCompare = AGAA_COMPARE_EQUAL;
    pass.state.stencilTest = pass.state.stencilTestMasked = 1;
    return pass;
}

TEST(PipelineStates, MixedSamplesTruncateCoverage) {
    const DrawPass<AgaaVkDrawPass> pass = passOf(8, 2, true);
    const PipelineState state(pass, false);
    EXPECT_EQ(state.multisample.rasterizationSamples, VK_SAMPLE_COUNT_8_BIT);
    EXPECT_FALSE(state.multisample.sampleShadingEnable);
    EXPECT_EQ(state.multisample.pSampleMask, nullptr);
    ASSERT_EQ(state.multisample.pNext, &state.reduction) << "and no modulation of coverage";
    EXPECT_EQ(state.reduction.sType, VK_STRUCTURE_TYPE_PIPELINE_COVERAGE_REDUCTION_STATE_CREATE_INFO_NV);
    EXPECT_EQ(state.reduction.pNext, nullptr);
    EXPECT_EQ(state.reduction.coverageReductionMode, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
    ASSERT_EQ(state.rendering.pNext, &state.mixed);
    EXPECT_EQ(state.mixed.sType, VK_STRUCTURE_TYPE_ATTACHMENT_SAMPLE_COUNT_INFO_NV);
    EXPECT_EQ(state.mixed.depthStencilAttachmentSamples, VK_SAMPLE_COUNT_8_BIT);
    ASSERT_EQ(state.mixed.colorAttachmentCount, 3u);
    for (uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(state.mixed.pColorAttachmentSamples[i], VK_SAMPLE_COUNT_2_BIT);
    EXPECT_FALSE(state.depthStencil.depthWriteEnable);
    EXPECT_EQ(state.depthStencil.depthCompareOp, VK_COMPARE_OP_EQUAL);
    EXPECT_TRUE(state.depthStencil.stencilTestEnable) << "the first of equal depths is kept";
}

TEST(PipelineStates, LayersHaveViewportsAndSampleLocations) {
    DrawPass<AgaaVkDrawPass> pass = passOf(8, 0, false);
    EXPECT_EQ(PipelineState(pass, false).viewports, 1u);
    EXPECT_EQ(PipelineState(pass, false).multisample.pNext, nullptr);
    pass.state.multicast = 4;
    pass.state.sampleLocations = 1;
    const PipelineState state(pass, false);
    EXPECT_EQ(state.viewports, 4u);
    ASSERT_EQ(state.multisample.pNext, &state.locations);
    EXPECT_EQ(state.locations.sType, VK_STRUCTURE_TYPE_PIPELINE_SAMPLE_LOCATIONS_STATE_CREATE_INFO_EXT);
    EXPECT_EQ(state.locations.pNext, nullptr);
    EXPECT_TRUE(state.locations.sampleLocationsEnable);
    EXPECT_EQ(state.locations.sampleLocationsInfo.sType, VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT);
}

TEST(PipelineStates, AdditivePassesAddToAllAttachments) {
    for (const bool additive : {true, false}) {
        const DrawPass<AgaaVkDrawPass> pass = passOf(4, additive ? 1 : 0, additive);
        const PipelineState state(pass, false);
        ASSERT_EQ(state.blends.size(), 3u);
        for (const VkPipelineColorBlendAttachmentState& blend : state.blends) {
            EXPECT_EQ(blend.blendEnable == VK_TRUE, additive);
            EXPECT_EQ(blend.colorWriteMask, 0xFu);
            if (!additive)
                continue;
            for (const VkBlendFactor factor : {blend.srcColorBlendFactor, blend.dstColorBlendFactor,
                                               blend.srcAlphaBlendFactor, blend.dstAlphaBlendFactor})
                EXPECT_EQ(factor, VK_BLEND_FACTOR_ONE);
            EXPECT_EQ(blend.colorBlendOp, VK_BLEND_OP_ADD);
            EXPECT_EQ(blend.alphaBlendOp, VK_BLEND_OP_ADD);
        }
        EXPECT_EQ(state.multisample.pNext == nullptr, !additive);
        EXPECT_EQ(state.rendering.pNext == nullptr, !additive);
    }
}

} // namespace

} // namespace harness::vk
