// A G-buffer of the host's own, read by a function of the host's, against the one that the library lays out.
#include "stage_host.h"

#include "shader_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace agaa::test {
namespace {

// A buffer of four vectors a sample; the first one's w is negative where nothing shows.
std::string functionText(const ViewSettings& settings) {
    return R"(
struct HostSample { vec4 diffuseDepth, specularAlpha2, emissive, normal; };
layout(std430, set = 1, binding = 0) readonly buffer Samples { HostSample samples[]; } host;
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    HostSample h = host.samples[(pixel.y * )" +
           std::to_string(settings.width) + "u + pixel.x) * " + std::to_string(settings.config.samples) + R"(u + i];
    depth = h.diffuseDepth.w;
    m.diffuse = h.diffuseDepth.xyz;
    m.specular = h.specularAlpha2.xyz;
    m.emissive = h.emissive.xyz;
    m.normal = h.normal.xyz;
    m.alpha2 = h.specularAlpha2.w;
    return h.diffuseDepth.w >= 0.0;
}
)";
}

// What a view drew, decoded.
std::vector<glm::vec4> decodedSamples(const StageView& drawn) {
    const Plan& plan = drawn.plan();
    const GBufferPacking packing = packGBuffer(plan.layout);
    const auto depth = drawn.readSurface("depth");
    std::vector<std::vector<glm::uvec4>> attachments;
    for (size_t i = 0; i < packing.attachments.size(); ++i)
        attachments.push_back(drawn.readSurface("gbuffer-" + std::to_string(i)));
    std::vector<glm::vec4> out;
    for (uint32_t y = 0; y < plan.height; ++y)
        for (uint32_t x = 0; x < plan.width; ++x)
            for (uint32_t i = 0; i < plan.samples; ++i) {
                const size_t at = drawn.sampleIndex(x, y, i);
                const auto value = [&](size_t channel, float absent) {
                    const Field& f = packing.fields[channel];
                    return f.bits ? std::bit_cast<float>(attachments[f.word][at][int(f.shift)]) : absent;
                };
                const bool isCovered = value(ChannelNormalX, 0) != 0;
                const float range = plan.layout.emissiveRange();
                const glm::dvec3 n = math_d::agaa_decodeOct(
                    {double(value(ChannelNormalX, 0)), double(value(ChannelNormalY, 0))},
                    packing.fields[ChannelNormalX].bits);
                const glm::vec3 diffuse(value(ChannelDiffuseR, 0), value(ChannelDiffuseG, 0),
                                        value(ChannelDiffuseB, 0));
                glm::vec3 emissive(value(ChannelEmissiveR, 0), value(ChannelEmissiveG, 0),
                                   value(ChannelEmissiveB, 0));
                if (plan.layout[AGAA_SEMANTIC_EMISSIVE].channels == 1)
                    emissive = emissive.x * diffuse;
                out.emplace_back(diffuse, isCovered ? std::bit_cast<float>(depth[at].x) : -1.0f);
                out.emplace_back(value(ChannelSpecularR, 0), value(ChannelSpecularG, 0),
                                 value(ChannelSpecularB, 0), value(ChannelRoughness, 1));
                out.emplace_back(range * emissive, 0);
                out.emplace_back(glm::vec3(n), 0);
            }
    return out;
}

class HostSamples {
public:
    explicit HostSamples(const std::vector<glm::vec4>& samples)
        : arena_(sharedDevice()), set_(sharedDevice(), 1, VK_SHADER_STAGE_COMPUTE_BIT) {
        buffer_ = arena_.hostBuffer(samples.size() * sizeof samples[0], VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        std::memcpy(buffer_.mapped, samples.data(), samples.size() * sizeof samples[0]);
        set_.write({buffer_.buffer.get()});
    }
    uint64_t layout() const { return (uint64_t)set_.layout(); }
    uint64_t set() const { return (uint64_t)set_.get(); }

private:
    harness::vk::Arena arena_;
    harness::vk::BufferResource buffer_;
    StorageSet set_;
};

ViewSettings settingsFor(const char* technique, uint32_t n, const AgaaLayout* layout = nullptr) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.samples = n;
    settings.config.layout = layout;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    if (std::string(technique) == "agaa" || std::string(technique) == "sbaa")
        settings.config.generationTier = AGAA_TIER_GBUFFER;
    return settings;
}

AgaaFrame litFrame(StageView& view, const AgaaLight& light) {
    AgaaFrame frame = view.frame();
    frame.lights = &light;
    frame.lightCount = 1;
    frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 0.25f;
    frame.background[2] = 0.5f;
    return frame;
}

harness::Image render(StageView& view, const HostSamples* host) {
    const AgaaLight light = sun();
    AgaaFrame frame = litFrame(view, light);
    if (host)
        frame.draw = nullptr;
    view.render(frame, [&](AgaaVkFrame& vk) { vk.functionSet = host ? host->set() : 0; });
    return view.image();
}

void expectSamePicture(StageContext& context, const ViewSettings& settings) {
    StageView drawn(context, settings);
    drawn.setTriangles(randomTriangles({.triangles = 300, .duplicates = 0.1f, .masked = 0.2f}, 61));
    const harness::Image expected = render(drawn, nullptr);
    const HostSamples host(decodedSamples(drawn));
    const std::string text = functionText(settings);
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    function.glsl = text.c_str();
    function.descriptorSetLayout = host.layout();
    function.depthBits = drawn.plan().depthBits;
    ViewSettings own = settings;
    own.chained = &function;
    StageView view(context, own);
    EXPECT_EQ(view.plan().geometryPasses(), 0u);
    const harness::Image image = render(view, &host);
    EXPECT_EQ(view.drawCalls, 0u);
    size_t different = 0, lit = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        different += !(std::fabs(image.rgb[i] - expected.rgb[i]) <= 1e-3f * (1 + std::fabs(expected.rgb[i])));
        lit += expected.rgb[i] > 0.6f;
    }
    EXPECT_GT(lit, image.rgb.size() / 20);
    // Seeds and thresholds where last bits decide.
    EXPECT_LE(different, image.rgb.size() / 500);
    const AgaaCounters a = drawn.statistics().counters, b = view.statistics().counters;
    EXPECT_EQ(a.visible, b.visible);
    EXPECT_EQ(a.once, b.once);
    EXPECT_EQ(b.uncovered + b.overlapping + b.misplaced, 0u);
    EXPECT_NEAR(double(a.shadingEvents), double(b.shadingEvents), 2e-3 * double(a.shadingEvents));
}

TEST(HostGBuffer, ShowsWhatTheLibrarysOwnShows) {
    StageContext context;
    const std::pair<const char*, uint32_t> rows[] = {{"single", 1}, {"fxaa", 1},           {"ssaa", 4},
                                                     {"sbaa", 8},   {"simple_complex", 4}, {"agaa", 1},
                                                     {"agaa", 4},   {"agaa", 8},           {"agaa", 32}};
    for (const auto& [technique, n] : rows) {
        SCOPED_TRACE(std::string(technique) + " n=" + std::to_string(n));
        expectSamePicture(context, settingsFor(technique, n));
    }
}

TEST(HostGBuffer, FillsEveryLayout) {
    StageContext context;
    AgaaLayout layout;
    agaaGetBuiltinLayout("paper16", &layout);
    expectSamePicture(context, settingsFor("agaa", 8, &layout));
    ViewSettings reversed = settingsFor("agaa", 8);
    reversed.flags = AGAA_VIEW_REVERSED_Z;
    reversed.projection = reversedInfinite(60, 1.5f, 0.1f);
    expectSamePicture(context, reversed);
}

// A host whose sample positions are none of a rasteriser's: a plane's depth at them must give the plane back, so
// that all its samples are one aggregate and none is parted by k.
TEST(HostGBuffer, SamplesLieWhereTheHostSays) {
    StageContext context;
    const HostSamples host({glm::vec4(0)});
    ViewSettings settings = settingsFor("agaa", 4);
    settings.config.aggregates = 4;
    settings.config.aggregation.characteristicLengthPerDistance = 1e-6f;
    settings.config.aggregation.aggregateThreshold = 1e-3f;
    float positions[8] = {0.03f, 0.9f, 0.97f, 0.11f, 0.4f, 0.05f, 0.61f, 0.93f};
    // The plane z = -4 + y of view space, by the ray through each sample.
    const auto text = [&](const float* at) {
        std::string list;
        for (int i = 0; i < 8; ++i)
            list += (i ? ", " : "") + std::to_string(at[i]);
        return "const float at[8] = float[8](" + list + R"();
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    vec2 ndc = (vec2(pixel) + vec2(at[2u * i], at[2u * i + 1u])) / vec2(48.0, 32.0) * 2.0 - 1.0;
    vec2 ray = ndc / vec2()" + std::to_string(settings.projection[0][0]) + ", " +
               std::to_string(settings.projection[1][1]) + R"();
    float z = -4.0 / (1.0 + ray.y); // p = -z (ray, -1)
    depth = ()" + std::to_string(settings.projection[2][2]) + " * z + (" +
               std::to_string(settings.projection[3][2]) + R"()) / -z;
    m.normal = normalize(vec3(0.0, -1.0, 1.0));
    return true;
}
)";
    };
    const auto eventsPerPixel = [&](const float* drawnAt, const float* saidAt) {
        const std::string glsl = text(drawnAt);
        AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
        function.glsl = glsl.c_str();
        function.samplePositions = saidAt;
        settings.chained = &function;
        StageView view(context, settings);
        render(view, &host);
        const AgaaCounters c = view.statistics().counters;
        EXPECT_EQ(c.shadedPixels, 48u * 32u);
        return double(c.shadingEvents) / double(c.shadedPixels);
    };
    EXPECT_LT(eventsPerPixel(positions, positions), 1.01);
    float others[8] = {0.97f, 0.1f, 0.03f, 0.89f, 0.6f, 0.95f, 0.39f, 0.07f};
    EXPECT_GT(eventsPerPixel(positions, others), 1.5) << "places matter";
}

TEST(HostGBuffer, WhatIsNotFiniteIsContained) {
    StageContext context;
    const HostSamples host({glm::vec4(0)});
    for (const char* bad : {"0.0 / (m.alpha2 - m.alpha2)", "1.0 / (m.alpha2 - m.alpha2)", "-1e30", "1e30"})
        for (const char* technique : {"simple_complex", "agaa"}) {
            const std::string text = std::string("bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {\n"
                                                 "    float bad = ") +
                                     bad +
                                     ";\n    depth = bad;\n    m = AgaaMaterial(vec3(bad), vec3(bad), vec3(bad), vec3(bad), bad, vec3(bad), vec3(bad));\n"
                                     "    return true;\n}\n";
            AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
            function.glsl = text.c_str();
            ViewSettings settings = settingsFor(technique, 4);
            settings.chained = &function;
            StageView view(context, settings);
            for (float value : render(view, &host).rgb) {
                ASSERT_TRUE(std::isfinite(value)) << bad << ' ' << technique;
                ASSERT_GE(value, 0.0f);
            }
        }
}

TEST(HostGBuffer, BadOnesAreRefusedInASentence) {
    StageContext context;
    constexpr const char* good =
        "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    struct Row {
        const char* what;
        AgaaResult code;
        std::function<void(AgaaGBufferFunction&, ViewSettings&)> spoil;
    };
    static AgaaShadowFunction shadows = AGAA_SHADOW_FUNCTION_INIT;
    static AgaaGBufferFunction second = AGAA_GBUFFER_FUNCTION_INIT;
    static float positions[16];
    shadows.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    shadows.shadows = 1;
    shadows.descriptorSetLayout = 1;
    const Row rows[] = {
        {"no text", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = nullptr; }},
        {"does not compile", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = "float x = ;"; }},
        {"no function", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = "float other;"; }},
        {"depth bits", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&) { f.depthBits = 32; }},
        {"reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&) { f.reserved = 1; }},
        {"size", AGAA_ERROR_STRUCT, [](auto& f, auto&) { f.structSize = 8; }},
        {"twice", AGAA_ERROR_UNKNOWN_STRUCT, [](auto& f, auto&) { f.pNext = &second; }},
        {"a place outside", AGAA_ERROR_OUT_OF_RANGE,
         [](auto& f, auto&) {
             positions[5] = 1.0f;
             f.samplePositions = positions;
         }},
        {"a place that is none", AGAA_ERROR_OUT_OF_RANGE,
         [](auto& f, auto&) {
             positions[5] = std::numeric_limits<float>::quiet_NaN();
             f.samplePositions = positions;
         }},
        {"extensions", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glslExtensions = "float x;"; }},
        {"another tier", AGAA_ERROR_UNSUPPORTED,
         [](auto&, auto& s) { s.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS; }},
        {"a technique that draws", AGAA_ERROR_UNSUPPORTED,
         [](auto&, auto& s) { s.config.technique = "msaa"; }},
        {"two set layouts", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& f, auto& s) {
             s.facts.shadowMapCount = 1;
             f.descriptorSetLayout = 2;
             f.pNext = &shadows;
         }},
    };
    for (const Row& row : rows) {
        AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
        function.glsl = good;
        ViewSettings settings = settingsFor("agaa", 8);
        row.spoil(function, settings);
        settings.chained = &function;
        expectRefused(context, settings, row.code, row.what);
    }
}

} // namespace
} // namespace agaa::test
