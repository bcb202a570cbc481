// A G-buffer of the host's own, read by a function of the host's, against the one that the library lays out. Each
// graphics API instantiates these for its host, with Samples(drawn): what a view drew, its text as the function reads
// it, layout() and bind(frame).
#pragma once

#include "host_bench.h"
#include "shown.h"

#include "core/plan/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace agaa::test {

struct GBufferRow {
    const char* technique;
    uint32_t samples;
};

template <class Host> class HostGBufferCases : public testing::Test {
protected:
    using View = typename Host::View;

    static ViewSettings settingsFor(const char* technique, uint32_t n, const AgaaLayout* layout = nullptr) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.samples = n;
        settings.config.layout = layout;
        settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
        settings.facts.shadowMapCount = Host::shadowMaps;
        settings.config.adaptive.flags |= AGAA_ADAPTIVE_DEVICE_PATTERN; // which the host's own G-buffer has
        if (std::string(technique) == "agaa" || std::string(technique) == "sbaa")
            settings.config.generationTier = AGAA_TIER_GBUFFER;
        return settings;
    }

    // Renders in light through a map that casts no shadow, where there is one.
    // bind   Binds the resources that the function reads.
    std::vector<float> render(View& view, bool byFunction,
                              const std::function<void(typename Host::Frame&)>& bind = nullptr) {
        AgaaLight light = sun();
        const bool isMapped = view.settings().facts.shadowMapCount > 0;
        light.shadowMap = isMapped ? 0 : AGAA_NO_SHADOW;
        const AgaaShadow shadow = shadowAt(0.25f);
        const typename Host::ShadowMap map = Host::shadowMap(context, 0.5f);
        AgaaFrame frame = view.frame();
        setLight(frame, light, isMapped ? &shadow : nullptr);
        std::vector<AgaaLight> lights = manyLights(16, 2, 7); // some of which reach few tiles
        lights[0] = light;
        frame.lights = lights.data();
        frame.lightCount = uint32_t(lights.size());
        frame.background[2] = 0.5f;
        addAmbient(frame);
        if (byFunction)
            frame.draw = nullptr;
        Host::run(view, [&](typename Host::Frame& native) {
            Host::setShadowMap(native, map);
            if (bind)
                bind(native);
            EXPECT_EQ(Host::recordFrame(view.get(), &frame, &native), AGAA_OK);
        });
        return Host::rgba(view);
    }

    void expectSamePicture(const ViewSettings& settings) {
        View drawn(context, settings);
        drawn.setTriangles(randomTriangles({.triangles = 300, .duplicates = 0.1f, .masked = 0.2f}, 61));
        const std::vector<float> expected = render(drawn, false);
        const typename Host::Samples samples(drawn);
        const std::string text = samples.text();
        AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
        function.glsl = text.c_str();
        function.descriptorSetLayout = samples.layout();
        function.depthBits = drawn.plan().depthBits();
        ViewSettings own = settings;
        own.chained = &function;
        View view(context, own);
        EXPECT_EQ(view.plan().geometryPasses(), 0u);
        const std::vector<float> image = render(view, true, [&](auto& native) { samples.bind(native); });
        EXPECT_EQ(view.drawCalls, 0u);
        size_t different = 0, lit = 0;
        const size_t values = image.size() / 4 * 3;
        for (size_t i = 0; i < image.size(); ++i) {
            different += !(std::fabs(image[i] - expected[i]) <= 1e-3f * (1 + std::fabs(expected[i])));
            lit += i % 4 < 3 && expected[i] > 0.6f;
        }
        EXPECT_GT(lit, values / 20);
        // Seeds and thresholds where last bits decide. In "visibility" each sample has some.
        const bool isVisibility = std::string(settings.config.technique) == "visibility";
        EXPECT_LE(different, values / (isVisibility ? 150 : 500));
        const AgaaCounters a = drawn.statistics().counters, b = view.statistics().counters;
        EXPECT_GT(a.visible, 0u);
        EXPECT_EQ(a.visible, b.visible);
        EXPECT_EQ(a.once, b.once);
        EXPECT_EQ(b.uncovered + b.overlapping + b.misplaced, 0u);
        EXPECT_NEAR(double(a.shadingEvents), double(b.shadingEvents), 2e-3 * double(a.shadingEvents));
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(HostGBufferCases);

TYPED_TEST_P(HostGBufferCases, ShowsWhatTheLibrarysOwnShows) {
    for (const auto& [technique, n] : TypeParam::rows) {
        SCOPED_TRACE(std::string(technique) + " n=" + std::to_string(n));
        this->expectSamePicture(this->settingsFor(technique, n));
    }
}

TYPED_TEST_P(HostGBufferCases, FillsEveryLayout) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout("paper16", &layout);
    this->expectSamePicture(this->settingsFor("agaa", 8, &layout));
    ViewSettings reversed = this->settingsFor("agaa", 8);
    reversed.facts.shadowMapCount = 1 - TypeParam::shadowMaps;
    reversed.flags = AGAA_VIEW_REVERSED_Z;
    reversed.projection = reversedInfinite(60, 1.5f, 0.1f);
    this->expectSamePicture(reversed);
}

// A host whose sample positions are none of a rasteriser's: a plane's depth at them must give the plane back, so
// that all its samples are one aggregate and none is parted by k.
TYPED_TEST_P(HostGBufferCases, SamplesLieWhereTheHostSays) {
    ViewSettings settings = this->settingsFor("agaa", 4);
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
    vec2 ray = ndc / vec2()" +
               std::to_string(settings.projection[0][0]) + ", " + std::to_string(settings.projection[1][1]) + R"();
    float z = -4.0 / (1.0 + ray.y); // p = -z (ray, -1)
    depth = ()" +
               std::to_string(settings.projection[2][2]) + " * z + (" + std::to_string(settings.projection[3][2]) +
               R"()) / -z;
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
        typename TypeParam::View view(this->context, settings);
        this->render(view, true);
        const AgaaCounters c = view.statistics().counters;
        EXPECT_EQ(c.shadedPixels, 48u * 32u);
        return double(c.shadingEvents) / double(c.shadedPixels);
    };
    EXPECT_LT(eventsPerPixel(positions, positions), 1.01);
    float others[8] = {0.97f, 0.1f, 0.03f, 0.89f, 0.6f, 0.95f, 0.39f, 0.07f};
    EXPECT_GT(eventsPerPixel(positions, others), 1.5) << "places matter";
}

// A grid of pixels, one sample of which has a bad value of one attribute, or of all in the last row. fill.x selects
// good values, the bad ones, or those that replace them.
inline std::string badSamplesText(const char* place, uint32_t samples) {
    return std::string("layout(std430, ") + place + R"() readonly buffer Data { vec4 fill; } data;
const uint bits[11] = uint[11](0x7FC00000u, 0xFFC00001u, 0x7F800001u, 0x7F800000u, 0xFF800000u, 0xBF800000u,
                               0xC77FE000u, 0x477FE000u, 0x7149F2CAu, 0x7F7FFFFFu, 0x000116C2u);
float pick(uint column, float good, float low, float high) {
    float x = uintBitsToFloat(bits[column]);
    bool isFinite = (bits[column] & 0x7F800000u) != 0x7F800000u;
    return data.fill.x == 0.0 ? good : data.fill.x == 1.0 ? x : isFinite ? clamp(x, low, high) : low;
}
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    depth = 0.9;
    uvec2 cell = pixel / 3u;
    if (pixel % 3u != uvec2(1u) || i + 1u != )" +
           std::to_string(samples) + R"(u || cell.x >= 11u || cell.y > 6u)
        return true;
    bool isAll = cell.y == 6u;
    if (isAll || cell.y == 0u)
        m.diffuse.y = pick(cell.x, 0.4, 0.0, 1.0);
    if (isAll || cell.y == 1u)
        m.specular.y = pick(cell.x, 0.1, 0.0, 1.0);
    if (isAll || cell.y == 2u)
        m.emissive.y = pick(cell.x, 0.5, 0.0, 16.0);
    if (isAll || cell.y == 3u)
        m.alpha2 = pick(cell.x, 0.3, 4.100625e-6, 1.0);
    if (isAll || cell.y == 4u) {
        float x = pick(cell.x, 0.2, -3.4e38, 3.4e38);
        m.normal.x = data.fill.x == 2.0 && (bits[cell.x] & 0x7F800000u) == 0x7F800000u ? 0.0 : x;
    }
    if (isAll || cell.y == 5u)
        depth = pick(cell.x, 0.8, 0.0, 1.0);
    return true;
}
)";
}

TYPED_TEST_P(HostGBufferCases, HardCase37BadSamplesAreContained) {
    constexpr uint32_t width = 48;
    std::string last;
    for (const auto& [technique, n] : TypeParam::rows) {
        if (n == 1 || technique == last)
            continue;
        last = technique;
        SCOPED_TRACE(technique);
        const std::string text = badSamplesText(TypeParam::FunctionData::place, n);
        AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
        function.glsl = text.c_str();
        const typename TypeParam::FunctionData fills[] = {typename TypeParam::FunctionData({glm::vec4(0)}),
                                                          typename TypeParam::FunctionData({glm::vec4(1)}),
                                                          typename TypeParam::FunctionData({glm::vec4(2)})};
        function.descriptorSetLayout = fills[0].layout();
        ViewSettings settings = this->settingsFor(technique, n);
        settings.chained = &function;
        typename TypeParam::View view(this->context, settings);
        const auto image = [&](size_t fill) {
            return this->render(view, true, [&](auto& native) { fills[fill].bind(native); });
        };
        const std::vector<float> good = image(0), bad = image(1), replaced = image(2);
        size_t changed = 0;
        for (size_t i = 0; i < bad.size(); ++i) {
            const size_t x = i / 4 % width, y = i / 4 / width;
            ASSERT_TRUE(std::isfinite(bad[i]) && bad[i] >= 0) << x << ", " << y;
            ASSERT_EQ(bad[i], replaced[i]) << x << ", " << y;
            // "visibility" gives light to the pixels around.
            if ((x % 3 != 1 || y % 3 != 1) && std::string(technique) != "visibility") {
                ASSERT_EQ(bad[i], good[i]) << x << ", " << y << ": a neighbour";
            }
            changed += bad[i] != good[i];
        }
        EXPECT_GT(changed, 20u);
    }
}

// Stripes move by four pixels and become darker. fill.x has the pixels, and fill.y the light.
inline std::string movingStripesText(const char* place, bool isTold) {
    return std::string("layout(std430, ") + place + R"() readonly buffer Data { vec4 fill; } data;
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    depth = 0.5;
    int stripe = int(floor((float(pixel.x) - data.fill.x) / 4.0));
    m.emissive = data.fill.y * vec3(0.1 * float(stripe & 7), 0.3, 0.5);
    m.diffuse = m.specular = vec3(0.0);
    m.velocity = ()" +
           (isTold ? "32768.0 + 32767.0 * vec2(-4.0 / 48.0, 0.0)" : "vec2(0.0)") + R"() / 65535.0;
    return true;
}
)";
}

TYPED_TEST_P(HostGBufferCases, HistoryFollowsMotionVectorsOfTheHost) {
    const AgaaLayout layout = layoutWithVelocity();
    for (const bool isTold : {true, false}) {
        const std::string text = movingStripesText(TypeParam::FunctionData::place, isTold);
        const typename TypeParam::FunctionData fills[] = {typename TypeParam::FunctionData({glm::vec4(0, 1, 0, 0)}),
                                                          typename TypeParam::FunctionData({glm::vec4(4, 0.5f, 0, 0)})};
        AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
        function.glsl = text.c_str();
        function.descriptorSetLayout = fills[0].layout();
        ViewSettings settings = this->settingsFor("taa", 1, &layout);
        settings.facts.shadowMapCount = 0;
        settings.config.temporal.motion = "velocity";
        settings.config.temporal.clipDeviations = 0;
        settings.chained = &function;
        typename TypeParam::View view(this->context, settings);
        AgaaTemporalFrame history = AGAA_TEMPORAL_FRAME_INIT;
        std::copy_n(&settings.projection[0][0], 16, history.previousProjection);
        std::vector<float> image;
        for (const auto& fill : fills) {
            AgaaFrame frame = view.frame();
            frame.pNext = &history;
            frame.draw = nullptr;
            frame.lightCount = 0;
            TypeParam::run(view, [&](typename TypeParam::Frame& native) {
                fill.bind(native);
                EXPECT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_OK);
            });
            image = TypeParam::rgba(view);
            history.resets = 0;
        }
        double largest = 0;
        for (int x = 6; x < 46; ++x) // what came from outside has no history
            for (int y = 0; y < 32; ++y) {
                const float expected = 0.75f * 0.1f * float((x - 4) / 4 & 7);
                largest = std::max(largest, double(std::fabs(image[4 * size_t(48 * y + x)] - expected)));
            }
        if (isTold) {
            EXPECT_LT(largest, 2e-3);
        } else {
            EXPECT_GT(largest, 0.03);
        }
    }
}

TYPED_TEST_P(HostGBufferCases, BadOnesAreRefusedInASentence) {
    constexpr const char* good =
        "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    struct Row {
        const char* what;
        AgaaResult code;
        std::function<void(AgaaGBufferFunction&, ViewSettings&)> spoil;
        const char* contained = "";
    };
    static AgaaShadowFunction shadows = AGAA_SHADOW_FUNCTION_INIT;
    static AgaaGBufferFunction second = AGAA_GBUFFER_FUNCTION_INIT;
    static float positions[16];
    shadows.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    shadows.shadows = 1;
    shadows.descriptorSetLayout = 1;
    const Row rows[] = {
        {"no text", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = nullptr; }},
        {"does not compile", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = "float x = ;"; },
         "AgaaGBufferFunction::glsl"},
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
        {"a technique that draws", AGAA_ERROR_UNSUPPORTED, [](auto&, auto& s) { s.config.technique = "msaa"; }},
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
        ViewSettings settings = this->settingsFor("agaa", 8);
        row.spoil(function, settings);
        settings.chained = &function;
        const std::string text = expectRefused(this->context, settings, row.code, row.what);
        EXPECT_NE(text.find(row.contained), std::string::npos) << text;
    }
    TypeParam::forgetMessages(); // of the compiler
}

REGISTER_TYPED_TEST_SUITE_P(HostGBufferCases, ShowsWhatTheLibrarysOwnShows, FillsEveryLayout,
                            SamplesLieWhereTheHostSays, HardCase37BadSamplesAreContained,
                            HistoryFollowsMotionVectorsOfTheHost, BadOnesAreRefusedInASentence);

} // namespace agaa::test
