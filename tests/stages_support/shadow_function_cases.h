// Shadows by a function of the host's, with resources of its own. Each graphics API instantiates these for its host.
#pragma once

#include "host_bench.h"
#include "shading_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace agaa::test {

constexpr const char* allLitText = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";

inline AgaaShadowFunction shadowFunction(const char* text, uint32_t shadows) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = text;
    function.shadows = shadows;
    return function;
}

template <class Host> class ShadowFunctionCases : public testing::Test {
protected:
    using View = typename Host::View;

    static ViewSettings settingsFor(const char* technique, const AgaaShadowFunction& function, uint32_t shadows) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
        settings.facts.shadowMapCount = shadows;
        settings.chained = &function;
        return settings;
    }

    static std::vector<Triangle> scene() {
        std::vector<Triangle> list = randomTriangles({.triangles = 200}, 71);
        for (Triangle& t : list)
            t.material.emissive = glm::vec4(0);
        return list;
    }

    // Shadow 0 is a map where `mapped`, all others are the function's.
    void expectOracle(const char* technique, bool mapped) {
        SCOPED_TRACE(std::string(technique) + (mapped ? " beside a map" : " alone"));
        constexpr float threshold = 0.5f;
        const typename Host::FunctionData data({glm::vec4(threshold)});
        const std::string text = std::string("layout(std430, ") + Host::FunctionData::place +
                                 ") readonly buffer Data { float threshold; } data;\n"
                                 "float agaaHostShadow(uint shadow, vec3 position) {\n"
                                 "    return position.x > data.threshold ? 0.75 : 0.125 * float(shadow);\n}\n";
        AgaaShadowFunction function = shadowFunction(text.c_str(), mapped ? 0b10 : 0b11);
        function.descriptorSetLayout = data.layout();
        View view(context, settingsFor(technique, function, 2));
        view.setTriangles(scene());
        AgaaShadow shadows[2] = {};
        if (mapped)
            shadows[0] = shadowAt(0.5f);
        const typename Host::ShadowMap map = Host::shadowMap(context, 0.25f);
        AgaaLight lights[2] = {};
        for (uint32_t i = 0; i < 2; ++i) {
            lights[i].type = AGAA_LIGHT_DIRECTIONAL;
            lights[i].direction[2] = -1;
            lights[i].color[i] = 4;
            lights[i].shadowMap = i;
        }
        AgaaFrame frame = view.frame();
        frame.lights = lights;
        frame.lightCount = 2;
        frame.shadows = shadows;
        frame.shadowCount = 2;
        Host::run(view, [&](typename Host::Frame& native) {
            if (mapped)
                Host::setShadowMap(native, map);
            data.bind(native);
            ASSERT_EQ(Host::recordFrame(view.get(), &frame, &native), AGAA_OK);
        });
        const std::vector<float> image = Host::rgba(view);
        const ShadingOracle oracle(view, frame, [&](uint32_t shadow, const glm::dvec3& p) {
            if (mapped && shadow == 0)
                return 0.0;
            if (std::fabs(p.x - double(threshold)) < 1e-4)
                return std::numeric_limits<double>::quiet_NaN();
            return p.x > double(threshold) ? 0.75 : 0.125 * shadow;
        });
        size_t sure = 0, wrong = 0, lit = 0;
        const uint32_t width = view.settings().width, height = view.settings().height, pixels = width * height;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const glm::dvec3 expected = oracle.pixel(x, y);
                if (!std::isfinite(expected.x + expected.y + expected.z))
                    continue;
                ++sure;
                lit += expected.y > 0.1;
                for (int i = 0; i < 3; ++i) {
                    const double value = double(image[4 * (size_t(y) * width + x) + size_t(i)]);
                    wrong += !(std::fabs(value - expected[i]) / (std::fabs(expected[i]) + 0.01) < 1e-4);
                }
            }
        EXPECT_GT(sure, pixels * 9 / 10);
        EXPECT_GT(lit, pixels / 20);
        EXPECT_EQ(wrong, 0u);
        EXPECT_EQ(view.statistics().counters.shadowTaps, oracle.shadowTaps());
    }

    // Of a light in the shadow that a function of this result tells.
    std::vector<float> picture(const char* result) {
        const std::string text =
            "float agaaHostShadow(uint shadow, vec3 position) { return " + std::string(result) + "; }";
        const AgaaShadowFunction function = shadowFunction(text.c_str(), 1);
        View view(context, settingsFor("agaa", function, 1));
        view.setTriangles(scene());
        AgaaLight light{};
        light.direction[2] = -1;
        light.color[0] = 4;
        const AgaaShadow shadow{};
        AgaaFrame frame = view.frame();
        setLight(frame, light, &shadow);
        view.render(frame);
        return Host::rgba(view);
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(ShadowFunctionCases);

TYPED_TEST_P(ShadowFunctionCases, AgreesWithDouble) {
    for (const char* technique : {"single", "ssaa", "agaa"})
        for (bool mapped : {true, false})
            if (mapped || TypeParam::runsAll)
                this->expectOracle(technique, mapped);
}

// Declared are more shadows than a frame may have: those are not asked for.
TYPED_TEST_P(ShadowFunctionCases, IsNotAskedForShadowsThatTheFrameHasNot) {
    const AgaaShadowFunction function = shadowFunction(allLitText, 0b11);
    typename TypeParam::View view(this->context, this->settingsFor("agaa", function, 2));
    view.setTriangles(this->scene());
    const AgaaShadow shadows[2] = {};
    uint64_t taps[3];
    for (uint32_t count = 0; count < 3; ++count) {
        AgaaFrame frame = view.frame();
        frame.shadows = shadows;
        frame.shadowCount = count;
        AgaaLight lights[2] = {sun(), sun()}; // of lights with shadows
        for (uint32_t i = 0; i < count; ++i)
            lights[i].shadowMap = i;
        frame.lights = lights;
        frame.lightCount = 2;
        view.render(frame);
        taps[count] = view.statistics().counters.shadowTaps;
    }
    EXPECT_EQ(taps[0], 0u);
    EXPECT_GT(taps[1], 0u);
    EXPECT_EQ(taps[2], 2 * taps[1]);
}

TYPED_TEST_P(ShadowFunctionCases, IsRefusedWhereTheHostShades) {
    const AgaaShadowFunction function = shadowFunction(allLitText, 1);
    const ViewSettings settings = this->settingsFor("msaa", function, 1);
    const std::string text = expectRefused(this->context, settings, AGAA_ERROR_UNSUPPORTED, "the host shades");
    EXPECT_NE(text.find("AgaaShadowFunction"), std::string::npos) << text;
}

TYPED_TEST_P(ShadowFunctionCases, ExtensionsAreLinesOfTheirOwn) {
    AgaaShadowFunction function = shadowFunction(allLitText, 1);
    for (const char* lines : {"float before;", "#extension GL_EXT_a : require \\", "#extension GL_EXT_a : require /*",
                              "#extension GL_EXT_a : require\rfloat x;", "#define agaa_x 1"}) {
        function.glslExtensions = lines;
        const ViewSettings settings = this->settingsFor("agaa", function, 1);
        EXPECT_NE(expectRefused(this->context, settings, AGAA_ERROR_INVALID_ARGUMENT, lines)
                      .find("AgaaShadowFunction::glslExtensions has more than lines"),
                  std::string::npos)
            << lines;
    }
}

// What it returns is held in [0;1], and what is not a number counts as dark.
TYPED_TEST_P(ShadowFunctionCases, ResultsAreContained) {
    const std::vector<float> dark = this->picture("0.0"), lit = this->picture("1.0");
    EXPECT_NE(dark, lit);
    EXPECT_EQ(this->picture("0.0 / (position.x - position.x)"), dark);
    EXPECT_EQ(this->picture("-3.0"), dark);
    EXPECT_EQ(this->picture("1e30"), lit);
}

// A sample that is like the first, but nearer to a further one, counts in the shadows of one of them.
TYPED_TEST_P(ShadowFunctionCases, NoSampleCountsInTwoEventsOfAdaptive) {
    AgaaShadowFunction function = shadowFunction(allLitText, 1);
    ViewSettings settings = this->settingsFor("adaptive", function, 1);
    settings.config.samples = 16;
    settings.config.shadowTaps = 32;
    settings.config.surfaceMaterial = 0.3f;
    settings.config.adaptive.flags = AGAA_ADAPTIVE_GEOMETRY;
    typename TypeParam::View view(this->context, settings);
    view.setTriangles(this->scene());
    AgaaShadow shadow{};
    AgaaLight light = sun();
    light.shadowMap = 0;
    AgaaFrame frame = view.frame();
    setLight(frame, light, &shadow);
    TypeParam::run(view, [&](typename TypeParam::Frame& native) {
        ASSERT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_OK);
    });
    const AgaaCounters counters = view.statistics().counters;
    EXPECT_GT(counters.shadingEvents, counters.shadedPixels);
    EXPECT_GT(counters.shadowTaps, counters.shadedPixels);
    EXPECT_LE(counters.shadowTaps, counters.visible);
}

TYPED_TEST_P(ShadowFunctionCases, BadOnesAreRefusedInASentence) {
    struct Row {
        const char* what;
        AgaaResult code;
        std::function<void(AgaaShadowFunction&)> spoil;
    };
    const Row rows[] = {
        {"no text", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = nullptr; }},
        {"does not compile", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = "float x = ;"; }},
        {"no function", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = "float other;"; }},
        {"answers for none", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.shadows = 0; }},
        {"answers for more", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.shadows = 4; }},
        {"footprints of others", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.footprints = 4; }},
        {"size", AGAA_ERROR_STRUCT, [](auto& f) { f.structSize = 8; }},
        {"twice", AGAA_ERROR_UNKNOWN_STRUCT,
         [](auto& f) {
             static AgaaShadowFunction second = AGAA_SHADOW_FUNCTION_INIT;
             f.pNext = &second;
         }},
        {"a ring", AGAA_ERROR_UNKNOWN_STRUCT,
         [](auto& f) {
             static AgaaStructHeader ring = {77 | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT, sizeof(AgaaStructHeader), &ring};
             f.pNext = &ring;
         }},
    };
    for (const Row& row : rows) {
        AgaaShadowFunction function = shadowFunction(allLitText, 1);
        row.spoil(function);
        expectRefused(this->context, this->settingsFor("agaa", function, 1), row.code, row.what);
    }
    TypeParam::forgetMessages(); // of the compiler
}

REGISTER_TYPED_TEST_SUITE_P(ShadowFunctionCases, AgreesWithDouble, IsNotAskedForShadowsThatTheFrameHasNot,
                            IsRefusedWhereTheHostShades, ExtensionsAreLinesOfTheirOwn, ResultsAreContained,
                            NoSampleCountsInTwoEventsOfAdaptive, BadOnesAreRefusedInASentence);

} // namespace agaa::test
