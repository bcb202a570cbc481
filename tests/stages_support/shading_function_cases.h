// Shading by a function of the host's, in every technique and tier: the library's model through it shows the same
// image, events know what they represent, and results are contained. Each graphics API instantiates these.
#pragma once

#include "agreement.h"
#include "hard_case_test.h"
#include "setting_share.h"
#include "technique_tiers.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace agaa::test {

// The library's model as functions of a host.
constexpr const char* builtInReflectance = "vec3 agaaReflect(AgaaSurface surface, vec3 toLight, vec3 toEye) {\n"
                                           "    return agaaBuiltInReflect(surface, toLight, toEye);\n"
                                           "}\n";
constexpr const char* builtInEvent = R"(
vec3 agaaShade(AgaaSurface surface) {
    vec3 toEye = agaaToEye(surface.position);
    vec3 sum = surface.emissive + agaaAmbient() * (surface.diffuse + surface.specular);
    AgaaLights lights = agaaLights();
    AgaaIncidentLight light;
    while (agaaNextLight(lights, surface, light))
        if (light.radiance != vec3(0.0))
            sum += agaaBuiltInReflect(agaaLitPart(surface, light), light.toLight, toEye) * light.radiance;
    return sum;
}
)";
// Lambert's law, and GGX with Smith's term for one roughness, in the textbook's form.
constexpr const char* textbookReflectance = R"(
vec3 agaaReflect(AgaaSurface surface, vec3 toLight, vec3 toEye) {
    const float pi = 3.14159265;
    float l = max(dot(surface.normal, toLight), 0.0), v = clamp(dot(surface.normal, toEye), 1e-4, 1.0);
    if (l <= 0.0)
        return vec3(0.0);
    vec3 h = normalize(toLight + toEye);
    float n = clamp(dot(surface.normal, h), 0.0, 1.0);
    float a2 = surface.alpha2, d = n * n * (a2 - 1.0) + 1.0;
    float smith = 0.5 / (l * sqrt(a2 + (1.0 - a2) * v * v) + v * sqrt(a2 + (1.0 - a2) * l * l));
    vec3 fresnel = surface.specular + (1.0 - surface.specular) * pow(1.0 - clamp(dot(toEye, h), 0.0, 1.0), 5.0);
    return (surface.diffuse / pi + fresnel * a2 / (pi * d * d) * smith) * l;
}
)";

inline AgaaShadingFunction shadingFunction(const char* glsl, AgaaShadingLevel level) {
    AgaaShadingFunction function = AGAA_SHADING_FUNCTION_INIT;
    function.glsl = glsl;
    function.level = level;
    return function;
}

template <class Host> class ShadingFunctionCases : public testing::Test {
protected:
    Shot shot(uint32_t lights = 12) const {
        const RandomScene scene = {.triangles = 150, .duplicates = 0.1f, .masked = 0.2f};
        return {.triangles = settleTies(randomTriangles(scene, 61), context.caps()),
                .lights = manyLights(lights, 4, 5),
                .change = addAmbient};
    }

    static ViewSettings settingsOf(const TechniqueTier& tier, uint32_t lights = 12) {
        ViewSettings settings;
        apply(tier, settings);
        settings.facts.maxLights = lights;
        settings.facts.shadowMapCount = 0;
        if (tier.isBatched) {
            settings.width = batchedExtent.x;
            settings.height = batchedExtent.y;
        }
        return settings;
    }

    Shown showWith(ViewSettings settings, const Shot& shot, const char* glsl, AgaaShadingLevel level) {
        const AgaaShadingFunction function = shadingFunction(glsl, level);
        if (glsl)
            settings.chained = &function;
        return show(context, settings, shot);
    }

    // Rounding may differ, because compilers contract other products.
    static double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
        double largest = 0;
        for (size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::fabs(double(a[i]) - double(b[i])) / (1 + std::fabs(double(b[i]))));
        return largest;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(ShadingFunctionCases);

TYPED_TEST_P(ShadingFunctionCases, TheLibrarysModelShowsTheSame) {
    const Shot shot = this->shot();
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        const bool hasBothLevels = setting % 3 == 0 || tier.technique == std::string("msaa");
        const bool isRendered = rendersSetting<TypeParam>(setting++) || tier.technique == std::string("msaa");
        // Batches, mixed draws and fine materials change what is shaded, not how.
        const bool shadesAsOthers = tier.isBatched || tier.isMixed || tier.flags == AGAA_CONFIG_FINE_MATERIALS;
        if (!isRendered || shadesAsOthers || !runs(tier, this->context.caps()))
            continue;
        SCOPED_TRACE(tier);
        ViewSettings settings = this->settingsOf(tier);
        settings.config.ndf =
            setting % 4 < 2 && !tier.layout ? AGAA_NDF_LEAN : AGAA_NDF_TOKSVIG; // with round lobes, too
        const Shown builtIn = this->showWith(settings, shot, nullptr, AGAA_SHADING_EVENT);
        EXPECT_GT(sumOf(builtIn.rgb), 0);
        for (const auto& [glsl, level] :
             {std::pair{builtInReflectance, AGAA_SHADING_REFLECTANCE}, {builtInEvent, AGAA_SHADING_EVENT}}) {
            if (level == AGAA_SHADING_REFLECTANCE && !hasBothLevels)
                continue;
            const Shown shown = this->showWith(settings, shot, glsl, level);
            EXPECT_LE(this->largestDifference(shown.rgb, builtIn.rgb), 1e-6) << "level " << level;
            EXPECT_EQ(shown.counters.shadingEvents, builtIn.counters.shadingEvents);
            EXPECT_EQ(shown.counters.lightEvaluations, builtIn.counters.lightEvaluations);
            EXPECT_EQ(shown.counters.sanitised, builtIn.counters.sanitised);
        }
    }
}

// Shadows of the frame reach both levels, and the part that the light reaches with lit aggregates.
TYPED_TEST_P(ShadingFunctionCases, ShadowsAreThoseOfTheLibrary) {
    AgaaShadowFunction shadows = AGAA_SHADOW_FUNCTION_INIT;
    shadows.glsl =
        "float agaaHostShadow(uint shadow, vec3 position) { return fract(position.x + position.y) > 0.5 ? 1.0 : 0.0; }";
    shadows.shadows = 1;
    const AgaaShadow shadow{};
    Shot shot = this->shot();
    shot.lights[0].shadowMap = 0;
    shot.change = [&](AgaaFrame& frame) {
        addAmbient(frame);
        frame.shadows = &shadow;
        frame.shadowCount = 1;
    };
    for (size_t setting = 0; const bool isLit : {false, true})
        for (const TechniqueTier& tier : {TechniqueTier{.technique = "agaa", .n = 8, .tier = AGAA_TIER_GBUFFER},
                                          TechniqueTier{.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS},
                                          TechniqueTier{.technique = "agaa", .n = 64, .tier = AGAA_TIER_FRAGMENTS}}) {
            if (!rendersSetting<TypeParam>(setting++))
                continue;
            SCOPED_TRACE(tier);
            ViewSettings settings = this->settingsOf(tier);
            settings.facts.shadowMapCount = 1;
            settings.config.aggregation.litShadows = isLit;
            settings.chained = &shadows;
            const Shown builtIn = show(this->context, settings, shot);
            for (const auto& [glsl, level] :
                 {std::pair{builtInReflectance, AGAA_SHADING_REFLECTANCE}, {builtInEvent, AGAA_SHADING_EVENT}}) {
                AgaaShadingFunction function = shadingFunction(glsl, level);
                function.pNext = &shadows;
                settings.chained = &function;
                const Shown shown = show(this->context, settings, shot);
                EXPECT_LE(this->largestDifference(shown.rgb, builtIn.rgb), 1e-6) << "level " << level;
                EXPECT_EQ(shown.counters.shadowTaps, builtIn.counters.shadowTaps);
            }
        }
}

// A shadow function of footprints is asked once for each event, and knows of it what a shading function knows.
TYPED_TEST_P(ShadingFunctionCases, ShadowsOfFootprintsAreLookedUpOnce) {
    AgaaShadowFunction shadows = AGAA_SHADOW_FUNCTION_INIT;
    shadows.glsl = "float shadowOf(vec3 position, vec3 squares, vec3 products, float depth) {\n"
                   "    return clamp(0.5 + dot(squares + 0.5 * products, vec3(0.3, 0.2, 0.1)) - depth + "
                   "0.1 * sin(position.x), 0.0, 1.0);\n"
                   "}\n"
                   "float agaaHostShadowFootprint(uint shadow, AgaaFootprint f) {\n"
                   "    return shadowOf(f.position, f.positionSquares, f.positionProducts, f.depthVariance);\n"
                   "}\n";
    shadows.shadows = shadows.footprints = 1;
    AgaaShadowFunction ofPosition = shadows;
    ofPosition.footprints = 0;
    ofPosition.glsl = "float agaaHostShadow(uint shadow, vec3 position) {\n"
                      "    return clamp(0.5 + 0.1 * sin(position.x), 0.0, 1.0);\n"
                      "}\n";
    AgaaShadingFunction difference = shadingFunction(
        "vec3 agaaShade(AgaaSurface s) {\n"
        "    float own = shadowOf(s.position, s.positionSquares, s.positionProducts, s.depthVariance);\n"
        "    return vec3(1.0, abs(agaaShadow(0u) - own), own < 1.0 && own > 0.0 ? 1.0 : 0.0);\n"
        "}\n",
        AGAA_SHADING_EVENT);
    difference.pNext = &shadows;
    const AgaaShadow shadow{};
    Shot shot = this->shot(1);
    shot.lights = {sun()};
    shot.lights[0].shadowMap = 0;
    shot.change = [&](AgaaFrame& frame) {
        frame.shadows = &shadow;
        frame.shadowCount = 1;
    };
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        if (tier.layout || tier.isBatched || tier.isMixed || tier.technique == std::string("msaa") ||
            !runs(tier, this->context.caps()) || !rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(tier);
        ViewSettings settings = this->settingsOf(tier, 1);
        settings.facts.shadowMapCount = 1;
        settings.facts.flags &= ~AGAA_FACT_EMISSIVE; // which "visibility" adds itself
        settings.chained = &difference;
        const Shown shown = show(this->context, settings, shot);
        EXPECT_EQ(shown.counters.shadowTaps, shown.counters.shadingEvents);
        // Other events stand at one of their samples, and their shadows around the mean.
        if (tier.technique == std::string("agaa") || tier.technique == std::string("dcaa")) {
            double within = 0;
            for (size_t i = 0; i < shown.rgb.size(); i += 3) {
                ASSERT_LE(shown.rgb[i + 1], 1e-3f) << i / 3;
                within += double(shown.rgb[i + 2]);
            }
            EXPECT_GT(within, 100); // pixels
        }
        if (tier.technique == std::string("ssaa")) { // its events have one sample, and no extent
            settings.chained = &shadows;
            const Shown ofFootprints = show(this->context, settings, shot);
            settings.chained = &ofPosition;
            EXPECT_EQ(ofFootprints.rgb, show(this->context, settings, shot).rgb);
        }
    }
}

// A model of the host's own against the library's, at samples, whose normals have no spread.
TYPED_TEST_P(ShadingFunctionCases, TheTextbooksModelAgrees) {
    const Shot shot = this->shot();
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "ssaa", .n = 4}, {.technique = "msaa", .n = 4}}) {
        SCOPED_TRACE(tier);
        ViewSettings settings = this->settingsOf(tier);
        settings.config.brdf = AGAA_BRDF_GGX;
        // The textbook's denominator cancels for narrow lobes, and its cosine is 0 behind the surface.
        settings.surface = "s.alpha2 = max(s.alpha2, 0.05); "
                           "s.normal = dot(s.normal, s.position) > 0.0 ? -s.normal : s.normal;";
        const Shown builtIn = this->showWith(settings, shot, nullptr, AGAA_SHADING_EVENT);
        const Shown own = this->showWith(settings, shot, textbookReflectance, AGAA_SHADING_REFLECTANCE);
        EXPECT_LE(this->largestDifference(own.rgb, builtIn.rgb), 1e-4);
    }
}

// An event that returns 1/coverage adds one to its pixel, and the coverages of a pixel's events add up to its share of
// covered samples.
TYPED_TEST_P(ShadingFunctionCases, EventsKnowWhatTheyRepresent) {
    const char* const glsl = "vec3 agaaShade(AgaaSurface s) {\n"
                             "    ivec4 bits = bitCount(s.samples);\n"
                             "    return vec3(1.0, float(bits.x + bits.y + bits.z + bits.w), "
                             "float(s.pixel.x + 100u * s.pixel.y)) / s.coverage;\n}\n";
    Shot shot = this->shot(1);
    shot.change = {};
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        const std::string technique = tier.technique;
        // These filter images, weigh events by more than coverage, or cover what later fragments hide.
        if (technique == "fxaa" || technique == "smaa" || technique == "msaa" || technique == "visibility" ||
            technique == "adaptive" || tier.isBatched || !rendersSetting<TypeParam>(setting++) ||
            !runs(tier, this->context.caps()))
            continue;
        SCOPED_TRACE(tier);
        const ViewSettings settings = this->settingsOf(tier, 1);
        const Shown shown = this->showWith(settings, shot, glsl, AGAA_SHADING_EVENT);
        double events = 0, samples = 0;
        for (size_t i = 0; i < shown.rgb.size(); i += 3) {
            events += double(shown.rgb[i]);
            samples += double(shown.rgb[i + 1]);
            const size_t pixel = i / 3 % settings.width + 100 * (i / 3 / settings.width);
            EXPECT_NEAR(double(shown.rgb[i + 2]), double(pixel) * double(shown.rgb[i]), 1e-4 * double(pixel));
        }
        EXPECT_NEAR(events, double(shown.counters.shadingEvents), 1e-4 * events);
        EXPECT_NEAR(samples, double(shown.counters.visible), 1e-4 * samples);
        EXPECT_GT(events, 100);
    }
}

// A translucent card of alpha 1/2 covers half of the samples of each fragment of `msaa`.
TYPED_TEST_P(ShadingFunctionCases, MasksLeaveHalfOfTheSamples) {
    Triangle overView = rectangle(-96, 0, 96, 128, 1, {})[0];
    overView.isMasked = true;
    overView.material.diffuse.w = 0.5f;
    const Shot shot{.triangles = {overView}, .lights = {}};
    for (const uint32_t n : {4u, 8u}) {
        SCOPED_TRACE(n);
        ViewSettings settings;
        settings.config.technique = "msaa";
        settings.config.samples = n;
        settings.projection = pixelOrthographic(48, 32, 10);
        settings.facts.flags |= AGAA_FACT_ALPHA_MASKED;
        settings.facts.shadowMapCount = 0;
        const Shown shown = this->showWith(
            settings, shot, "vec3 agaaShade(AgaaSurface s) { return vec3(float(bitCount(s.samples.x))); }\n",
            AGAA_SHADING_EVENT);
        // A fragment, whose texel has at most 4 of the samples, adds its share of the pixel times its number of
        // samples. Rasterisers may split the card, whose parts then have fewer samples each.
        const float expected = 0.25f * float(this->context.caps().sampleCounts & n ? n : 4);
        size_t whole = 0;
        for (size_t i = 0; i < shown.rgb.size(); i += 3) {
            whole += std::fabs(shown.rgb[i] - expected) < 1e-3f;
            ASSERT_LT(shown.rgb[i], expected + 1e-3f) << i / 3;
        }
        EXPECT_GT(3 * whole, shown.rgb.size() / 20 * 19);
    }
}

// The moments of unit normals add up to 1, contain the mean normal, and are those of one direction where normals agree.
TYPED_TEST_P(ShadingFunctionCases, MomentsAreThoseOfUnitNormals) {
    const char* const glsl = R"(
vec3 agaaShade(AgaaSurface s) {
    vec3 n = s.normal, squares = s.normalSquares, products = s.normalProducts;
    float trace = squares.x + squares.y + squares.z;
    float along = dot(squares, n * n) + 2.0 * dot(products, n.yzx * n.zxy);
    float above = s.materialAlpha2 - s.alpha2 * 1.0001 - 1e-6;
    return vec3(abs(trace - 1.0), max(s.normalLength * s.normalLength - along, 0.0), max(above, 0.0)) +
           (any(isnan(products)) ? vec3(1e3) : vec3(0.0));
}
)";
    const char* const spread = R"(
vec3 agaaShade(AgaaSurface s) {
    vec3 n = s.normal;
    float along = dot(s.normalSquares, n * n) + 2.0 * dot(s.normalProducts, n.yzx * n.zxy);
    return vec3(1.0 - s.normalLength, 1.0 - along, 0.0);
}
)";
    Shot shot = this->shot(1);
    shot.change = {};
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        if (tier.layout || tier.isBatched || tier.isMixed || !runs(tier, this->context.caps()) ||
            !rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(tier);
        for (const uint32_t ndf : {AGAA_NDF_TOKSVIG, AGAA_NDF_LEAN}) {
            ViewSettings settings = this->settingsOf(tier, 1);
            settings.config.ndf = ndf;
            settings.facts.flags &= ~AGAA_FACT_EMISSIVE; // which "visibility" adds itself
            const Shown errors = this->showWith(settings, shot, glsl, AGAA_SHADING_EVENT);
            for (size_t i = 0; i < errors.rgb.size(); ++i)
                ASSERT_LE(errors.rgb[i], i % 3 == 1 ? 2e-3f : 1e-4f) << i << " with NDF " << ndf;
            if (tier.technique != std::string("agaa"))
                continue;
            const Shown spreads = this->showWith(settings, shot, spread, AGAA_SHADING_EVENT);
            double shorter = 0, across = 0;
            for (size_t i = 0; i < spreads.rgb.size(); i += 3) {
                shorter += double(spreads.rgb[i]);
                across += double(spreads.rgb[i + 1]);
            }
            EXPECT_GT(shorter, 1);      // normals spread
            EXPECT_GT(across, shorter); // 1 - L^2 or more
        }
    }
}

// The footprint of an event is that of its samples, as supersampling sees them one by one, and bounds positionSpread.
TYPED_TEST_P(ShadingFunctionCases, FootprintsAreThoseOfSamples) {
    const auto event = [](const char* value) {
        return std::string("vec3 agaaShade(AgaaSurface s) { float z = dot(transpose(mat3(agaa_frame.view))[2], "
                           "s.position); return ") +
               value + "; }\n";
    };
    Shot shot = this->shot(1);
    shot.change = {};
    const auto shown = [&](ViewSettings settings, const char* value) {
        settings.facts.flags &= ~AGAA_FACT_EMISSIVE; // which "visibility" adds itself
        return this->showWith(settings, shot, event(value).c_str(), AGAA_SHADING_EVENT).rgb;
    };
    // A turned view, so that the rows of its matrix are not its columns.
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.4f, glm::normalize(glm::vec3(1, 2, 0.5f)));
    for (Triangle& t : shot.triangles)
        for (glm::vec3& p : t.position)
            p = glm::transpose(glm::mat3(turned)) * p;
    const char* const bounds = "vec3(max(s.positionSpread - dot(s.positionSquares, vec3(1.0)), 0.0), "
                               "max(s.positionProducts.z * s.positionProducts.z - s.positionSquares.x * "
                               "s.positionSquares.y, 0.0), max(s.depthVariance - dot(s.positionSquares, vec3(1.0)), "
                               "0.0))";
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        if (tier.layout || tier.isBatched || tier.isMixed || !runs(tier, this->context.caps()) ||
            !rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(tier);
        ViewSettings settings = this->settingsOf(tier, 1);
        settings.view = turned;
        for (const float excess : shown(settings, bounds))
            ASSERT_LE(excess, 1e-4f);
        // Spreads that the width of a pixel does not bound are the trace.
        const std::vector<float> spreads =
            shown(settings, "vec3(100.0 * s.positionSpread, 100.0 * dot(s.positionSquares, vec3(1.0)), 1.0)");
        size_t equal = 0, wider = 0;
        for (size_t i = 0; i < spreads.size(); i += 3) {
            equal += std::fabs(spreads[i] - spreads[i + 1]) <= 0.01f * spreads[i + 1];
            wider += spreads[i + 1] > 1.01f * spreads[i];
        }
        if (tier.technique != std::string("msaa")) { // which has no positionSpread
            EXPECT_GT(equal, wider) << wider;
        }
        const bool seesAllSamples = tier.technique == std::string("agaa") && tier.tier != AGAA_TIER_FRAGMENTS &&
                                    tier.visibility == AGAA_TIER_AUTO && // other sample positions

                                    tier.tier != AGAA_TIER_MATERIAL_LISTS;
        if (!seesAllSamples)
            continue;
        // Moments around the eye, because half floats of the image would not show a small difference of squares.
        ViewSettings all = this->settingsOf(tier, 1);
        all.config.technique = "ssaa";
        all.config.generationTier = AGAA_TIER_AUTO;
        all.config.flags = 0;
        all.view = turned;
        settings.config.aggregates = 1;
        size_t spread = 0;
        for (const auto& [ofAggregates, ofSamples] :
             {std::pair{"s.positionSquares + s.position * s.position", "s.position * s.position"},
              {"20.0 + 0.05 * (s.positionProducts + s.position.yzx * s.position.zxy)",
               "20.0 + 0.05 * s.position.yzx * s.position.zxy"}, // no negative light
              {"vec3(s.depthVariance + z * z)", "vec3(z * z)"}}) {
            const std::vector<float> aggregates = shown(settings, ofAggregates), samples = shown(all, ofSamples);
            const std::vector<float> atMeans = shown(settings, ofSamples);
            for (size_t i = 0; i < samples.size(); ++i) {
                ASSERT_NEAR(aggregates[i], samples[i], 0.002f * (1 + std::fabs(samples[i])))
                    << ofAggregates << ' ' << i;
                spread += std::fabs(aggregates[i] - atMeans[i]) > 0.1f * std::fabs(samples[i]);
            }
        }
        EXPECT_GT(spread, 100u); // edges between surfaces at different depths
    }
}

// A fragment of "msaa" has the footprint of the samples that it covers, as an aggregate of the same samples has.
TYPED_TEST_P(ShadingFunctionCases, FootprintsOfFragmentsAreThoseOfTheirSamples) {
    Shot shot = this->shot(1);
    shot.change = {};
    shot.triangles.resize(2); // apart from each other, at a slant
    const glm::vec3 corners[] = {{-1.5f, -1, -3},   {-0.1f, -0.9f, -4}, {-0.8f, 1.2f, -9},
                                 {0.2f, -1, -2.5f}, {1.4f, -0.8f, -2},  {0.9f, 1, -2.2f}};
    for (size_t i = 0; i < std::size(corners); ++i)
        shot.triangles[i / 3].position[i % 3] = corners[i];
    // With a texel per pixel, a fragment covers the samples of a triangle that a pixel has.
    const TechniqueTier fragments{.technique = "msaa", .n = 4}, aggregates{.technique = "agaa", .n = 4};
    const auto shown = [&](const TechniqueTier& tier, const char* value) {
        ViewSettings settings = this->settingsOf(tier, 1);
        settings.config.aggregates = 1;
        settings.view = glm::rotate(glm::mat4(1), 0.1f, glm::normalize(glm::vec3(1, 2, 0.5f)));
        const std::string glsl = "vec3 agaaShade(AgaaSurface s) { return " + std::string(value) + "; }\n";
        return this->showWith(settings, shot, glsl.c_str(), AGAA_SHADING_EVENT).rgb;
    };
    for (const char* value :
         {"1000.0 * s.positionSquares", "500.0 + 1000.0 * s.positionProducts", "vec3(1000.0 * s.depthVariance)"}) {
        const std::vector<float> ofFragments = shown(fragments, value), of = shown(aggregates, value);
        ASSERT_GT(sumOf(of), 100);
        for (size_t i = 0; i < of.size(); ++i)
            ASSERT_NEAR(ofFragments[i], of[i], 0.004f * (1 + std::fabs(of[i]))) << value << ' ' << i;
    }
}

// An attribute of the host that is a copy of another has the same mean, to the rounding of 8 and 16 bits.
TYPED_TEST_P(ShadingFunctionCases, CustomAttributesAreMeansAsOthers) {
    const AgaaLayout layout = layoutWithVelocity();
    Shot shot = this->shot(1);
    shot.change = {};
    shot.material = "m.velocity = m.diffuse.xy;";
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        if (tier.layout || tier.isBatched || tier.isMixed || !runs(tier, this->context.caps()) ||
            !(rendersSetting<TypeParam>(setting++) || tier.technique == std::string("msaa")))
            continue;
        SCOPED_TRACE(tier);
        ViewSettings settings = this->settingsOf(tier, 1);
        settings.config.layout = &layout;
        settings.surface = "s.velocity = s.diffuse.xy;";
        const auto shown = [&](const char* result) {
            const std::string glsl = "vec3 agaaShade(AgaaSurface s) { return vec3(" + std::string(result) + "); }\n";
            return this->showWith(settings, shot, glsl.c_str(), AGAA_SHADING_EVENT).rgb;
        };
        const std::vector<float> copies = shown("s.velocity, 0.0");
        EXPECT_LE(this->largestDifference(copies, shown("s.diffuse.xy, 0.0")), 1.5 / 255);
        EXPECT_GT(sumOf(copies), 100);
    }
}

TYPED_TEST_P(ShadingFunctionCases, ResultsAreContainedAndCounted) {
    Shot shot = this->shot(1);
    shot.change = {};
    shot.lights = {sun()};
    const auto reflectance = [&](const char* result) {
        return std::string("vec3 agaaReflect(AgaaSurface s, vec3 toLight, vec3 toEye) { return vec3(") + result +
               "); }\n";
    };
    const auto event = [&](const char* result) {
        return std::string("vec3 agaaShade(AgaaSurface s) { return vec3(") + result + "); }\n";
    };
    const char* const notANumber = "(s.alpha2 - s.alpha2) / (s.alpha2 - s.alpha2)";
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "agaa", .n = 4}, {.technique = "msaa", .n = 4}}) {
        SCOPED_TRACE(tier);
        const ViewSettings settings = this->settingsOf(tier, 1);
        const Shown dark = this->showWith(settings, shot, event("0.0").c_str(), AGAA_SHADING_EVENT);
        EXPECT_EQ(sumOf(dark.rgb), 0);
        const Shown bad = this->showWith(settings, shot, event(notANumber).c_str(), AGAA_SHADING_EVENT);
        EXPECT_EQ(bad.rgb, dark.rgb);
        EXPECT_EQ(bad.counters.sanitised, dark.counters.sanitised + bad.counters.shadingEvents);
        EXPECT_EQ(this->showWith(settings, shot, event("-2.0").c_str(), AGAA_SHADING_EVENT).rgb, dark.rgb);
        const Shown bright = this->showWith(settings, shot, event("1e38").c_str(), AGAA_SHADING_EVENT);
        EXPECT_EQ(nonFinite(bright.rgb), 0u);
        const Shown unlit = this->showWith(settings, shot, reflectance("0.0").c_str(), AGAA_SHADING_REFLECTANCE);
        const Shown badLobe = this->showWith(settings, shot, reflectance(notANumber).c_str(), AGAA_SHADING_REFLECTANCE);
        EXPECT_EQ(badLobe.rgb, unlit.rgb);
        EXPECT_GT(badLobe.counters.sanitised, unlit.counters.sanitised);
    }
    TypeParam::forgetMessages();
}

TYPED_TEST_P(ShadingFunctionCases, BadOnesAreRefusedInASentence) {
    struct Row {
        const char* what;
        AgaaResult code;
        std::function<void(AgaaShadingFunction&)> spoil;
    };
    const Row rows[] = {
        {"no text", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = nullptr; }},
        {"does not compile", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = "float x = ;"; }},
        {"no function", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = "float other;"; }},
        {"the function of the other level", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f) { f.glsl = builtInReflectance; }},
        {"another type", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& f) { f.glsl = "float agaaShade(AgaaSurface s) { return 1.0; }"; }},
        {"a name of the library", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& f) {
             f.glsl = "struct AgaaSurface { float x; };\nvec3 agaaShade(AgaaSurface s) { return vec3(1.0); }";
         }},
        {"level", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.level = 2; }},
        {"reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto& f) { f.reserved = 1; }},
        {"size", AGAA_ERROR_STRUCT, [](auto& f) { f.structSize = 8; }},
    };
    for (const Row& row : rows)
        for (const char* technique : {"agaa", "msaa"}) { // whose function the host compiles, too
            AgaaShadingFunction function = shadingFunction(builtInEvent, AGAA_SHADING_EVENT);
            row.spoil(function);
            ViewSettings settings;
            settings.config.technique = technique;
            settings.chained = &function;
            expectRefused(this->context, settings, row.code, row.what);
        }
    AgaaLayout layout = layoutWithVelocity();
    layout.attributes[layout.attributeCount - 1].name = "coverage";
    const AgaaShadingFunction valid = shadingFunction(builtInEvent, AGAA_SHADING_EVENT);
    ViewSettings taken;
    taken.config.layout = &layout;
    EXPECT_NO_THROW((typename TypeParam::View(this->context, taken)));
    taken.chained = &valid;
    const std::string sentence = expectRefused(this->context, taken, AGAA_ERROR_LAYOUT, "a name of a member");
    EXPECT_NE(sentence.find("\"coverage\""), std::string::npos) << sentence;
    // Messages of the compiler count the host's lines.
    const AgaaShadingFunction function =
        shadingFunction("vec3 agaaShade(AgaaSurface s) {\n    return s.noSuchMember;\n}\n", AGAA_SHADING_EVENT);
    for (const char* technique : {"agaa", "msaa"}) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.chained = &function;
        const std::string text = expectRefused(this->context, settings, AGAA_ERROR_INVALID_ARGUMENT, "no such member");
        EXPECT_NE(text.find("AgaaShadingFunction::glsl"), std::string::npos) << text;
        EXPECT_TRUE(text.find("0:2") != std::string::npos || text.find(":2(") != std::string::npos) << text;
    }
    TypeParam::forgetMessages();
}

REGISTER_TYPED_TEST_SUITE_P(ShadingFunctionCases, TheLibrarysModelShowsTheSame, ShadowsAreThoseOfTheLibrary,
                            ShadowsOfFootprintsAreLookedUpOnce, TheTextbooksModelAgrees, EventsKnowWhatTheyRepresent,
                            MasksLeaveHalfOfTheSamples, MomentsAreThoseOfUnitNormals, FootprintsAreThoseOfSamples,
                            FootprintsOfFragmentsAreThoseOfTheirSamples, CustomAttributesAreMeansAsOthers,
                            ResultsAreContainedAndCounted, BadOnesAreRefusedInASentence);

} // namespace agaa::test
