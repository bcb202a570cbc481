// Shadows by a function of the host's, with resources of its own.
#include "shading_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace agaa::test {
namespace {

constexpr const char* functionText = R"(
layout(std430, set = 1, binding = 0) readonly buffer Data { float threshold; } data;
float agaaHostShadow(uint shadow, vec3 position) {
    return position.x > data.threshold ? 0.75 : 0.125 * float(shadow);
}
)";
constexpr float threshold = 0.5f;

// The host's set: one storage buffer.
class HostSet {
public:
    HostSet() : arena_(sharedDevice()), set_(sharedDevice(), 1, VK_SHADER_STAGE_COMPUTE_BIT) {
        buffer_ = arena_.hostBuffer(16, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        std::memcpy(buffer_.mapped, &threshold, sizeof threshold);
        set_.write({buffer_.buffer.get()});
    }
    uint64_t layout() const { return (uint64_t)set_.layout(); }
    uint64_t set() const { return (uint64_t)set_.get(); }

private:
    harness::vk::Arena arena_;
    harness::vk::BufferResource buffer_;
    StorageSet set_;
};

ViewSettings settingsFor(const char* technique, const AgaaShadowFunction& function,
                         uint32_t shadows) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = shadows;
    settings.chained = &function;
    return settings;
}

std::vector<Triangle> scene() {
    std::vector<Triangle> list = randomTriangles({.triangles = 200}, 71);
    for (Triangle& t : list)
        t.material.emissive = glm::vec4(0);
    return list;
}

// Shadow 0 is a map where `mapped`, all others are the function's.
void expectOracle(const char* technique, bool mapped) {
    SCOPED_TRACE(std::string(technique) + (mapped ? " beside a map" : " alone"));
    StageContext context;
    const HostSet host;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = functionText;
    function.shadows = mapped ? 0b10 : 0b11;
    function.descriptorSetLayout = host.layout();
    const ViewSettings settings = settingsFor(technique, function, 2);
    StageView view(context, settings);
    view.setTriangles(scene());
    AgaaShadow shadows[2] = {};
    if (mapped) {
        shadows[0].layerCount = 1;
        glm::mat4 all(0); // every point at depth 0.5 of the map's middle
        all[3] = glm::vec4(0, 0, 0.5f, 1);
        std::memcpy(shadows[0].matrices[0], &all, sizeof all);
    }
    const ShadowLayers map({0.25f}, 4);
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
    view.render(frame, [&](AgaaVkFrame& vk) {
        vk.shadowViews[0] = mapped ? map.view() : 0;
        vk.functionSet = host.set();
    });
    const harness::Image image = view.image();
    const ShadingOracle oracle(view, frame, [&](uint32_t shadow, const glm::dvec3& p) {
        if (mapped && shadow == 0)
            return 0.0;
        if (std::fabs(p.x - double(threshold)) < 1e-4)
            return std::numeric_limits<double>::quiet_NaN();
        return p.x > double(threshold) ? 0.75 : 0.125 * shadow;
    });
    size_t sure = 0, wrong = 0, lit = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::dvec3 expected = oracle.pixel(x, y);
            if (!std::isfinite(expected.x + expected.y + expected.z))
                continue;
            ++sure;
            lit += expected.y > 0.1;
            for (int i = 0; i < 3; ++i) {
                const double value =
                    double(image.rgb[3 * (size_t(y) * image.width + x) + size_t(i)]);
                wrong += !(std::fabs(value - expected[i]) / (std::fabs(expected[i]) + 0.01) < 1e-4);
            }
        }
    EXPECT_GT(sure, image.pixelCount() * 9 / 10);
    EXPECT_GT(lit, image.pixelCount() / 20);
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(view.statistics().counters.shadowTaps, oracle.shadowTaps());
}

TEST(ShadowFunction, AgreesWithDouble) {
    for (const char* technique : {"single", "ssaa", "agaa"})
        for (bool mapped : {false, true})
            expectOracle(technique, mapped);
}

// Declared are more shadows than a frame may have: those are not asked for.
TEST(ShadowFunction, IsNotAskedForShadowsThatTheFrameHasNot) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    function.shadows = 0b11;
    StageView view(context, settingsFor("agaa", function, 2));
    view.setTriangles(scene());
    const AgaaShadow shadows[2] = {};
    uint64_t taps[3];
    for (uint32_t count = 0; count < 3; ++count) {
        AgaaFrame frame = view.frame();
        frame.shadows = shadows;
        frame.shadowCount = count;
        view.render(frame);
        taps[count] = view.statistics().counters.shadowTaps;
    }
    EXPECT_EQ(taps[0], 0u);
    EXPECT_GT(taps[1], 0u);
    EXPECT_EQ(taps[2], 2 * taps[1]);
}

TEST(ShadowFunction, IsRefusedWhereTheHostShades) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    function.shadows = 1;
    ViewSettings settings = settingsFor("msaa", function, 1);
    try {
        StageView view(context, settings);
        FAIL() << "the view was made";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("AgaaShadowFunction"), std::string::npos)
            << error.what();
    }
}

TEST(ShadowFunction, MayNeedExtensions) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) {\n"
                    "    [[flatten]] if (position.x > 0.0) return 1.0;\n"
                    "    return 0.0;\n"
                    "}";
    function.shadows = 1;
    const ViewSettings settings = settingsFor("agaa", function, 1);
    expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "without the extension");
    for (const char* lines : {"#extension GL_EXT_control_flow_attributes : require",
                              "\r\n#extension  GL_EXT_control_flow_attributes:enable \r\n\n"}) {
        function.glslExtensions = lines;
        EXPECT_NO_THROW(StageView(context, settings)) << lines;
    }
    function.glslExtensions = "#extension GL_EXT_no_such_extension : require";
    const std::string unknown = expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "an unknown extension");
    EXPECT_NE(unknown.find("::glslExtensions does not compile: 0:1:"), std::string::npos) << unknown;
    for (const char* lines : {"float before;", "#extension GL_EXT_a : require \\", "#extension GL_EXT_a : require /*",
                              "#extension GL_EXT_a : require\rfloat x;", "#define agaa_x 1"}) {
        function.glslExtensions = lines;
        EXPECT_NE(expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, lines)
                      .find("AgaaShadowFunction::glslExtensions has more than lines"), std::string::npos) << lines;
    }
}

// What it returns is held in [0;1], and what is not a number counts as dark.
TEST(ShadowFunction, ResultsAreContained) {
    StageContext context;
    const auto picture = [&](const char* result) {
        const std::string text =
            std::string("float agaaHostShadow(uint shadow, vec3 position) { return ") + result +
            "; }";
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = text.c_str();
        function.shadows = 1;
        StageView view(context, settingsFor("agaa", function, 1));
        view.setTriangles(scene());
        AgaaLight light{};
        light.direction[2] = -1;
        light.color[0] = 4;
        const AgaaShadow shadow{};
        AgaaFrame frame = view.frame();
        frame.lights = &light;
        frame.lightCount = 1;
        frame.shadows = &shadow;
        frame.shadowCount = 1;
        view.render(frame);
        return view.image().rgb;
    };
    const std::vector<float> dark = picture("0.0"), lit = picture("1.0");
    EXPECT_NE(dark, lit);
    EXPECT_EQ(picture("0.0 / (position.x - position.x)"), dark);
    EXPECT_EQ(picture("-3.0"), dark);
    EXPECT_EQ(picture("1e30"), lit);
}

TEST(ShadowFunction, BadOnesAreRefusedInASentence) {
    StageContext context;
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
        {"reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.reserved = 1; }},
        {"size", AGAA_ERROR_STRUCT, [](auto& f) { f.structSize = 8; }},
        {"twice", AGAA_ERROR_UNKNOWN_STRUCT, [](auto& f) {
             static AgaaShadowFunction second = AGAA_SHADOW_FUNCTION_INIT;
             f.pNext = &second;
         }},
        {"a ring", AGAA_ERROR_UNKNOWN_STRUCT, [](auto& f) {
             static AgaaStructHeader ring = {77 | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT,
                                             sizeof(AgaaStructHeader), &ring};
             f.pNext = &ring;
         }},
    };
    for (const Row& row : rows) {
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = functionText;
        function.shadows = 1;
        row.spoil(function);
        const ViewSettings settings = settingsFor("agaa", function, 1);
        expectRefused(context, settings, row.code, row.what);
    }
}

} // namespace
} // namespace agaa::test
