// Shading: the image against the same lighting in double, from the surfaces that the GPU shaded.
#include "shading_oracle.h"
#include "stage_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace agaa::test {
namespace {

constexpr float shadowDepth = 0.5f;

std::vector<AgaaLight> lights(bool shadowed) {
    std::vector<AgaaLight> list(4);
    for (AgaaLight& light : list) {
        light = {};
        light.shadowMap = AGAA_NO_SHADOW;
        light.direction[1] = -0.6f;
        light.direction[2] = -0.8f;
        light.color[0] = 2;
        light.color[1] = 1.5f;
        light.color[2] = 1;
    }
    list[0].type = AGAA_LIGHT_DIRECTIONAL;
    list[0].shadowMap = shadowed ? 0 : AGAA_NO_SHADOW;
    list[1].type = AGAA_LIGHT_POINT;
    list[1].position[2] = -5;
    list[1].range = 12;
    list[1].radius = 0.1f;
    list[1].color[0] = list[1].color[2] = 20;
    list[1].shadowMap = shadowed ? 1 : AGAA_NO_SHADOW;
    list[2].type = AGAA_LIGHT_SPOT;
    list[2].position[1] = 3;
    list[2].direction[1] = -0.6f;
    list[2].cosInner = 0.95f;
    list[2].cosOuter = 0.7f;
    list[2].color[1] = 60;
    list[2].shadowMap = shadowed ? 2 : AGAA_NO_SHADOW;
    list[3].type = AGAA_LIGHT_POINT; // behind the eye, no end
    list[3].position[2] = 4;
    list[3].color[2] = 30;
    return list;
}

// Map 0 covers everything, with a depth that falls from left to right; map 1 only a part, in two layers
// that hold different depths; map 2 has a perspective and an eye in the middle of the scene.
std::vector<AgaaShadow> shadows() {
    std::vector<AgaaShadow> list(3);
    const auto set = [](AgaaShadow& s, uint32_t layer, const glm::mat4& m) {
        std::copy_n(&m[0][0], 16, s.matrices[layer]);
    };
    for (AgaaShadow& s : list) {
        s = {};
        s.layerCount = 1;
        s.depthBias = 0.001f;
    }
    glm::mat4 slope(0);
    slope[0] = glm::vec4(0, 0, 0.02f, 0);
    slope[1] = glm::vec4(0, 0.01f, 0.03f, 0);
    slope[2] = glm::vec4(0.02f, 0, 0, 0);
    slope[3] = glm::vec4(0.2f, 0, 0.5f, 1);
    set(list[0], 0, slope);
    list[1].layerCount = 2;
    glm::mat4 near(0);
    near[0][0] = 0.5f;
    near[1][1] = 0.5f;
    near[2][2] = -0.2f;
    near[3] = glm::vec4(0, 0, 0, 1);
    set(list[1], 0, near);
    glm::mat4 far = near;
    far[0][0] = far[1][1] = 0.15f;
    far[2][2] = -0.06f;
    set(list[1], 1, far);
    glm::mat4 eye = perspective(90, 1, 0.5f, 10);
    set(list[2], 0, eye * glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.3f, 0.2f, 6, 1));
    return list;
}

// As the host's contract says: the first layer whose clip volume holds the point.
Visibility visibility(const std::vector<AgaaShadow>& maps, const std::vector<std::vector<float>>& depths) {
    return [&maps, depths](uint32_t map, const glm::dvec3& p) {
        const double unsure = std::numeric_limits<double>::quiet_NaN();
        for (uint32_t layer = 0; layer < maps[map].layerCount; ++layer) {
            glm::mat4 m;
            std::copy_n(maps[map].matrices[layer], 16, &m[0][0]);
            const glm::dvec4 clip = glm::dmat4(m) * glm::dvec4(p, 1);
            const double margins[] = {clip.w, clip.w - std::fabs(clip.x), clip.w - std::fabs(clip.y), clip.z,
                                      clip.w - clip.z};
            bool inside = true;
            for (double margin : margins) {
                inside &= margin > 0;
                if (std::fabs(margin) < 1e-4)
                    return unsure;
            }
            if (!inside)
                continue;
            const double difference = clip.z / clip.w - double(maps[map].depthBias) - double(depths[map][layer]);
            return std::fabs(difference) < 1e-5 ? unsure : difference <= 0 ? 1.0 : 0.0;
        }
        return 1.0;
    };
}

struct Case {
    const char* technique = "agaa";
    uint32_t samples = 8, aggregates = 2;
    uint32_t brdf = AGAA_BRDF_GGX;
    bool shadowed = true;
    const char* layout = "precise";
    uint64_t flags = 0;
    uint32_t ndf = AGAA_NDF_TOKSVIG;
    glm::mat4 projection = perspective(60, 1.5f, 0.1f, 100);
    glm::mat4 view{1};
    uint32_t shadowTaps = 0, shadingCost = 1;
    uint32_t diffuseFilter = AGAA_DIFFUSE_RECTIFIED;
    AgaaTier tier = AGAA_TIER_AUTO;
    double tolerance = 1e-4; // of colours
};

void expectOracle(const Case& c, std::vector<Triangle> scene) {
    SCOPED_TRACE(std::string(c.technique) + " n=" + std::to_string(c.samples) + " c=" + std::to_string(c.aggregates) +
                 " brdf " + std::to_string(c.brdf) + " " + c.layout + " flags " + std::to_string(c.flags));
    StageContext context;
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout(c.layout, &layout);
    ViewSettings settings;
    settings.config.technique = c.technique;
    settings.config.samples = c.samples;
    settings.config.aggregates = c.aggregates;
    settings.config.brdf = c.brdf;
    settings.config.ndf = c.ndf;
    settings.config.shadowTaps = c.shadowTaps;
    settings.config.measurement.shadingCost = c.shadingCost;
    settings.config.layout = &layout;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.config.measurement.flags = c.flags;
    settings.config.measurement.diffuseFilter = c.diffuseFilter;
    settings.config.generationTier = c.tier;
    settings.projection = c.projection;
    settings.view = c.view;
    // Triangles are given as seen: into shading space.
    for (Triangle& t : scene) {
        const glm::mat3 inverse = glm::transpose(glm::mat3(c.view));
        for (glm::vec3& p : t.position)
            p = inverse * p;
        t.material.normal = glm::vec4(inverse * glm::vec3(t.material.normal), t.material.normal.w);
        t.material.geometricNormal = glm::vec4(inverse * glm::vec3(t.material.geometricNormal), 0);
    }
    const auto list = lights(c.shadowed);
    const auto maps = shadows();
    const std::vector<std::vector<float>> depths = {{shadowDepth}, {0.6f, 0.3f}, {0.8f}};
    std::vector<ShadowLayers> images;
    for (const auto& layers : depths)
        images.emplace_back(layers, 16);
    settings.facts.shadowMapCount = c.shadowed ? uint32_t(maps.size()) : 0;
    StageView view(context, settings);
    view.setTriangles(scene);
    AgaaFrame frame = view.frame();
    frame.lights = list.data();
    frame.lightCount = uint32_t(list.size());
    if (c.shadowed) {
        frame.shadows = maps.data();
        frame.shadowCount = uint32_t(maps.size());
    }
    const float ambient[3] = {0.1f, 0.2f, 0.3f}, background[4] = {0.4f, 0.5f, 0.6f, 1};
    std::copy_n(ambient, 3, frame.ambient);
    std::copy_n(background, 4, frame.background);
    view.render(frame, [&](AgaaVkFrame& vk) {
        for (size_t i = 0; i < images.size(); ++i)
            vk.shadowViews[i] = images[i].view();
    });
    const harness::Image image = view.image();
    const ShadingOracle oracle(view, frame, visibility(maps, depths));
    size_t sure = 0, wrong = 0;
    double worst = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::dvec3 expected = oracle.pixel(x, y);
            if (!std::isfinite(expected.x + expected.y + expected.z))
                continue;
            ++sure;
            for (int i = 0; i < 3; ++i) {
                const double value = double(image.rgb[3 * (size_t(y) * image.width + x) + size_t(i)]);
                const double error = std::fabs(value - expected[i]) / (std::fabs(expected[i]) + 0.01);
                worst = std::max(worst, error);
                wrong += !(error < c.tolerance);
            }
        }
    EXPECT_GT(sure, image.pixelCount() * 9 / 10);
    EXPECT_EQ(wrong, 0u) << "largest relative error " << worst;
    const AgaaCounters counters = view.statistics().counters;
    EXPECT_EQ(counters.shadingEvents, oracle.events());
    // The depth of a fragment's plane may have the code beside that of the stored depth.
    const bool rounds = c.flags & AGAA_MEASURE_STORED_DEPTH;
    EXPECT_NEAR(double(counters.shadowTaps), double(oracle.shadowTaps()),
                rounds ? 1.5e-3 * double(counters.shadowTaps) : 0);
    std::printf("%s n=%u c=%u: largest relative error %.1e\n", c.technique, c.samples, c.aggregates, worst);
}

// Few emit light, lest it hide the lighting; normals face the eye, as most do.
std::vector<Triangle> scene(uint32_t seed) {
    std::vector<Triangle> list = randomTriangles({.triangles = 300}, seed);
    for (size_t i = 0; i < list.size(); ++i) {
        Material& m = list[i].material;
        if (i % 8 != 0)
            m.emissive = glm::vec4(0);
        if (m.normal.z < 0)
            m.normal.z = -m.normal.z;
    }
    return list;
}

TEST(Shading, AgreesWithDoubleForEverySampleAndAggregateCount) {
    for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u})
        for (uint32_t c : {1u, 2u, 3u, 4u})
            if (c <= n)
                expectOracle({.samples = n, .aggregates = c}, scene(31));
}

TEST(Shading, AgreesForTechniquesThatDoNotAggregate) {
    expectOracle({.technique = "single"}, scene(32));
    for (uint32_t n : {4u, 8u, 32u})
        expectOracle({.technique = "ssaa", .samples = n}, scene(32));
    expectOracle({.technique = "ssaa", .samples = 4, .layout = "paper16"}, scene(32));
}

TEST(Shading, AgreesForBothLobesLayoutsAndFilters) {
    for (uint32_t brdf : {AGAA_BRDF_GGX, AGAA_BRDF_BLINN_PHONG})
        for (const char* layout : {"precise", "paper16"})
            expectOracle({.brdf = brdf, .layout = layout}, scene(33));
    expectOracle({.ndf = AGAA_NDF_NONE}, scene(33));
    for (uint64_t flag :
         {AGAA_MEASURE_NO_DIFFUSE_FILTER, AGAA_MEASURE_NO_SHADOW_FILTER, AGAA_MEASURE_SHADOW_ALONG_DEPTH,
          AGAA_MEASURE_SHADOW_COVARIANCE, AGAA_MEASURE_LIGHT_DIRECTIONS, AGAA_MEASURE_STORED_DEPTH,
          AGAA_MEASURE_STORED_DEPTH | AGAA_MEASURE_NO_SHADOW_FILTER})
        expectOracle({.flags = flag}, scene(33));
    expectOracle({.diffuseFilter = AGAA_DIFFUSE_MISES_FISHER}, scene(33));
    for (uint32_t taps : {1u, 3u, 32u})
        expectOracle({.samples = 16, .shadowTaps = taps}, scene(33));
    for (const char* technique : {"ssaa", "agaa"})
        expectOracle({.technique = technique, .shadingCost = 3}, scene(33));
    expectOracle({.shadowed = false}, scene(33));
}

// In targets of the device's samples and in scaled ones, of one sample a texel. Codes of depth have steps of 1e-5, and
// the footprint does not know how depth changes within the pixel.
TEST(Shading, AgreesForStoredDepths) {
    constexpr double codes = 2.5e-4, footprint = 3e-2; // measured 1.9e-4 and 2.6e-2
    for (const uint32_t n : {1u, 2u, 4u, 16u, 32u})
        expectOracle(
            {.samples = n, .aggregates = std::min(n, 2u), .flags = AGAA_MEASURE_STORED_DEPTH, .tolerance = codes},
            scene(37));
    expectOracle({.flags = AGAA_MEASURE_STORED_DEPTH, .tier = AGAA_TIER_PER_SAMPLE, .tolerance = codes}, scene(37));
    expectOracle({.flags = AGAA_MEASURE_STORED_DEPTH | AGAA_MEASURE_FIRST_SAMPLE_ROUTING, .tolerance = codes},
                 scene(37));
    expectOracle({.flags = AGAA_MEASURE_STORED_DEPTH | AGAA_MEASURE_LIGHT_DIRECTIONS, .tolerance = footprint},
                 scene(37));
}

TEST(Shading, AgreesForOffCentreProjections) {
    glm::mat4 jittered = perspective(60, 1.5f, 0.1f, 100);
    jittered[2][0] = 0.3f;
    jittered[2][1] = -0.2f;
    glm::mat4 orthographic(1);
    orthographic[0][0] = 0.1f;
    orthographic[1][1] = -0.15f;
    orthographic[2][2] = -0.04f;
    orthographic[3] = glm::vec4(0.3f, -0.2f, 0, 1);
    for (const glm::mat4& projection : {jittered, orthographic})
        for (const char* technique : {"ssaa", "agaa"})
            expectOracle({.technique = technique, .projection = projection}, scene(35));
    for (const uint64_t flags : {AGAA_MEASURE_SHADOW_ALONG_DEPTH, AGAA_MEASURE_STORED_DEPTH})
        expectOracle({.flags = flags, .projection = orthographic}, scene(35));
}

TEST(Shading, AgreesForATurnedView) {
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    const glm::mat4 turn(glm::mat3(c, s * 0.6f, s * 0.8f, 0, 0.8f, -0.6f, -s, c * 0.6f, c * 0.8f));
    for (uint64_t flags : {uint64_t(0), AGAA_MEASURE_SHADOW_ALONG_DEPTH, AGAA_MEASURE_STORED_DEPTH,
                           AGAA_MEASURE_SHADOW_COVARIANCE | AGAA_MEASURE_LIGHT_DIRECTIONS})
        expectOracle({.flags = flags, .view = turn}, scene(34));
}

// AGAA 3.2: nothing is clustered, so that no pass reads normals of samples. Those that counters need show the same.
TEST(Shading, OneAggregateNeedsNoNormalsOfSamples) {
    StageContext context;
    for (const uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE}) {
        std::vector<float> images[2];
        for (const bool counts : {true, false}) {
            ViewSettings settings;
            settings.config.technique = "agaa";
            settings.config.aggregates = 1;
            settings.config.generationTier = tier;
            settings.config.flags = counts ? AGAA_CONFIG_COUNTERS : 0;
            settings.facts.shadowMapCount = 0;
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.projection = reversedInfinite(60, 1.5f, 0.1f);
            StageView view(context, settings);
            const auto& resources = view.plan().resources;
            const bool hasNormals =
                std::ranges::any_of(resources, [](const Resource& resource) { return resource.name == "normals"; });
            EXPECT_EQ(hasNormals, counts);
            view.setTriangles(scene(36));
            const auto list = lights(false);
            AgaaFrame frame = view.frame();
            frame.lights = list.data();
            frame.lightCount = uint32_t(list.size());
            view.render(frame, [](AgaaVkFrame&) {});
            images[counts] = view.image().rgb;
        }
        EXPECT_EQ(images[0], images[1]) << agaaTierName(tier);
        EXPECT_GT(*std::ranges::max_element(images[0]), 0.1f);
    }
}

} // namespace
} // namespace agaa::test
