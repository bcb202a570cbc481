// Sizes and offsets of public structs on 64-bit hosts: a change here is a change of the ABI.
#include "agaa_gl.h"
#include "agaa_vk.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

static_assert(sizeof(void*) == 8, "the table below is for 64-bit hosts");

#define EXPECT_SIZE(type, size) EXPECT_EQ(sizeof(type), size_t(size))
#define EXPECT_OFFSET(type, member, offset) EXPECT_EQ(offsetof(type, member), size_t(offset))

TEST(Abi, HeadersComeFirst) {
#define CHECK_HEADER(type)                                                                         \
    EXPECT_OFFSET(type, sType, 0);                                                                 \
    EXPECT_OFFSET(type, structSize, 4);                                                            \
    EXPECT_OFFSET(type, pNext, 8)
    CHECK_HEADER(AgaaLog);
    CHECK_HEADER(AgaaLayout);
    CHECK_HEADER(AgaaConfig);
    CHECK_HEADER(AgaaAggregation);
    CHECK_HEADER(AgaaSceneFacts);
    CHECK_HEADER(AgaaViewDesc);
    CHECK_HEADER(AgaaDeviceCaps);
    CHECK_HEADER(AgaaMemoryReport);
    CHECK_HEADER(AgaaFrame);
    CHECK_HEADER(AgaaFrameStatistics);
    CHECK_HEADER(AgaaGBufferFunction);
    CHECK_HEADER(AgaaFetchFunction);
    CHECK_HEADER(AgaaShadowFunction);
    CHECK_HEADER(AgaaFrameValidation);
    CHECK_HEADER(AgaaGlRequirements);
    CHECK_HEADER(AgaaGlContextDesc);
    CHECK_HEADER(AgaaGlDrawPass);
    CHECK_HEADER(AgaaGlSurface);
    CHECK_HEADER(AgaaGlFrame);
    CHECK_HEADER(AgaaVkRequirements);
    CHECK_HEADER(AgaaVkSurface);
    CHECK_HEADER(AgaaVkContextDesc);
    CHECK_HEADER(AgaaVkDrawPass);
    CHECK_HEADER(AgaaVkFrame);
#undef CHECK_HEADER
}

TEST(Abi, Sizes) {
    EXPECT_SIZE(AgaaLog, 32);
    EXPECT_SIZE(AgaaLayoutAttribute, 40);
    EXPECT_SIZE(AgaaLayout, 544);
    EXPECT_SIZE(AgaaConfig, 88);
    EXPECT_SIZE(AgaaAggregation, 40);
    EXPECT_SIZE(AgaaSceneFacts, 32);
    EXPECT_SIZE(AgaaViewDesc, 48);
    EXPECT_SIZE(AgaaDeviceCaps, 304);
    EXPECT_SIZE(AgaaCapability, 272);
    EXPECT_SIZE(AgaaSurface, 120);
    EXPECT_SIZE(AgaaMemoryReport, 56);
    EXPECT_SIZE(AgaaTarget, 40);
    EXPECT_SIZE(AgaaDrawState, 36);
    EXPECT_SIZE(AgaaDrawTarget, 88);
    EXPECT_SIZE(AgaaLight, 64);
    EXPECT_SIZE(AgaaShadow, 392);
    EXPECT_SIZE(AgaaFrame, 248);
    EXPECT_SIZE(AgaaCounters, 128);
    EXPECT_SIZE(AgaaPassTime, 64);
    EXPECT_SIZE(AgaaFrameStatistics, 1216);
    EXPECT_SIZE(AgaaGBufferFunction, 56);
    EXPECT_SIZE(AgaaFetchFunction, 56);
    EXPECT_SIZE(AgaaShadowFunction, 48);
    EXPECT_SIZE(AgaaVkRequirements, 72);
    EXPECT_SIZE(AgaaVkSurface, 88);
    EXPECT_SIZE(AgaaVkContextDesc, 144);
    EXPECT_SIZE(AgaaVkDrawPass, 152);
    EXPECT_SIZE(AgaaVkFrame, 88);
    EXPECT_SIZE(AgaaFrameValidation, 768);
    EXPECT_SIZE(AgaaGlRequirements, 64);
    EXPECT_SIZE(AgaaGlContextDesc, 176);
    EXPECT_SIZE(AgaaGlDrawPass, 136);
    EXPECT_SIZE(AgaaGlSurface, 64);
    EXPECT_SIZE(AgaaGlFrame, 40);
}

TEST(Abi, Offsets) {
    EXPECT_OFFSET(AgaaConfig, technique, 16);
    EXPECT_OFFSET(AgaaConfig, layout, 32);
    EXPECT_OFFSET(AgaaConfig, flags, 80);
    EXPECT_OFFSET(AgaaFrame, view, 40);
    EXPECT_OFFSET(AgaaFrame, projection, 104);
    EXPECT_OFFSET(AgaaFrame, draw, 224);
    EXPECT_OFFSET(AgaaFrame, ditherFrame, 240);
    EXPECT_OFFSET(AgaaDrawTarget, pipelineKey, 56);
    EXPECT_OFFSET(AgaaVkFrame, shadowViews, 48);
    EXPECT_OFFSET(AgaaGlFrame, outputTexture, 16);
}

} // namespace
