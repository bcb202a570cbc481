// The tier nv-mixed-samples of "agaa": its plan, the state that hosts set, its shaders and its refusals. No device of
// the tests has run it.
#include "plan_support.h"
#include "spirv_support.h"

#include "core/base/error.h"
#include "core/glsl/aggregate_glsl.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/glsl_text.h"
#include "core/glsl/host_glsl.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace agaa;
using namespace agaa::test;

namespace {

ViewSpec mixedSpec(uint32_t samples = 8, uint32_t aggregates = 2, const char* layout = "paper16") {
    ViewSpec spec{.samples = samples, .aggregates = aggregates, .layout = layout};
    spec.visibilityTier = AGAA_TIER_NATIVE;
    spec.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    return spec;
}

std::vector<Format> formatsOf(const Plan& plan, const DrawPart& draw) {
    std::vector<Format> formats;
    for (const ResourceId target : draw.colorTargets)
        formats.push_back(plan.resources[target].format);
    return formats;
}

TEST(MixedSamples, ThePlanHasThePassesOfTwoGeometryPasses) {
    const Plan plan = planFor(mixedSpec(), idealDevice());
    std::vector<std::string> names;
    for (const Pass& pass : plan.passes)
        names.push_back(pass.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"prepass", "define aggregates", "generate aggregates", "shade aggregates"}));
    EXPECT_TRUE(plan.runnable);
    EXPECT_EQ(plan.view.generationTier, AGAA_TIER_NV_MIXED_SAMPLES);
    EXPECT_EQ(plan.geometryPasses(), 2u);
}

// Executors and hosts know of the tier what the draw says.
TEST(MixedSamples, TheDrawBlendsIntoFewerSamplesThanItTests) {
    for (const uint32_t aggregates : {1u, 2u, 3u, 4u}) {
        const Plan plan = planFor(mixedSpec(8, aggregates), idealDevice());
        const DrawPart& draw = passNamed(plan, "generate aggregates").draw();
        const uint32_t colorSamples = aggregates == 3 ? 4 : aggregates;
        EXPECT_EQ(draw.state.samples, 8u);
        EXPECT_EQ(draw.state.colorSamples, colorSamples);
        EXPECT_EQ(draw.state.additive, 1u);
        EXPECT_EQ(draw.state.keepFirst, 0u);
        EXPECT_EQ(draw.state.depthCompare, AGAA_COMPARE_EQUAL);
        EXPECT_EQ(draw.state.depthWrite, 0u);
        EXPECT_EQ(draw.state.stencilTest, 1u);
        EXPECT_EQ(draw.state.stencilTestMasked, 1u);
        EXPECT_EQ(draw.state.sampleShading, 0u);
        EXPECT_EQ(draw.state.colorWriteMask, 0xFu);
        EXPECT_EQ(draw.state.colorAttachmentCount, draw.colorTargets.size());
        EXPECT_TRUE(draw.clearsColor);
        EXPECT_FALSE(draw.clearsDepth);
        for (const ColorAttachment& color : colorAttachments(plan, passNamed(plan, "generate aggregates")))
            EXPECT_EQ(color.clear, (std::array<float, 4>{}));
        EXPECT_GE(draw.clear.color.size(), size_t(maxAttachments));
        EXPECT_EQ(plan.resources[draw.depthTarget].samples, 8u);
        for (const ResourceId target : draw.colorTargets) {
            EXPECT_EQ(plan.resources[target].samples, colorSamples);
            EXPECT_FALSE(isInteger(plan.resources[target].format)) << "integers do not blend";
        }
        EXPECT_EQ(draw.extensions,
                  (std::vector<std::string>{"ARB_post_depth_coverage", "NV_sample_mask_override_coverage"}));
    }
}

TEST(MixedSamples, WithASampleForEachAggregateNoSamplesAreMixed) {
    const Plan plan = planFor(mixedSpec(4, 4), idealDevice());
    const DrawPart& draw = passNamed(plan, "generate aggregates").draw();
    EXPECT_EQ(draw.state.colorSamples, 0u);
    EXPECT_EQ(draw.state.additive, 1u);
    EXPECT_EQ(plan.resources[draw.colorTargets[0]].samples, 4u);
}

// AGAA figure 7: 16 bytes for each aggregate, with eight bits of coverage.
TEST(MixedSamples, AggregatesHaveThePapersBytesInFormatsThatBlend) {
    const std::pair<uint32_t, std::vector<Format>> rows[] = {
        {8, {Format::RGBA16, Format::RGB10A2, Format::RGBA8}},
        {16, {Format::RGBA16, Format::RGB10A2, Format::RGBA8, Format::R8}},
        {32, {Format::RGBA16, Format::RGB10A2, Format::RGBA8, Format::RGBA8}}};
    for (const auto& [samples, formats] : rows) {
        const Plan plan = planFor(mixedSpec(samples), idealDevice());
        const DrawPart& draw = passNamed(plan, "generate aggregates").draw();
        EXPECT_EQ(formatsOf(plan, draw), formats) << samples;
        uint64_t bytes = 0;
        for (const ResourceId target : draw.colorTargets)
            bytes += plan.resources[target].bytes;
        EXPECT_EQ(bytes, uint64_t(plan.bytesPerAggregate) * 2 * 640 * 360);
        EXPECT_EQ(plan.bytesPerAggregate, samples == 8 ? 16u : samples == 16 ? 17u : 20u);
        EXPECT_DOUBLE_EQ(plan.bytesPerPixel(), 6.0 * samples + samples / 8.0 + 2.0 * plan.bytesPerAggregate);
    }
    const Plan precise = planFor(mixedSpec(8, 2, "precise"), idealDevice());
    EXPECT_EQ(formatsOf(precise, passNamed(precise, "generate aggregates").draw()),
              (std::vector<Format>{Format::RGBA16, Format::RGBA16, Format::RGBA16, Format::R16, Format::R8}));
}

TEST(MixedSamples, ChannelsHavePlacesOfTheirOwn) {
    for (const char* layout : {"paper16", "precise"})
        for (const uint32_t samples : {2u, 8u, 32u}) {
            AgaaLayout described = AGAA_LAYOUT_INIT;
            ASSERT_EQ(agaaGetBuiltinLayout(layout, &described), AGAA_OK);
            const BlendedPacking packing = packBlendedAggregate(checkLayout(&described), samples);
            std::vector<std::pair<uint32_t, uint32_t>> places{{packing.coverage.word, packing.coverage.shift}};
            for (const Field& field : packing.fields) {
                if (!field.bits)
                    continue;
                EXPECT_LT(field.word, packing.attachments.size());
                EXPECT_LT(field.shift, 4u);
                EXPECT_EQ(std::ranges::count(places, std::pair(field.word, field.shift)), 0);
                places.emplace_back(field.word, field.shift);
            }
            EXPECT_TRUE(packing.fields[ChannelNormalX].isSigned);
            EXPECT_FALSE(packing.fields[ChannelDiffuseR].isSigned);
        }
}

// A layout with custom attributes, chained by a view.
ViewSpec customSpec(uint32_t filter, uint32_t channels, AgaaLayout& layout) {
    EXPECT_EQ(agaaGetBuiltinLayout("paper16", &layout), AGAA_OK);
    layout.attributes[layout.attributeCount++] = {AGAA_SEMANTIC_CUSTOM,
                                                  channels,
                                                  8,
                                                  8,
                                                  0,
                                                  AGAA_ENCODING_UNORM,
                                                  filter == AGAA_FILTER_CLASS ? 255.0f : 1.0f,
                                                  filter,
                                                  "value",
                                                  {}};
    ViewSpec spec = mixedSpec();
    spec.change = [&](TechniqueConfig& config) { config.layout = &layout; };
    return spec;
}

TEST(MixedSamples, EachRefusalHasItsSentence) {
    const auto expect = [](const std::string& message, const char* words) {
        EXPECT_NE(message.find(words), std::string::npos) << "\"" << message << "\" without " << words;
    };
    expect(refusal(mixedSpec(), without(AGAA_DEVICE_NV_MIXED_SAMPLES)), "no mixed samples with coverage override");
    expect(refusal(mixedSpec(), without(AGAA_DEVICE_POST_DEPTH_COVERAGE)), "no post-depth coverage");
    expect(refusal(mixedSpec(), without(AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8)), "without a stencil test");
    EXPECT_EQ(refusal(mixedSpec(1, 1), without(AGAA_DEVICE_POST_DEPTH_COVERAGE)), "");
    EXPECT_EQ(refusal(mixedSpec(2, 4), idealDevice()), "") << "there are as many aggregates as samples";
    AgaaDeviceCaps few = idealDevice();
    few.sampleCounts = 0b101;
    ViewSpec scaled = mixedSpec();
    scaled.visibilityTier = AGAA_TIER_AUTO;
    expect(refusal(scaled, few), "the device's own n samples");
    ViewSpec spec = mixedSpec();
    spec.facts |= AGAA_FACT_CUSTOM_DEPTH;
    expect(refusal(spec, idealDevice()), "need the tier gbuffer");
    spec = mixedSpec();
    spec.change = [](TechniqueConfig& config) { config.measurement.flags = AGAA_MEASURE_NO_STENCIL; };
    expect(refusal(spec, idealDevice()), "without a stencil test");
    spec = mixedSpec(8, 2, "precise");
    spec.change = [](TechniqueConfig& config) { config.ndf = AGAA_NDF_LEAN; };
    expect(refusal(spec, idealDevice()), "moments of normals");
    spec = mixedSpec();
    spec.viewFlags = AGAA_VIEW_REVERSED_Z;
    expect(refusal(spec, without(AGAA_DEVICE_D32S8)), "without a stencil test");
    EXPECT_EQ(refusal(spec, without(AGAA_DEVICE_D24S8)), "");
    for (const uint32_t filter : {AGAA_FILTER_NONE, AGAA_FILTER_CLASS}) {
        AgaaLayout layout = AGAA_LAYOUT_INIT;
        expect(refusal(customSpec(filter, 1, layout), idealDevice()), "which are no sums");
    }
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    EXPECT_EQ(refusal(customSpec(AGAA_FILTER_MEAN, 4, layout), idealDevice()), "");
}

TEST(MixedSamples, AutoNeverSelectsIt) {
    for (const uint64_t flags : {UINT64_C(0), AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING}) {
        ViewSpec spec = mixedSpec();
        spec.generationTier = AGAA_TIER_AUTO;
        EXPECT_NE(planFor(spec, without(flags)).view.generationTier, AGAA_TIER_NV_MIXED_SAMPLES);
    }
    const Plan plan = planFor(mixedSpec(), idealDevice());
    EXPECT_TRUE(std::ranges::any_of(
        plan.notes, [](const std::string& note) { return note.find("not yet run on a device") != std::string::npos; }));
}

TEST(MixedSamples, HostsCannotReadTheAggregatesAsWords) {
    EXPECT_THROW(aggregateGlsl(planFor(mixedSpec(), idealDevice())), Error);
}

// ---- shaders ----

class MixedSamplesShaders : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

std::string mixedSamplesShader(const Plan& plan, const Pass& pass, const HostDialect& dialect, bool masked) {
    return "#version " + std::to_string(dialect.glslVersion) + "\n" + hostExtensions(plan, pass, dialect) +
           "#define AGAA_ALPHA_MASKED " + (masked ? "1\n" : "0\n") + hostDeclarations(plan, pass, dialect) + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = position;
    s.geometricNormal = agaa_planeNormal(position);
    s.alpha = uv.x;
    s.alphaCutoff = 0.5;
    s.diffuse = vec3(uv, 0.0);
    agaa_emit(s);
}
)";
}

template <typename Visit> void forEveryView(const Visit& visit) {
    for (const char* layout : {"paper16", "precise"})
        for (const uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
            for (const uint32_t aggregates : {1u, 2u, 3u, 4u})
                for (const uint64_t configFlags : {UINT64_C(0), AGAA_CONFIG_COUNTERS}) {
                    if (aggregates > samples)
                        continue;
                    ViewSpec spec = mixedSpec(samples, aggregates, layout);
                    spec.configFlags = configFlags;
                    visit(planFor(spec, idealDevice()));
                }
}

TEST_F(MixedSamplesShaders, TheHostsShaderIsValidSpirvThatOverridesTheCoverage) {
    int visited = 0;
    forEveryView([&](const Plan& plan) {
        const Pass& pass = passNamed(plan, "generate aggregates");
        const bool masked = ++visited & 1;
        const auto [words, errors] = spirvOf(EShLangFragment, mixedSamplesShader(plan, pass, HostDialect{}, masked));
        ASSERT_EQ(errors, "") << plan.view.samples << ' ' << plan.view.aggregates;
        EXPECT_EQ(validate(words), "");
        const std::string text = disassemble(words);
        for (const char* part :
             {"OpExtension \"SPV_NV_sample_mask_override_coverage\"", "OpCapability SampleMaskOverrideCoverageNV",
              "EarlyFragmentTests", "OverrideCoverageNV"})
            EXPECT_NE(text.find(part), std::string::npos) << part;
        for (const char* part : {"OpExtension \"SPV_KHR_post_depth_coverage\"",
                                 "OpCapability SampleMaskPostDepthCoverage", " PostDepthCoverage\n"})
            EXPECT_EQ(text.find(part) != std::string::npos, plan.view.samples > 1) << part;
        for (size_t i = 0; i < pass.draw().colorTargets.size(); ++i)
            EXPECT_NE(text.find("Location " + std::to_string(i) + "\n"), std::string::npos);
    });
    EXPECT_GT(visited, 30);
}

// The driver decides on OpenGL which samples reach a colour sample.
TEST_F(MixedSamplesShaders, RoutesAreThoseOfTheDialect) {
    const Plan plan = planFor(mixedSpec(), idealDevice());
    const Pass& pass = passNamed(plan, "generate aggregates");
    HostDialect dialect;
    EXPECT_NE(hostDeclarations(plan, pass, dialect).find("#define AGAA_ROUTES uvec4(1u, 2u, 4u, 8u)"),
              std::string::npos);
    const uint64_t key = hostPassKey(plan, pass, dialect);
    dialect.colorSampleMasks = {0x0F, 0xF0, 0, 0};
    EXPECT_NE(hostDeclarations(plan, pass, dialect).find("#define AGAA_ROUTES uvec4(15u, 240u, 0u, 0u)"),
              std::string::npos);
    EXPECT_NE(hostPassKey(plan, pass, dialect), key);
}

TEST_F(MixedSamplesShaders, TheHostsShaderCompilesForOpenGl) {
    for (const bool hostOutputs : {false, true}) {
        const Plan plan = planFor(mixedSpec(), idealDevice());
        HostDialect dialect;
        dialect.openGl = true;
        dialect.hostOutputs = hostOutputs;
        const std::string text = mixedSamplesShader(plan, passNamed(plan, "generate aggregates"), dialect, false);
        glslang::TShader shader(EShLangFragment);
        const char* source = text.c_str();
        shader.setStrings(&source, 1);
        EXPECT_TRUE(shader.parse(GetDefaultResources(), 110, false, EShMsgDefault)) << shader.getInfoLog();
    }
}

TEST_F(MixedSamplesShaders, TheShadingPassIsCompiledWithTheView) {
    forEveryView([](const Plan& plan) {
        const Pass& pass = passNamed(plan, "shade aggregates");
        if (plan.view.aggregates == 2 || plan.view.aggregates == 4 || plan.view.samples == 2 || plan.view.samples == 16)
            return; // others have the same text
        ASSERT_FALSE(pass.compute().text.empty());
        const std::vector<uint32_t> words = compileCompute(passGlsl(pass), "the pass");
        EXPECT_EQ(validate(words), "") << plan.view.samples << ' ' << plan.view.aggregates;
        glslang::TShader shader(EShLangCompute);
        const std::string text = passGlslForOpenGl(pass, 450);
        const char* source = text.c_str();
        shader.setStrings(&source, 1);
        EXPECT_TRUE(shader.parse(GetDefaultResources(), 110, false, EShMsgDefault)) << shader.getInfoLog();
    });
}

// Each binding of the plan is one that the shader declares, and the other way round.
TEST_F(MixedSamplesShaders, TheShadingPassFetchesAllAttachments) {
    forEveryView([](const Plan& plan) {
        const size_t targets = passNamed(plan, "generate aggregates").draw().colorTargets.size();
        const Pass& pass = passNamed(plan, "shade aggregates");
        size_t bound = 0;
        for (const ResourceId target : passNamed(plan, "generate aggregates").draw().colorTargets)
            bound += size_t(std::ranges::count(pass.bindings, target, &Binding::resource));
        EXPECT_EQ(bound, targets);
        EXPECT_NE(pass.compute().defines.find("#define AGAA_BLENDED_TARGETS " + std::to_string(targets) + "\n"),
                  std::string::npos);
    });
}

} // namespace
