// Sizes and offsets of public structs on 64-bit hosts: a change here is a change of the ABI.
#include "agaa_gl.h"
#include "agaa_vk.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

static_assert(sizeof(void*) == 8, "the table below is for 64-bit hosts");

#define EXPECT_SIZE(type, size) EXPECT_EQ(sizeof(type), size_t(size))
#define EXPECT_OFFSET(type, member, offset) EXPECT_EQ(offsetof(type, member), size_t(offset))

TEST(Abi, Sizes) {
    EXPECT_SIZE(AgaaLog, 32);
    EXPECT_SIZE(AgaaContextDesc, 56);
    EXPECT_SIZE(AgaaLayoutAttribute, 56);
    EXPECT_SIZE(AgaaLayout, 752);
    EXPECT_SIZE(AgaaConfig, 80);
    EXPECT_SIZE(AgaaAggregation, 40);
    EXPECT_SIZE(AgaaMeasurement, 48);
    EXPECT_SIZE(AgaaSceneFacts, 40);
    EXPECT_SIZE(AgaaViewDesc, 48);
    EXPECT_SIZE(AgaaDrawPass, 152);
    EXPECT_SIZE(AgaaLight, 64);
    EXPECT_SIZE(AgaaShadow, 392);
    EXPECT_SIZE(AgaaFrame, 280);
    EXPECT_SIZE(AgaaGBufferFunction, 56);
    EXPECT_SIZE(AgaaFetchFunction, 64);
    EXPECT_SIZE(AgaaShadowFunction, 48);
    EXPECT_SIZE(AgaaShadingFunction, 48);
    EXPECT_SIZE(AgaaResolvedOutput, 16);
    EXPECT_SIZE(AgaaResolvedOutputs, 120);
    EXPECT_SIZE(AgaaDeviceCaps, 304);
    EXPECT_SIZE(AgaaCapability, 304);
    EXPECT_SIZE(AgaaSurface, 144);
    EXPECT_SIZE(AgaaMemoryReport, 56);
    EXPECT_SIZE(AgaaTarget, 48);
    EXPECT_SIZE(AgaaPrice, 408);
    EXPECT_SIZE(AgaaFactReport, 656);
    EXPECT_SIZE(AgaaBreadcrumb, 72);
    EXPECT_SIZE(AgaaBreadcrumbs, 160);
    EXPECT_SIZE(AgaaFrameStatistics, 2912);
    EXPECT_SIZE(AgaaFrameValidation, 1120);
    EXPECT_SIZE(AgaaMeasuredSettings, 72);
    EXPECT_SIZE(AgaaGoal, 72);
    EXPECT_SIZE(AgaaObservation, 88);
    EXPECT_SIZE(AgaaChoice, 1400);
    EXPECT_SIZE(AgaaVkRequirements, 56);
    EXPECT_SIZE(AgaaVkDeviceDesc, 96);
    EXPECT_SIZE(AgaaVkAllocator, 40);
    EXPECT_SIZE(AgaaVkDrawPass, 72);
    EXPECT_SIZE(AgaaVkSurface, 56);
    EXPECT_SIZE(AgaaVkFrame, 88);
    EXPECT_SIZE(AgaaVkResolvedImages, 192);
    EXPECT_SIZE(AgaaGlRequirements, 56);
    EXPECT_SIZE(AgaaGlDeviceDesc, 144);
    EXPECT_SIZE(AgaaGlDrawPass, 56);
    EXPECT_SIZE(AgaaGlSurface, 32);
    EXPECT_SIZE(AgaaGlFrame, 40);
    EXPECT_SIZE(AgaaGlProgramCache, 32);
    EXPECT_SIZE(AgaaGlResolvedTextures, 48);
    EXPECT_SIZE(AgaaStructHeader, 16);
    EXPECT_SIZE(AgaaDrawState, 64);
    EXPECT_SIZE(AgaaGlslResource, 96);
    EXPECT_SIZE(AgaaDrawTarget, 160);
    EXPECT_SIZE(AgaaViewport, 32);
    EXPECT_SIZE(AgaaCounters, 256);
    EXPECT_SIZE(AgaaPassTime, 80);
    EXPECT_SIZE(AgaaInvalidPixel, 64);
    EXPECT_SIZE(AgaaVkAllocationInfo, 72);
    EXPECT_SIZE(AgaaVkMemory, 48);
}

TEST(Abi, Offsets) {
    EXPECT_OFFSET(AgaaDrawState, readsAttachments, 44);
    EXPECT_OFFSET(AgaaDrawState, additive, 48);
    EXPECT_OFFSET(AgaaDrawState, colorSamples, 52);
    EXPECT_OFFSET(AgaaDrawState, multicast, 56);
    EXPECT_OFFSET(AgaaDrawState, sampleLocations, 60);
    EXPECT_OFFSET(AgaaConfig, technique, 16);
    EXPECT_OFFSET(AgaaConfig, layout, 32);
    EXPECT_OFFSET(AgaaConfig, flags, 72);
    EXPECT_OFFSET(AgaaFrame, view, 40);
    EXPECT_OFFSET(AgaaFrame, projection, 104);
    EXPECT_OFFSET(AgaaFrame, lights, 184);
    EXPECT_OFFSET(AgaaFrame, draw, 232);
    EXPECT_OFFSET(AgaaFrame, facts, 248);
    EXPECT_OFFSET(AgaaFrame, exposure, 256);
    EXPECT_OFFSET(AgaaFrame, width, 260);
    EXPECT_OFFSET(AgaaFrame, outputX, 268);
    EXPECT_OFFSET(AgaaDrawTarget, state, 40);
    EXPECT_OFFSET(AgaaDrawTarget, pipelineKey, 104);
    EXPECT_OFFSET(AgaaDrawTarget, viewports, 144);
    EXPECT_OFFSET(AgaaTarget, layers, 40);
    EXPECT_OFFSET(AgaaGoal, measured, 56);
    EXPECT_OFFSET(AgaaFrameStatistics, counters, 56);
    EXPECT_OFFSET(AgaaFrameStatistics, variantFlags, 2880);
    EXPECT_OFFSET(AgaaVkFrame, shadowViews, 48);
    EXPECT_OFFSET(AgaaGlFrame, outputTexture, 16);
}

} // namespace
