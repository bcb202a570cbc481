// The tiers layers and nv-multicast (AGAA section 4.4): their patterns, plans, viewports, shaders and refusals. No
// device of the tests has run nv-multicast or set sample locations.
#include "plan_support.h"
#include "spirv_support.h"

#include "core/frame/host_pass.h"
#include "core/glsl/host_glsl.h"
#include "core/plan/sample_patterns.h"
#include "core/view/tiers.h"

#include "../../conformance/src/hosts/host_shaders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace agaa;
using namespace agaa::test;

namespace {

constexpr uint32_t bothTiers[] = {AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST};

ViewSpec layeredSpec(uint32_t samples, uint32_t tier = AGAA_TIER_LAYERS) {
    ViewSpec spec{.samples = samples};
    spec.visibilityTier = tier;
    return spec;
}

// A device with this number of samples and with 1.
AgaaDeviceCaps deviceWith(uint32_t hwSamples, bool placesSamples) {
    AgaaDeviceCaps caps = placesSamples ? idealDevice() : without(AGAA_DEVICE_SAMPLE_LOCATIONS);
    caps.sampleCounts = hwSamples | 1;
    return caps;
}

TEST(Layers, EachDividesTheSamplesByTwoFourOrEight) {
    const struct {
        uint32_t samples, hwSamples, layers;
    } rows[] = {{8, 4, 2}, {16, 4, 4}, {32, 4, 8}, {16, 8, 2}, {32, 8, 4}, {4, 2, 2}, {8, 1, 8}, {2, 1, 2}};
    for (const auto& row : rows)
        for (const bool places : {false, true}) {
            const Plan plan = planFor(layeredSpec(row.samples), deviceWith(row.hwSamples, places));
            EXPECT_EQ(plan.view.layers, row.layers) << row.samples << " of " << row.hwSamples;
            EXPECT_EQ(plan.view.hwSamples, row.hwSamples);
            EXPECT_EQ(plan.view.scaleX * plan.view.scaleY, 1u);
            EXPECT_EQ(plan.view.placesSamples, places && row.hwSamples > 1);
            EXPECT_EQ(plan.view.visibilityTier, AGAA_TIER_LAYERS);
        }
}

// Where samples can be placed, the pattern is that of a scaled target, up to the rounding to sixteenths of a pixel.
TEST(Layers, PlacedSamplesHaveThePatternOfAScaledTarget) {
    for (const uint32_t hwSamples : {2u, 4u, 8u, 16u})
        for (const uint32_t layers : {2u, 4u, 8u}) {
            const uint32_t samples = hwSamples * layers;
            if (samples > 32)
                continue;
            const AgaaDeviceCaps caps = deviceWith(hwSamples, true);
            const Plan layered = planFor(layeredSpec(samples), caps);
            const Plan scaled = planFor(layeredSpec(samples, AGAA_TIER_SCALED_TARGET), caps);
            ASSERT_EQ(layered.view.layers, scaled.view.scaleX * scaled.view.scaleY);
            const SamplePositions a = samplePositions(layered.view), b = samplePositions(scaled.view);
            // The 16 standard samples have odd and even coordinates, so that they are not all rounded alike.
            const float bound = hwSamples == 16 ? 1.0f / 64 : 0;
            for (uint32_t i = 0; i < samples; ++i) {
                EXPECT_LE(std::fabs(a[i].x - b[i].x), bound) << hwSamples << " x " << layers << ", sample " << i;
                EXPECT_LE(std::fabs(a[i].y - b[i].y), bound) << hwSamples << " x " << layers << ", sample " << i;
            }
            for (const SamplePosition& at : texelPositions(layered.view))
                for (const float coordinate : {at.x, at.y}) {
                    EXPECT_EQ(coordinate * 16, std::floor(coordinate * 16));
                    EXPECT_GE(coordinate, 0.0f);
                    EXPECT_LE(coordinate, 15.0f / 16);
                }
        }
}

TEST(Layers, UnplacedSamplesStayInThePixelAndShareNoRowOrColumn) {
    for (const uint32_t hwSamples : {1u, 2u, 4u, 8u})
        for (const uint32_t layers : {2u, 4u, 8u}) {
            const uint32_t samples = hwSamples * layers;
            if (samples > 32)
                continue;
            const Plan plan = planFor(layeredSpec(samples), deviceWith(hwSamples, false));
            ASSERT_EQ(plan.view.layers, layers);
            const SamplePositions positions = samplePositions(plan.view);
            std::set<float> columns, rows;
            for (uint32_t i = 0; i < samples; ++i) {
                for (const float coordinate : {positions[i].x, positions[i].y}) {
                    EXPECT_GT(coordinate, 0.0f);
                    EXPECT_LT(coordinate, 1.0f);
                    EXPECT_EQ(coordinate * 256, std::floor(coordinate * 256)) << "rasterisers round to 1/256";
                }
                columns.insert(positions[i].x);
                rows.insert(positions[i].y);
            }
            EXPECT_EQ(columns.size(), samples) << hwSamples << " x " << layers;
            EXPECT_EQ(rows.size(), samples) << hwSamples << " x " << layers;
        }
}

// A sample of a layer's texel, less the offset of the viewport, is where the shaders expect it.
TEST(Layers, ViewportsShowTheSamplesWhereTheFrameHasThem) {
    for (const bool places : {false, true})
        for (const uint32_t samples : {8u, 16u, 32u})
            for (const FrameExtent extent : {FrameExtent{640, 360}, FrameExtent{333, 7}}) {
                const Plan plan = planFor(layeredSpec(samples), deviceWith(4, places));
                const Pass& pass = passNamed(plan, "prepass");
                EXPECT_EQ(pass.draw().height, 360 * plan.view.layers);
                const FrameExtent target = targetExtent(plan, pass, extent);
                EXPECT_EQ(target.height, extent.height * plan.view.layers);
                const std::vector<AgaaViewport> list = viewports(plan, pass, extent);
                ASSERT_EQ(list.size(), plan.view.layers);
                const std::vector<SamplePosition> texel = texelPositions(plan.view);
                const SamplePositions positions = samplePositions(plan.view);
                for (uint32_t layer = 0; layer < list.size(); ++layer) {
                    const AgaaViewport& v = list[layer];
                    for (const float offset : {v.x, v.y})
                        EXPECT_EQ(offset * 256, std::floor(offset * 256)) << "rasterisers round to 1/256";
                    EXPECT_EQ(v.width, float(extent.width));
                    EXPECT_EQ(v.height, float(extent.height));
                    EXPECT_EQ(v.scissorX, 0u);
                    EXPECT_EQ(v.scissorY, layer * extent.height);
                    EXPECT_EQ(v.scissorWidth, extent.width);
                    EXPECT_EQ(v.scissorHeight, extent.height);
                    for (uint32_t s = 0; s < 4; ++s) {
                        EXPECT_EQ(texel[s].x - v.x, positions[4 * layer + s].x);
                        EXPECT_NEAR(texel[s].y - (v.y - float(v.scissorY)), positions[4 * layer + s].y, 1e-4f);
                    }
                }
            }
}

TEST(Layers, OtherTiersHaveOneViewport) {
    for (const uint32_t samples : {4u, 16u}) {
        const Plan plan = planFor({.samples = samples}, fourSampleDevice());
        const Pass& pass = passNamed(plan, "prepass");
        const std::vector<AgaaViewport> list = viewports(plan, pass, {320, 180});
        ASSERT_EQ(list.size(), 1u);
        EXPECT_EQ(list[0].x, 0.0f);
        EXPECT_EQ(list[0].y, 0.0f);
        EXPECT_EQ(list[0].width, 320.0f * float(plan.view.scaleX));
        EXPECT_EQ(list[0].scissorHeight, 180 * plan.view.scaleY);
        EXPECT_EQ(pass.draw().state.multicast, 0u);
        EXPECT_EQ(pass.draw().state.sampleLocations, 0u);
    }
}

// The layers of a target take what the texels of a scaled target take.
TEST(Layers, BytesAreThoseOfAScaledTarget) {
    for (const char* technique : {"agaa", "ssaa", "visibility", "simple_complex", "sbaa", "adaptive", "msaa"})
        for (const uint32_t samples : {8u, 16u})
            for (const uint32_t tier : bothTiers) {
                ViewSpec spec = layeredSpec(samples, tier);
                spec.technique = technique;
                const AgaaDeviceCaps caps = deviceWith(4, true);
                const Plan layered = planFor(spec, caps);
                spec.visibilityTier = AGAA_TIER_SCALED_TARGET;
                const Plan scaled = planFor(spec, caps);
                EXPECT_EQ(layered.totalBytes(), scaled.totalBytes()) << technique;
                EXPECT_EQ(layered.passes.size(), scaled.passes.size()) << technique;
            }
}

TEST(Layers, AutoSelectsNeither) {
    for (const uint32_t samples : {8u, 16u, 32u}) {
        AgaaDeviceCaps caps = idealDevice();
        caps.sampleCounts = 0b101;
        EXPECT_EQ(planFor({.samples = samples}, caps).view.visibilityTier, AGAA_TIER_SCALED_TARGET);
    }
}

TEST(Layers, EachRefusalHasItsSentence) {
    const auto expect = [](const std::string& message, const char* words) {
        EXPECT_NE(message.find(words), std::string::npos) << "\"" << message << "\" without " << words;
    };
    expect(refusal(layeredSpec(8, AGAA_TIER_NV_MULTICAST), without(AGAA_DEVICE_NV_MULTICAST)), "no viewport multicast");
    EXPECT_EQ(refusal(layeredSpec(8), without(AGAA_DEVICE_NV_MULTICAST)), "");
    expect(refusal(layeredSpec(1), idealDevice()), "1 samples cannot be made of up to 8 layers");
    expect(refusal(layeredSpec(32), deviceWith(1, true)), "32 samples cannot be made of up to 8 layers");
    // The standard pattern of 16 touches the border of the pixel.
    expect(refusal(layeredSpec(32), deviceWith(16, false)), "32 samples cannot be made of up to 8 layers");
    EXPECT_EQ(refusal(layeredSpec(32), deviceWith(16, true)), "");
    ViewSpec mixed = layeredSpec(8);
    mixed.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    expect(refusal(mixed, idealDevice()), "the device's own n samples");
    ViewSpec coverage = layeredSpec(64);
    coverage.technique = "dcaa";
    expect(refusal(coverage, idealDevice()), "coverage samples of \"dcaa\" are found by edges");
    AgaaDeviceCaps small = deviceWith(4, true);
    small.maxImageSize = 2000;
    EXPECT_EQ(refusal(layeredSpec(16), small), "");
    try { // 8 * 360 rows
        planFor(layeredSpec(32), small);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code, AGAA_ERROR_TOO_LARGE);
        expect(error.message, "640x2880 texels");
    }
}

TEST(Layers, CapabilitiesListThemAfterTheTiersOfAuto) {
    const auto tiers = [](const AgaaDeviceCaps& caps) {
        std::vector<uint32_t> list;
        for (const AgaaCapability& row : listCapabilities(techniques(), caps))
            if (std::string(row.technique) == "agaa" && row.samples == 8 && row.stage == AGAA_STAGE_PREPASS)
                list.push_back(row.tier);
        return list;
    };
    EXPECT_EQ(tiers(deviceWith(4, true)),
              (std::vector<uint32_t>{AGAA_TIER_SCALED_TARGET, AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST}));
    AgaaDeviceCaps caps = deviceWith(4, false);
    caps.flags &= ~AGAA_DEVICE_NV_MULTICAST;
    EXPECT_EQ(tiers(caps), (std::vector<uint32_t>{AGAA_TIER_SCALED_TARGET, AGAA_TIER_LAYERS}));
}

// ---- shaders ----

class LayersShaders : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

TEST_F(LayersShaders, MulticastIsInTheVertexShaderAndTheState) {
    for (const uint32_t samples : {8u, 16u, 32u}) {
        const Plan plan = planFor(layeredSpec(samples, AGAA_TIER_NV_MULTICAST), deviceWith(4, true));
        uint32_t draws = 0;
        const std::vector<HostPass> hostPasses = makeHostPasses(plan, HostDialect{});
        for (size_t i = 0; i < plan.passes.size(); ++i) {
            if (plan.passes[i].kind() != PassKind::HostDraw)
                continue;
            ++draws;
            EXPECT_EQ(plan.passes[i].draw().state.multicast, samples / 4);
            EXPECT_EQ(plan.passes[i].draw().state.sampleLocations, 1u);
            const HostPass& host = hostPasses[i];
            EXPECT_TRUE(host.geometry.empty());
            const auto [words, errors] = spirvOf(EShLangVertex, "#version 450\n" + host.extensions + host.vertex +
                                                                    "#define MULTICAST\n" + conformance::vertexShader);
            ASSERT_EQ(errors, "");
            EXPECT_EQ(validate(words), "");
            const std::string text = disassemble(words);
            for (const char* part : {"OpExtension \"SPV_NV_viewport_array2\"", "OpCapability ShaderViewportMaskNV",
                                     "BuiltIn ViewportMaskNV"})
                EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
            EXPECT_NE(text.find(" " + std::to_string((1u << samples / 4) - 1) + "\n"), std::string::npos) << text;
        }
        EXPECT_GE(draws, 1u);
    }
}

} // namespace
