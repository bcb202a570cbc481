// The probe of colour samples. The tests' drivers have no mixed samples: each sample is its own colour sample.
#include "gl/color_samples.h"
#include "core/base/error.h"
#include "gl/errors.h"
#include "gl/state_guard.h"
#include "support.h"

namespace agaa::test {
namespace {

using ColorSamples = BothProfiles;

TEST_P(ColorSamples, areThoseOfCoverageIfTheNumbersAreEqual) {
    const std::array<uint32_t, 4> expected{1, 2, 4, 8};
    EXPECT_EQ(gl::probeColorSamples(gl(), 4, 4), expected);
}

// The host's state does not change what is drawn.
TEST_P(ColorSamples, doNotDependOnTheHostsState) {
    gl().Enable(GL_SCISSOR_TEST);
    gl().Enable(GL_BLEND);
    gl().Enable(GL_SAMPLE_MASK);
    gl().SampleMaski(0, 0);
    gl().Enable(GL_RASTERIZER_DISCARD);
    gl().ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl().Disable(GL_MULTISAMPLE);
    gl().Enable(GL_DEPTH_TEST);
    gl().DepthFunc(GL_NEVER);
    gl().PixelStorei(GL_PACK_ROW_LENGTH, 77);
    const std::array<uint32_t, 4> expected{1, 2, 4, 8};
    EXPECT_EQ(gl::probeColorSamples(gl(), 4, 4), expected);
}

TEST_P(ColorSamples, areRefusedWithoutMixedSamples) {
    if (gl().NV_framebuffer_mixed_samples)
        GTEST_SKIP() << "the driver has mixed samples";
    try {
        gl::probeColorSamples(gl(), 4, 1);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code, AGAA_ERROR_UNSUPPORTED);
        EXPECT_NE(error.message.find("4 samples of depth and 1 of colour"), std::string::npos) << error.message;
    }
    gl::discardErrors(gl());
    context.takeMessages(); // Mesa reports that the framebuffer is incomplete
}

TEST_P(ColorSamples, leaveTheStateToTheGuard) {
    gl::StateGuard guard(gl(), testScope(), GetParam());
    const std::vector<StateText> before = read();
    guard.capture();
    gl::probeColorSamples(gl(), 4, 4);
    guard.restore();
    const std::vector<StateText> after = read();
    ASSERT_EQ(after.size(), before.size());
    for (size_t i = 0; i < after.size(); ++i)
        EXPECT_TRUE(after[i] == before[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(gl, ColorSamples, testing::Bool(), profileName);

} // namespace
} // namespace agaa::test
