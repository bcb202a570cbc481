// What the facts of a scene fix, and what is counted of materials that differ. Each graphics API instantiates these.
#pragma once

#include "hard_case_test.h"

#include <gtest/gtest.h>

#include <string>

namespace agaa::test {

struct FactWay {
    const char* technique;
    uint32_t samples = 8;
    uint32_t tier = AGAA_TIER_AUTO;
    uint64_t flags = 0;
    const char* layout = "precise";
    uint32_t ndf = AGAA_NDF_TOKSVIG;

    std::string name() const { return std::string(technique) + ' ' + agaaTierName(tier) + ' ' + layout; }
};
// Each way to store or fetch a material.
constexpr FactWay factWays[] = {{"ssaa"},
                                {"msaa", 4},
                                {"sbaa"},
                                {"adaptive", 4, AGAA_TIER_IDS},
                                {"agaa", 8, AGAA_TIER_PER_SAMPLE, 0, "paper16"},
                                {"agaa", 8, AGAA_TIER_GBUFFER},
                                {"agaa", 8, AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED},
                                {"agaa", 8, AGAA_TIER_IDS, 0, "precise", AGAA_NDF_LEAN},
                                {"agaa", 64, AGAA_TIER_FRAGMENTS},
                                {"dcaa", 64, AGAA_TIER_MATERIAL_LISTS},
                                {"dcaa", 64, AGAA_TIER_MATERIAL_LISTS, 0, "precise", AGAA_NDF_LEAN},
                                {"dcaa", 64, AGAA_TIER_FRAGMENT_LISTS}};
// By fragments of the host, by ids, and both.
constexpr FactWay checkedWays[] = {{"simple_complex"},
                                   {"adaptive", 4},
                                   {"agaa", 8, AGAA_TIER_PER_SAMPLE},
                                   {"agaa", 8, AGAA_TIER_IDS},
                                   {"dcaa", 64, AGAA_TIER_FRAGMENT_LISTS}};
inline bool layoutIsCoarse(const FactWay& way) { return std::string(way.layout) == "paper16"; }

// What facts fix, as a change of materials.
struct FixedValues {
    const char* name;
    uint64_t facts;
    void (*fix)(Material&);
};
constexpr FixedValues fixedValues[] = {
    {"of one roughness, grey", AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR,
     [](Material& m) {
         m.normal.w = 0.25f;
         m.specular = glm::vec4((m.specular.x + m.specular.y + m.specular.z) / 3);
     }},
    {"of one reflectance, without diffuse", AGAA_FACT_ONE_SPECULAR | AGAA_FACT_NO_DIFFUSE,
     [](Material& m) {
         m.specular = glm::vec4(0.125f);
         m.diffuse = glm::vec4(0, 0, 0, m.diffuse.w);
     }},
};

template <class Host> class FactsCases : public testing::Test {
protected:
    ViewSettings settingsOf(const FactWay& way) {
        ViewSettings settings;
        settings.config.technique = way.technique;
        settings.config.samples = way.samples;
        settings.config.aggregates = std::string(way.technique) == "dcaa" ? 4 : 2;
        settings.config.generationTier = way.tier;
        settings.config.flags = way.flags;
        settings.config.ndf = way.ndf;
        EXPECT_EQ(agaaGetBuiltinLayout(way.layout, &layout), AGAA_OK);
        settings.config.layout = &layout;
        settings.facts.alpha2 = 0.25f;
        settings.facts.specular = 0.125f;
        return settings;
    }

    Shown shownOf(const ViewSettings& settings, const std::vector<Triangle>& triangles) {
        ViewSettings plain = settings;
        plain.facts.shadowMapCount = 0;
        return show(context, plain, {.triangles = triangles, .change = addAmbient});
    }

    static std::vector<Triangle> scene() { return randomTriangles({.triangles = 120, .masked = 0.2f}, 71); }

    AgaaLayout layout = AGAA_LAYOUT_INIT;
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(FactsCases);

// Materials that differ are shown as those that do not, whether their values are stored or not.
TYPED_TEST_P(FactsCases, ValuesReplaceThoseOfMaterials) {
    for (const FactWay& way : factWays)
        for (const FixedValues& values : fixedValues) {
            const bool isFirst = &values == fixedValues;
            if (way.samples == 64 && isFirst != (way.tier == AGAA_TIER_MATERIAL_LISTS))
                continue; // such ways compile for long, and are four
            if (!rendersSetting<TypeParam>(size_t(&way - factWays) + isFirst))
                continue;
            SCOPED_TRACE(way.name() + ", " + values.name);
            ViewSettings settings = this->settingsOf(way);
            if (values.facts & AGAA_FACT_NO_DIFFUSE && layoutIsCoarse(way))
                settings.facts.flags &= ~AGAA_FACT_EMISSIVE; // which is a factor of the albedo
            std::vector<Triangle> triangles = this->scene();
            settings.facts.flags |= values.facts;
            const Shown differing = this->shownOf(settings, triangles);
            for (Triangle& triangle : triangles)
                values.fix(triangle.material);
            if (way.samples != 64) {
                EXPECT_GT(compare(differing.rgb, this->shownOf(settings, triangles).rgb).psnr, 100) << "with the facts";
            }
            settings.facts.flags &= ~values.facts;
            const Shown stored = this->shownOf(settings, triangles);
            EXPECT_GT(compare(differing.rgb, stored.rgb).psnr, layoutIsCoarse(way) ? 55 : 100) << "without the facts";
            EXPECT_GT(sumOf(differing.rgb), 0);
        }
}

// Each way to keep or fetch a normal; the first three take that of the prepass, whose 16 bits round, where no light is
// local and nothing specular.
constexpr FactWay normalWays[] = {{"agaa", 8, AGAA_TIER_PER_SAMPLE},
                                  {"agaa", 4, AGAA_TIER_PER_SAMPLE}, // with reversed depth
                                  {"sbaa", 32},
                                  {"ssaa"},
                                  {"agaa", 8, AGAA_TIER_IDS},
                                  {"dcaa", 64, AGAA_TIER_MATERIAL_LISTS, 0, "precise", AGAA_NDF_LEAN}};

// Normals of planes replace those of materials, and two geometry passes keep none in aggregates. Hosts may give either
// side of a plane, and the derivatives of a normal that is replaced.
TYPED_TEST_P(FactsCases, NormalsArePlanes) {
    std::vector<Triangle> differing = this->scene();
    for (size_t i = 0; i < differing.size(); i += 2)
        differing[i].material.geometricNormal *= -1.0f;
    std::vector<Triangle> flat = differing;
    for (Triangle& t : flat)
        t.material.normal = glm::vec4(planeNormal(t), t.material.normal.w);
    for (const FactWay& way : normalWays) {
        if (!rendersSetting<TypeParam>(size_t(&way - normalWays)))
            continue;
        SCOPED_TRACE(way.name());
        const bool rounds = &way < normalWays + 3;
        ViewSettings settings = this->settingsOf(way);
        if (way.samples == 4) {
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.projection = reversedInfinite(60, 1.5f, 0.1f);
        }
        if (rounds)
            settings.facts.flags = (settings.facts.flags & ~AGAA_FACT_SPECULAR) | AGAA_FACT_NO_LOCAL_LIGHTS;
        const Shown stored = this->shownOf(settings, flat);
        settings.facts.flags |= AGAA_FACT_PLANE_NORMALS;
        if (way.samples == 64)
            settings.surface = "s.normalDx = vec3(0.3, 0.0, 0.1); s.normalDy = vec3(0.0, 0.2, 0.0);";
        const Shown given = this->shownOf(settings, differing);
        const double psnr = compare(given.rgb, stored.rgb).psnr;
        std::printf("%s: PSNR %.1f dB to stored normals\n", way.name().c_str(), psnr);
        EXPECT_GT(psnr, rounds ? 80 : 150);
        if (&way == normalWays) {
            settings.facts.flags &= ~AGAA_FACT_PLANE_NORMALS;
            EXPECT_LT(compare(this->shownOf(settings, differing).rgb, given.rgb).psnr, 45)
                << "materials have normals of their own";
        }
    }
}

// Rectangles that each contradict some facts, in a view of one sample, where each pixel has one fragment.
TYPED_TEST_P(FactsCases, CountsAreThoseOfFragments) {
    Material plain;
    plain.diffuse = {0.5f, 0.5f, 0.5f, 1};
    plain.specular = glm::vec4(0.125f);
    plain.normal.w = 0.25f;
    Material glowing = plain, gold = plain;
    glowing.emissive = {1, 0, 0, 0};
    glowing.normal = {0, 0.6f, 0.8f, 0.25f};
    gold.specular = {0.9f, 0.6f, 0.2f, 0};
    gold.diffuse = {0, 0, 0, 1};
    gold.normal.w = 0.1f;
    std::vector<Triangle> triangles = rectangle(0, 0, 48, 8, 5, plain);
    for (const auto& [top, material] : {std::pair{8.0f, glowing}, {16.0f, gold}})
        for (const Triangle& triangle : rectangle(0, top, 48, top + 8, 5, material))
            triangles.push_back(triangle);
    for (Triangle& triangle : triangles)
        triangle.material.geometricNormal *= -1.0f; // away from the eye
    ViewSettings settings = this->settingsOf({"single", 1});
    settings.projection = pixelOrthographic(48, 32, 10);
    settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
    settings.facts.flags = AGAA_FACT_SPECULAR | AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR;
    this->context.lines.clear();
    const Shown shown = this->shownOf(settings, triangles);
    const AgaaFactReport& report = shown.facts;
    const uint64_t row = 48 * 8;
    EXPECT_EQ(report.inspected, 3 * row);
    EXPECT_EQ(report.withSpecular, 3 * row);
    EXPECT_EQ(report.withEmission, row);
    EXPECT_EQ(report.alphaMasked, 0u);
    EXPECT_EQ(report.otherRoughness, row);
    EXPECT_EQ(report.coloredSpecular, row);
    EXPECT_EQ(report.otherSpecular, row);
    EXPECT_EQ(report.withDiffuse, 2 * row);
    EXPECT_EQ(report.translucent + report.cutouts, 0u);
    EXPECT_EQ(report.otherNormals, row);
    EXPECT_EQ(report.lightCount, 1u);
    EXPECT_EQ(report.localLights, 0u);
    EXPECT_EQ(report.hasAmbient, 1u);
    EXPECT_EQ(report.contradicted,
              AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT | AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR);
    EXPECT_EQ(report.sufficient, AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT |
                                     AGAA_FACT_NO_LOCAL_LIGHTS | AGAA_FACT_NO_TRANSLUCENCY | AGAA_FACT_NO_CUTOUTS);
    ASSERT_EQ(this->context.lines.size(), 1u) << "told once";
    EXPECT_EQ(this->context.lines[0].text, report.explanation);
    EXPECT_NE(this->context.lines[0].text.find("33.3 %"), std::string::npos) << report.explanation;
}

// The facts that a report names suffice: the image stays as it is, and nothing contradicts them.
TYPED_TEST_P(FactsCases, SufficientFactsSuffice) {
    std::vector<Triangle> triangles = this->scene();
    for (Triangle& triangle : triangles) {
        triangle.material.emissive = glm::vec4(0);
        triangle.material.specular = glm::vec4(triangle.material.specular.x);
        triangle.material.normal.w = 0.25f;
    }
    for (const FactWay& way : checkedWays) {
        if (!rendersSetting<TypeParam>(size_t(&way - checkedWays)))
            continue;
        SCOPED_TRACE(way.name());
        ViewSettings settings = this->settingsOf(way);
        settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
        const Shown all = this->shownOf(settings, triangles);
        EXPECT_EQ(all.facts.contradicted, 0u) << all.facts.explanation;
        EXPECT_GT(all.facts.inspected, 0u);
        EXPECT_TRUE(all.facts.sufficient & AGAA_FACT_ONE_ROUGHNESS);
        EXPECT_TRUE(all.facts.sufficient & AGAA_FACT_GREY_SPECULAR);
        EXPECT_TRUE(all.facts.sufficient & AGAA_FACT_ALPHA_MASKED);
        EXPECT_FALSE(all.facts.sufficient & AGAA_FACT_EMISSIVE);
        settings.facts.flags = all.facts.sufficient;
        const Shown few = this->shownOf(settings, triangles);
        EXPECT_EQ(few.facts.contradicted, 0u) << few.facts.explanation;
        EXPECT_EQ(few.facts.sufficient, all.facts.sufficient);
        EXPECT_GT(compare(all.rgb, few.rgb).psnr, 80);
    }
}

// A host that multiplies radiance by its exposure after shading has dim lamps, which facts must not lose.
TYPED_TEST_P(FactsCases, HardCase63DimEmissionIsDemanded) {
    Material dim = facing({0, 0, 0});
    dim.emissive = {1e-3f, 5e-4f, 2e-3f, 0};
    for (const FactWay& way : {FactWay{"single", 1}, FactWay{"agaa", 8, AGAA_TIER_IDS}}) {
        SCOPED_TRACE(way.name());
        ViewSettings settings = this->settingsOf(way);
        settings.projection = pixelOrthographic(48, 32, 10);
        settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
        const Shown shown = this->shownOf(settings, rectangle(0, 0, 48, 32, 5, dim));
        EXPECT_EQ(shown.facts.withEmission, shown.facts.inspected);
        EXPECT_TRUE(shown.facts.sufficient & AGAA_FACT_EMISSIVE);
        dim.emissive = glm::vec4(0);
        EXPECT_EQ(this->shownOf(settings, rectangle(0, 0, 48, 32, 5, dim)).facts.withEmission, 0u);
        dim.emissive = {1e-3f, 5e-4f, 2e-3f, 0};
    }
}

// The debug view shows the share of samples whose materials contradict.
TYPED_TEST_P(FactsCases, DebugViewShowsContradictions) {
    Material plain, glowing;
    glowing.emissive = {1, 1, 1, 0};
    std::vector<Triangle> triangles = rectangle(0, 0, 24.5f, 32, 5, plain);
    for (const Triangle& triangle : rectangle(24.5f, 0, 48, 32, 5, glowing))
        triangles.push_back(triangle);
    for (const FactWay& way : checkedWays) {
        if (!rendersSetting<TypeParam>(size_t(&way - checkedWays)))
            continue;
        SCOPED_TRACE(way.name());
        ViewSettings settings = this->settingsOf(way);
        settings.projection = pixelOrthographic(48, 32, 10);
        settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
        settings.config.measurement.debugView = AGAA_DEBUG_VIEW_FACTS;
        settings.facts.flags &= ~AGAA_FACT_EMISSIVE;
        const Shown shown = this->shownOf(settings, triangles);
        for (uint32_t x : {0u, 10u, 23u, 25u, 40u, 47u})
            EXPECT_NEAR(shown.rgb[3 * (16 * 48 + x)], x < 24 ? 0.0f : 1.0f, 0.01f) << x;
        if (way.samples == 8) {
            EXPECT_NEAR(shown.rgb[3 * (16 * 48 + 24)], 0.5f, 0.3f);
        }
    }
}

TYPED_TEST_P(FactsCases, LocalLightsAreRefused) {
    ViewSettings settings = this->settingsOf({"ssaa"});
    settings.facts.flags |= AGAA_FACT_NO_LOCAL_LIGHTS;
    settings.facts.shadowMapCount = 0;
    typename TypeParam::View view(this->context, settings);
    view.setTriangles(this->scene());
    AgaaFrame frame = view.frame();
    const AgaaLight lights[] = {sun(), manyLights(2, 3, 5)[1]};
    frame.lights = lights;
    frame.lightCount = 2;
    this->context.lines.clear();
    TypeParam::run(view, [&](typename TypeParam::Frame& native) {
        EXPECT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_ERROR_OUT_OF_RANGE);
        expectOneSentence(this->context.lines, AGAA_ERROR_OUT_OF_RANGE, "a local light");
        frame.lightCount = 1;
        EXPECT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_OK);
    });
}

REGISTER_TYPED_TEST_SUITE_P(FactsCases, ValuesReplaceThoseOfMaterials, NormalsArePlanes, CountsAreThoseOfFragments,
                            SufficientFactsSuffice, HardCase63DimEmissionIsDemanded, DebugViewShowsContradictions,
                            LocalLightsAreRefused);

} // namespace agaa::test
