// The tier ids, by what can be seen from outside: images, counters, validation. Each graphics API
// instantiates these.
#pragma once

#include "agreement.h"
#include "setting_share.h"
#include "shown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agaa::test {

// n samples, c aggregates.
inline ViewSettings idsSettings(uint32_t n, uint32_t c, uint32_t tier = AGAA_TIER_IDS, uint64_t flags = 0) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.generationTier = tier;
    settings.config.flags = flags;
    settings.facts.shadowMapCount = 0;
    return settings;
}

// Each triangle of one material: what tiers still differ by is where they take positions and how
// they round.
inline Shot idsShot(uint32_t triangles = 150, float duplicates = 0.1f) {
    return {.triangles = randomTriangles({.triangles = triangles, .duplicates = duplicates, .masked = 0.2f}, 61),
            .change = addAmbient};
}

template <class Host> class IdsCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(IdsCases);

TYPED_TEST_P(IdsCases, ShowWhatTwoPassesShow) {
    for (const auto& [n, c] : {std::pair{1u, 1u}, {4u, 2u}, {8u, 1u}, {8u, 2u}, {8u, 4u}, {32u, 2u}}) {
        SCOPED_TRACE("n=" + std::to_string(n) + " c=" + std::to_string(c));
        Shot shot = idsShot();
        shot.triangles = settleTies(shot.triangles, this->context.caps());
        const Shown ids = this->render(idsSettings(n, c), shot);
        const Shown twice = this->render(idsSettings(n, c, AGAA_TIER_AUTO), shot);
        EXPECT_EQ(ids.geometryPasses, 1u);
        EXPECT_EQ(twice.geometryPasses, 2u);
        const Difference d = compare(ids.rgb, twice.rgb);
        std::printf("n=%u c=%u: PSNR %.1f dB, %.3f %% of pixels beyond 24/255\n", n, c, d.psnr, 100 * d.farPixels);
        EXPECT_GE(d.psnr, 95) << "the tiers are of one technique";
        EXPECT_EQ(d.farPixels, 0);
        EXPECT_EQ(ids.counters.visible, twice.counters.visible);
        EXPECT_EQ(ids.counters.once, ids.counters.visible);
        EXPECT_EQ(ids.counters.uncovered + ids.counters.overlapping + ids.counters.misplaced, 0u);
        EXPECT_TRUE(ids.validation.isValid) << ids.validation.explanation;
        EXPECT_NEAR(double(ids.counters.shadingEvents), double(twice.counters.shadingEvents),
                    0.002 * double(twice.counters.shadingEvents));
    }
}

// Four large surfaces that lean away from the eye: nearly all pixels show one primitive.
inline std::vector<Triangle> leaningSurfaces() {
    std::vector<Triangle> list;
    for (int i = 0; i < 4; ++i) {
        Triangle t;
        const float x = float(i) - 2, far = 6 + float(i);
        t.position[0] = {x, -2, -2};
        t.position[1] = {x + 1.2f, -2, -2.5f};
        t.position[2] = {2 * x, 3, -far};
        t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
        t.material.normal = glm::vec4(planeNormal(t), 0.3f);
        list.push_back(t);
    }
    return list;
}

// Pixels of one primitive are grouped like all others where surfaces may be split.
TYPED_TEST_P(IdsCases, SplitSurfacesAreGroupedAsByTwoPasses) {
    const Shot shot{.triangles = leaningSurfaces(), .change = addAmbient};
    const auto rendered = [&](uint32_t tier, uint64_t flags) {
        ViewSettings settings = idsSettings(8, 2, tier, flags);
        settings.config.aggregation.characteristicLength = 0.02f;
        settings.config.aggregation.characteristicLengthPerDistance = 0;
        return this->render(settings, shot);
    };
    const Shown twice = rendered(AGAA_TIER_AUTO, AGAA_CONFIG_SPLIT_SURFACES);
    const double events = double(twice.counters.shadingEvents);
    EXPECT_GT(events, 1.5 * double(rendered(AGAA_TIER_IDS, 0).counters.shadingEvents)) << "there is something to split";
    for (const uint64_t flag : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
        const Shown ids = rendered(AGAA_TIER_IDS, flag | AGAA_CONFIG_SPLIT_SURFACES);
        EXPECT_NEAR(double(ids.counters.shadingEvents), events, 0.01 * events) << (flag ? "buffered" : "at once");
        EXPECT_EQ(ids.counters.once, ids.counters.visible);
        EXPECT_EQ(ids.counters.visible, twice.counters.visible);
        EXPECT_GE(compare(ids.rgb, twice.rgb).psnr, 60);
    }
}

// As the preset asks for, without fine materials.
inline ViewSettings accurateSettings(const char* technique, uint32_t tier) {
    ViewSettings settings = idsSettings(8, 4, tier);
    settings.config.applyPreset("accurate");
    settings.config.flags &= ~AGAA_CONFIG_FINE_MATERIALS;
    settings.config.technique = technique;
    return settings;
}

// Small facets of a plane whose shading normals face the eye and away from it in turn: one surface by their planes,
// but a mean of such normals has no direction.
TYPED_TEST_P(IdsCases, OpposedShadingNormalsOfOnePlaneAreGrouped) {
    Shot shot{.change = addAmbient};
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            Material m;
            m.normal = glm::vec4(0, 0, (x + y) % 2 ? 1 : -1, 1e-2f);
            const glm::vec2 corner = 0.6f * glm::vec2(x, y);
            for (const Triangle& t : rectangle(corner.x, corner.y, corner.x + 0.6f, corner.y + 0.6f, 5, m))
                shot.triangles.push_back(t);
        }
    const auto shown = [&](const char* technique, uint32_t tier) {
        ViewSettings settings = accurateSettings(technique, tier);
        settings.width = settings.height = 24;
        settings.projection = pixelOrthographic(24, 24, 10);
        settings.config.aggregation.characteristicLength = 100; // normals alone
        return this->render(settings, shot);
    };
    const Shown truth = shown("ssaa", AGAA_TIER_AUTO);
    const Shown ids = shown("agaa", AGAA_TIER_IDS);
    const Difference d = compare(ids.rgb, truth.rgb);
    std::printf("PSNR %.1f dB, energy %.3f\n", d.psnr, sumOf(ids.rgb) / sumOf(truth.rgb));
    EXPECT_GE(d.psnr, 40);
    EXPECT_NEAR(sumOf(ids.rgb) / sumOf(truth.rgb), 1, 0.02);
}

// The shading normal of one primitive that turns fast parts its samples too, where gloss weighs normals.
TYPED_TEST_P(IdsCases, NormalsThatTurnWithinAPrimitiveAreGrouped) {
    Shot shot{.triangles = leaningSurfaces(), .change = addAmbient};
    shot.material = "float turn = 60.0 * p.at.x; m.alpha2 = 1e-3;\n"
                    "m.normal = vec3(sin(turn), 0.0, cos(turn));\n"
                    "m.normalDx = 60.0 * p.dx.x * vec3(cos(turn), 0.0, -sin(turn));\n"
                    "m.normalDy = 60.0 * p.dy.x * vec3(cos(turn), 0.0, -sin(turn));\n";
    ViewSettings settings = accurateSettings("agaa", AGAA_TIER_IDS);
    const Shown grouped = this->render(settings, shot);
    settings.config.aggregation.glossWeight = 0;
    const Shown whole = this->render(settings, shot);
    EXPECT_GT(double(grouped.counters.shadingEvents), 1.3 * double(whole.counters.shadingEvents));
    EXPECT_EQ(grouped.counters.primitives, whole.counters.primitives);
    EXPECT_EQ(grouped.counters.visible, whole.counters.visible);
    EXPECT_EQ(grouped.counters.once, grouped.counters.visible);
    EXPECT_EQ(grouped.counters.shadedPixels, whole.counters.shadedPixels);
}

// What is kept in memory between the passes, and where some triangles come from, does not change
// the image.
TYPED_TEST_P(IdsCases, BufferedAndUnfetchedShowTheSame) {
    Shot shot = idsShot(150, 0);
    for (size_t setting = 0; const auto& [n, c] : {std::pair{1u, 1u}, {8u, 1u}, {8u, 2u}, {32u, 4u}}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE("n=" + std::to_string(n) + " c=" + std::to_string(c));
        shot.fetchFlags = 0;
        const Shown fused = this->render(idsSettings(n, c), shot);
        const auto expectLike = [&](const ViewSettings& settings, double psnr) {
            const Shown other = this->render(settings, shot);
            const Difference d = compare(fused.rgb, other.rgb);
            std::printf("n=%u c=%u: PSNR %.1f dB\n", n, c, d.psnr);
            EXPECT_GE(d.psnr, psnr);
            EXPECT_EQ(d.farPixels, 0);
            EXPECT_EQ(other.counters.visible, fused.counters.visible);
            EXPECT_EQ(other.counters.once, other.counters.visible);
            EXPECT_EQ(other.counters.uncovered + other.counters.overlapping, 0u);
            return other.counters;
        };
        const AgaaCounters buffered = expectLike(idsSettings(n, c, AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED), 95);
        EXPECT_EQ(buffered.shadingEvents, fused.counters.shadingEvents);
        EXPECT_EQ(buffered.materials, fused.counters.materials);
        shot.fetchFlags = AGAA_FETCH_NOT_ALL_DRAWS;
        for (uint64_t flag : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            ViewSettings settings = idsSettings(n, c, AGAA_TIER_IDS, flag);
            settings.shader = ViewSettings::Shader::ThirdUnfetched;
            const AgaaCounters mixed = expectLike(settings, 90);
            EXPECT_LT(mixed.materials, fused.counters.materials);
            EXPECT_GT(mixed.materials, fused.counters.materials / 2);
        }
    }
}

// Of equal depths the first drawn is shown, masked materials included, where the second pass draws it too.
TYPED_TEST_P(IdsCases, HardCase25UnfetchedDrawsShowTheFirstOfEqualDepths) {
    for (const bool isMasked : {false, true}) {
        SCOPED_TRACE(isMasked ? "masked" : "opaque");
        std::vector<Triangle> list;
        for (const glm::vec3& colour : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
            for (int i = 0; i < 3; ++i) { // the test host's shader cannot fetch each third
                Triangle t;
                t.position[0] = {-9, -9, -4};
                t.position[1] = {9, -9, -4};
                t.position[2] = {0, 12, -4};
                t.material.diffuse = glm::vec4(colour, isMasked ? 0.6f : 1.0f);
                t.material.specular = glm::vec4(0);
                t.isMasked = isMasked;
                t.seed = 3 * uint32_t(list.size() / 3) + 1;
                list.push_back(t);
            }
        Shot shot{.triangles = list, .change = addAmbient, .fetchFlags = AGAA_FETCH_NOT_ALL_DRAWS};
        const Shown drawnOnce = this->render(idsSettings(8, 2, AGAA_TIER_GBUFFER), shot);
        for (const bool isReversed : {false, true}) {
            ViewSettings settings = idsSettings(8, 2);
            settings.shader = ViewSettings::Shader::ThirdUnfetched;
            if (isReversed) {
                settings.flags = AGAA_VIEW_REVERSED_Z;
                settings.projection = reversedInfinite(60, 1.5f, 0.1f);
            }
            const Shown shown = this->render(settings, shot);
            EXPECT_GE(compare(shown.rgb, drawnOnce.rgb).psnr, 60);
            EXPECT_EQ(shown.counters.once, shown.counters.visible);
            EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
        }
    }
}

// What neither functions nor the G-buffer give a material: counted, left out of the image, told by
// validation.
TYPED_TEST_P(IdsCases, UnfetchedSamplesThatAreNotDrawnAreMissed) {
    Shot shot = idsShot(150, 0);
    shot.fetchFlags = AGAA_FETCH_NOT_ALL_DRAWS;
    for (uint64_t flag : {uint64_t(0), AGAA_CONFIG_BUFFERED})
        for (uint32_t c : {1u, 2u}) {
            ViewSettings settings = idsSettings(8, c, AGAA_TIER_IDS, flag);
            settings.shader = ViewSettings::Shader::ThirdUnfetched;
            settings.mistake.materialDepth = 1.01f; // no depth of the second pass is equal
            const Shown shown = this->render(settings, shot);
            EXPECT_GT(shown.counters.uncovered, shown.counters.visible / 10);
            EXPECT_EQ(shown.counters.once + shown.counters.uncovered, shown.counters.visible);
            EXPECT_EQ(shown.counters.overlapping, 0u);
            EXPECT_FALSE(shown.validation.isValid);
            EXPECT_GT(shown.validation.invalidPixels, 0u);
            EXPECT_EQ(nonFinite(shown.rgb), 0u);
        }
}

// A primitive is fetched once in a pixel, however many of its samples it has.
TYPED_TEST_P(IdsCases, CountersTellPrimitivesAndMaterials) {
    const AgaaCounters c = this->render(idsSettings(8, 2), idsShot()).counters;
    ViewSettings view = idsSettings(8, 2);
    view.config.measurement.debugView = AGAA_DEBUG_VIEW_PRIMITIVES;
    EXPECT_NEAR(sumOf(this->render(view, idsShot()).rgb) / 3, double(c.primitives), 0.5);
    EXPECT_EQ(c.materials, c.primitives);
    EXPECT_EQ(c.aggregates, c.shadingEvents);
    EXPECT_GT(c.primitives, c.shadedPixels);
    EXPECT_LT(c.primitives, c.visible);
}

// A triangle a sample: a tile has up to eight times what its list holds, so that pixels take their
// turns, and none of it is lost; nor do the loops of a group of tiles turn more often than Mesa lets them.
TYPED_TEST_P(IdsCases, MorePrimitivesThanATileListsAreAllShown) {
    constexpr uint32_t perPixel = 64, width = 32, height = 32;
    std::mt19937 random(83);
    Shot shot{.change = addAmbient};
    for (uint32_t i = 0; i < perPixel * (width + height / 8); ++i) {
        const float x = float(i) / perPixel - height / 8;
        for (Triangle& t : rectangle(x, 0, x + 1.0f / perPixel, height, 1 + float(i % 7), randomMaterial(random))) {
            for (glm::vec3& corner : t.position) // leans, so that samples one above the other are of different strips
                corner.x += corner.y / 8;
            shot.triangles.push_back(t);
        }
    }
    for (uint32_t n : {8u, 32u})
        for (uint64_t flag : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            ViewSettings settings = idsSettings(n, 4, AGAA_TIER_IDS, flag);
            settings.width = width;
            settings.height = height;
            settings.projection = pixelOrthographic(width, height, 10);
            const Shown ids = this->render(settings, shot);
            settings.config.flags = 0;
            settings.config.generationTier = AGAA_TIER_AUTO;
            const Difference d = compare(ids.rgb, this->render(settings, shot).rgb);
            const double perTile = double(ids.counters.primitives) / double(width / 8 * (height / 8));
            std::printf("n=%u: %.1f primitives a tile, PSNR %.1f dB\n", n, perTile, d.psnr);
            EXPECT_EQ(perTile, n * 64);
            EXPECT_EQ(ids.counters.materials, ids.counters.primitives);
            EXPECT_EQ(ids.counters.visible, uint64_t(n) * width * height);
            EXPECT_EQ(ids.counters.once, ids.counters.visible);
            EXPECT_GE(d.psnr, 100);
            EXPECT_EQ(d.farPixels, 0);
        }
}

// Instances are numbered as draws, and placed by the expression that the raster pass places them
// with.
TYPED_TEST_P(IdsCases, InstancesAreDrawsOfTheirOwn) {
    const Shot shot = idsShot(60, 0);
    ViewSettings settings = idsSettings(8, 2);
    settings.instances = 3;
    const Shown ids = this->render(settings, shot);
    EXPECT_TRUE(ids.validation.isValid) << ids.validation.explanation;
    settings.config.generationTier = AGAA_TIER_AUTO;
    const Shown twice = this->render(settings, shot);
    const Difference d = compare(ids.rgb, twice.rgb);
    std::printf("PSNR %.1f dB\n", d.psnr);
    EXPECT_GE(d.psnr, 95);
    EXPECT_EQ(ids.counters.visible, twice.counters.visible);
    settings.instances = 1;
    EXPECT_GT(ids.counters.visible, this->render(settings, shot).counters.visible) << "there is more to see";
}

// A host that draws more than it announced: what is beyond shows the last announced, is counted,
// and fetches nothing that is not there.
TYPED_TEST_P(IdsCases, WhatWasNotAnnouncedIsCounted) {
    const auto onlyShining = [](const std::string& condition) {
        return "m.diffuse = m.specular = vec3(0.0); m.emissive = vec3(" + condition + " ? 16.0 : 0.0);";
    };
    const auto shining = [](const Shown& shown) { // one sample of four is at 4
        return std::count_if(shown.rgb.begin(), shown.rgb.end(), [](float value) { return value > 3; });
    };
    Shot shot = idsShot();
    shot.announced = 10;
    const std::string late = onlyShining("p.primitive >= 10u");
    shot.material = late.c_str();
    const Shown beyond = this->render(idsSettings(4, 2), shot);
    EXPECT_EQ(shining(beyond), 0);
    EXPECT_GT(beyond.counters.unannounced, 0u);
    EXPECT_EQ(beyond.counters.sanitised, 0u);
    EXPECT_EQ(beyond.validation.unannounced, beyond.counters.unannounced);
    EXPECT_FALSE(beyond.validation.isValid);
    EXPECT_NE(std::string(beyond.validation.explanation).find("did not announce"), std::string::npos)
        << beyond.validation.explanation;
    // All that is beyond is primitive 9.
    const std::string last = onlyShining("p.primitive == 9u");
    shot.material = last.c_str();
    const auto lastShining = shining(this->render(idsSettings(4, 2), shot));
    shot.announced = idsShot().announced;
    EXPECT_GT(lastShining, shining(this->render(idsSettings(4, 2), shot)));
    ViewSettings instanced = idsSettings(4, 2);
    instanced.instances = 3;
    Shot draws = idsShot();
    draws.announcedDraws = drawNumber + 2;
    const std::string lateDraw = onlyShining("p.draw >= 7u");
    draws.material = lateDraw.c_str();
    const Shown third = this->render(instanced, draws);
    EXPECT_EQ(shining(third), 0);
    EXPECT_GT(third.validation.unannounced, 0u);
    EXPECT_FALSE(third.validation.isValid);
    // The last draw may have one primitive alone: the others that shine are those of its own.
    draws.announcedDraws = drawNumber + 1;
    const std::string notFirst = onlyShining("p.primitive != 0u");
    draws.material = notFirst.c_str();
    const auto own = shining(this->render(idsSettings(4, 2), draws));
    const Shown two = this->render(instanced, draws);
    EXPECT_GT(two.counters.unannounced, 0u);
    EXPECT_GT(own, 0);
    EXPECT_LE(shining(two), own);
    const Shown within = this->render(idsSettings(4, 2), idsShot());
    EXPECT_EQ(within.counters.unannounced + within.validation.unannounced, 0u);
    EXPECT_TRUE(within.validation.isValid) << within.validation.explanation;
}

TYPED_TEST_P(IdsCases, MaterialsThatAreNotFiniteAreContained) {
    Shot shot = idsShot(60);
    for (const char* bad : {"0.0 / (m.alpha2 - m.alpha2)", "1.0 / (m.alpha2 - m.alpha2)", "1e30", "-1e30"}) {
        const std::string text = std::string("float bad = ") + bad +
                                 "; m = AgaaMaterial(vec3(bad), vec3(bad), vec3(bad), vec3(bad), "
                                 "bad, vec3(bad), vec3(bad));";
        shot.material = text.c_str();
        for (float value : this->render(idsSettings(8, 2), shot).rgb) {
            ASSERT_TRUE(std::isfinite(value)) << bad;
            ASSERT_GE(value, 0.0f);
        }
    }
}

REGISTER_TYPED_TEST_SUITE_P(IdsCases, ShowWhatTwoPassesShow, SplitSurfacesAreGroupedAsByTwoPasses,
                            OpposedShadingNormalsOfOnePlaneAreGrouped, NormalsThatTurnWithinAPrimitiveAreGrouped,
                            BufferedAndUnfetchedShowTheSame, HardCase25UnfetchedDrawsShowTheFirstOfEqualDepths,
                            UnfetchedSamplesThatAreNotDrawnAreMissed, CountersTellPrimitivesAndMaterials,
                            MorePrimitivesThanATileListsAreAllShown, InstancesAreDrawsOfTheirOwn,
                            WhatWasNotAnnouncedIsCounted, MaterialsThatAreNotFiniteAreContained);

} // namespace agaa::test
