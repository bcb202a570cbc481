// Decoupled coverage, by what can be seen from outside. Each graphics API instantiates these.
#pragma once

#include "agreement.h"
#include "dcaa_lists.h"
#include "hard_case_test.h"
#include "shown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

namespace agaa::test {

inline ViewSettings dcaaSettings(uint32_t samples = 64, uint32_t surfaces = 4,
                                 uint32_t tier = AGAA_TIER_FRAGMENT_LISTS) {
    ViewSettings settings;
    settings.config.technique = "dcaa";
    settings.config.samples = samples;
    settings.config.aggregates = surfaces;
    settings.config.generationTier = tier;
    settings.facts.shadowMapCount = 0;
    return settings;
}

template <class Host> class DcaaCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }

    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(DcaaCases);

// A rectangle of radiance 1 before black: pixels show the share that it covers.
TYPED_TEST_P(DcaaCases, EdgesCoverTheirShare) {
    for (const uint32_t samples : {32u, 64u, 128u}) {
        SCOPED_TRACE(samples);
        ViewSettings settings = dcaaSettings(samples);
        settings.projection = pixelOrthographic(48, 32, 10);
        Material material;
        material.diffuse = material.specular = glm::vec4(0);
        material.emissive = glm::vec4(1);
        const float x0 = 3.3f, x1 = 20.7f, y0 = 5.45f, y1 = 17.15f;
        const Shown shown = this->render(settings, {.triangles = rectangle(x0, y0, x1, y1, 5, material)});
        for (uint32_t y = 0; y < 32; ++y)
            for (uint32_t x = 0; x < 48; ++x) {
                const auto share = [](float low, float high, uint32_t at) {
                    return std::clamp(std::min(high, float(at + 1)) - std::max(low, float(at)), 0.0f, 1.0f);
                };
                const float expected = share(x0, x1, x) * share(y0, y1, y);
                EXPECT_NEAR(shown.rgb[3 * (48 * y + x)], expected, 0.06f) << x << ", " << y;
            }
        EXPECT_NEAR(sumOf(shown.rgb) / 3, double((x1 - x0) * (y1 - y0)), 1.0);
        EXPECT_EQ(shown.geometryPasses, 1u);
        EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
    }
}

TYPED_TEST_P(DcaaCases, ShowsWhatManySamplesShow) {
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    ViewSettings settings;
    settings.config.technique = "ssaa";
    settings.config.samples = 32;
    settings.facts.shadowMapCount = 0;
    const Shown truth = this->render(settings, shot);
    settings.config.samples = 8;
    const double eight = compare(this->render(settings, shot).rgb, truth.rgb).psnr;
    for (const uint32_t surfaces : {1u, 2u, 4u, 8u}) {
        const Shown shown = this->render(dcaaSettings(64, surfaces), shot);
        const Difference d = compare(shown.rgb, truth.rgb);
        if (surfaces > 1) {
            EXPECT_GT(d.psnr, eight + 3);
        }
        EXPECT_EQ(shown.counters.lostSamples, 0u);
        std::printf("%u surfaces: PSNR %.1f dB (ssaa 8: %.1f), fragments %llu, merged %llu + %llu, discarded %llu\n",
                    surfaces, d.psnr, eight, (unsigned long long)shown.counters.fragments,
                    (unsigned long long)shown.counters.mergedFirst, (unsigned long long)shown.counters.mergedSecond,
                    (unsigned long long)shown.counters.discarded);
        EXPECT_EQ(nonFinite(shown.rgb), 0u);
    }
}

// Samples of "sgbc" keep their depths. In each order of the fragments, those show geometry that do so in lists that
// keep all fragments; where full pixels drop fragments, some do not.
TYPED_TEST_P(DcaaCases, StreamedSurfacesShowAllCoveredSamples) {
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    ViewSettings truth;
    truth.config.technique = "ssaa";
    truth.config.samples = 32;
    truth.facts.shadowMapCount = 0;
    const Shown many = this->render(truth, shot);
    truth.config.samples = 8;
    const double eight = compare(this->render(truth, shot).rgb, many.rgb).psnr;
    struct Way {
        uint64_t order;
        uint32_t surfaces;
    };
    for (const auto& [n, tier] : {std::pair{32u, AGAA_TIER_FRAGMENT_LISTS}, {128u, AGAA_TIER_MATERIAL_LISTS}}) {
        ViewSettings settings = dcaaSettings(n, 4, tier);
        settings.config.coverage.flags = AGAA_COVERAGE_EXACT;
        const uint64_t covered = this->render(settings, shot).counters.visible;
        settings.config.technique = "sgbc";
        for (const Way& way :
             {Way{0, 1}, Way{0, 4}, Way{AGAA_COVERAGE_DRAW_ORDER, 4}, Way{AGAA_COVERAGE_REVERSE_ORDER, 4}}) {
            SCOPED_TRACE(testing::Message() << n << ' ' << tier << ' ' << way.order << ' ' << way.surfaces);
            settings.config.coverage.flags = way.order;
            settings.config.aggregates = way.surfaces;
            settings.config.coverage.merge = AGAA_MERGE_VISIBLE;
            const Shown shown = this->render(settings, shot);
            EXPECT_EQ(shown.counters.visible, covered);
            EXPECT_EQ(shown.counters.lostSamples, 0u);
            EXPECT_TRUE(way.surfaces == 1 || compare(shown.rgb, many.rgb).psnr > eight + 2);
            settings.config.coverage.merge = AGAA_MERGE_PAPER;
            const AgaaCounters printed = this->render(settings, shot).counters;
            EXPECT_EQ(printed.mergedSecond, 0u);
            EXPECT_LT(printed.visible, covered);
            EXPECT_GE(printed.visible + printed.lostSamples, covered);
        }
    }
}

// Full pixels that compare colours merge other surfaces, and lose no sample either.
TYPED_TEST_P(DcaaCases, ColoursDecideWhichSurfacesMerge) {
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
        ViewSettings settings = dcaaSettings(64, 2, tier);
        const Shown byNormals = this->render(settings, shot);
        settings.config.coverage.merge = AGAA_MERGE_COLOR;
        const Shown byColours = this->render(settings, shot);
        EXPECT_NE(byColours.rgb, byNormals.rgb);
        EXPECT_EQ(byColours.counters.visible, byNormals.counters.visible);
        EXPECT_EQ(byColours.counters.lostSamples, 0u);
        // With room for all surfaces, no pixel is full.
        settings.config.aggregates = 8;
        const Shown few = this->render(settings, {.triangles = randomTriangles({.triangles = 3}, 61)});
        settings.config.coverage.merge = AGAA_MERGE_VISIBLE;
        EXPECT_EQ(this->render(settings, {.triangles = randomTriangles({.triangles = 3}, 61)}).rgb, few.rgb);
    }
}

// Lists that begin with the last draw are those of a scene that is drawn in the reverse order.
TYPED_TEST_P(DcaaCases, TheOrderOfDrawsCanBeReversed) {
    Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    for (const char* technique : {"dcaa", "sgbc"})
        for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
            SCOPED_TRACE(testing::Message() << technique << ' ' << tier);
            ViewSettings settings = dcaaSettings(64, 2, tier);
            settings.config.technique = technique;
            settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
            const Shown first = this->render(settings, shot);
            std::reverse(shot.triangles.begin(), shot.triangles.end());
            const Shown last = this->render(settings, shot);
            settings.config.coverage.flags = AGAA_COVERAGE_REVERSE_ORDER;
            EXPECT_EQ(this->render(settings, shot).rgb, first.rgb);
            EXPECT_NE(last.rgb, first.rgb);
            std::reverse(shot.triangles.begin(), shot.triangles.end());
        }
}

// Triangles of a thin layer, so that their depths overlap in many pixels.
inline std::vector<Triangle> tangle(uint32_t count) {
    std::mt19937 random(7);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    std::vector<Triangle> list;
    for (uint32_t i = 0; i < count; ++i) {
        Triangle t;
        const glm::vec2 centre(uniform(-3.4f, 3.4f), uniform(-2.2f, 2.2f));
        for (glm::vec3& corner : t.position)
            corner = {centre.x + uniform(-0.5f, 0.5f), centre.y + uniform(-0.5f, 0.5f), uniform(-4.4f, -4.0f)};
        t.material = randomMaterial(random);
        t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
        t.material.normal = glm::vec4(planeNormal(t), 0.3f);
        list.push_back(t);
    }
    return list;
}

// Strips of one depth, several in each pixel, with normals that differ.
inline std::vector<Triangle> facingStrips() {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> tilt(-0.5f, 0.5f);
    std::vector<Triangle> list;
    for (float x = 2; x < 40; x += 0.17f) {
        Material material = randomMaterial(random);
        material.normal = glm::vec4(glm::normalize(glm::vec3(tilt(random), tilt(random), 1)), 0.3f);
        for (const Triangle& t : rectangle(x, 3.4f, x + 0.17f, 28.7f, 5, material))
            list.push_back(t);
    }
    return list;
}

// Lists are sorted by depth and coverage, so that the order of the draws changes no bit. Merging in the order of the
// draws shows what the sort is for: another order shows another image.
TYPED_TEST_P(DcaaCases, HardCase67OrderOfDrawsIsFree) {
    for (const bool isFacing : {false, true}) {
        const std::vector<Triangle> triangles = isFacing ? facingStrips() : tangle(400);
        const Shot shot{.triangles = triangles, .change = addAmbient};
        const Shot reversed{.triangles = {triangles.rbegin(), triangles.rend()}, .change = addAmbient};
        for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
            SCOPED_TRACE(std::string(agaaTierName(tier)) + (isFacing ? ", facing" : ""));
            ViewSettings settings = dcaaSettings(64, 2, tier);
            if (isFacing)
                settings.projection = pixelOrthographic(48, 32, 10);
            settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
            EXPECT_NE(this->render(settings, reversed).rgb, this->render(settings, shot).rgb) << "the naive order";
            for (const uint64_t flags : {UINT64_C(0), AGAA_COVERAGE_EXACT}) {
                settings.config.coverage.flags = flags;
                const Shown one = this->render(settings, shot), other = this->render(settings, reversed);
                EXPECT_EQ(other.rgb, one.rgb) << flags;
                EXPECT_EQ(one.counters.lostSamples + other.counters.lostSamples, 0u);
            }
        }
    }
}

// Where a pixel keeps every fragment, memory has what algorithm 1 begins with. Merged by the paper's words on the CPU,
// it is what the device keeps of fewer surfaces.
TYPED_TEST_P(DcaaCases, MergesAsAlgorithm1OfThePaper) {
    Shot shot{.triangles = tangle(170)};
    std::mt19937 random(9);
    for (Triangle& t : shot.triangles) { // shading normals, which the paper's rule does not compare
        std::uniform_real_distribution<float> tilt(-0.15f, 0.15f);
        const glm::vec3 bent = glm::vec3(t.material.normal) + glm::vec3(tilt(random), tilt(random), tilt(random));
        t.material.normal = glm::vec4(glm::normalize(bent), t.material.normal.w);
    }
    for (const uint32_t samples : {64u, 32u, 128u}) {
        ViewSettings settings = dcaaSettings(samples, 8);
        settings.config.surfaceCosine = 1; // nothing merges
        const Kept fragments = this->keep(settings, shot);
        ASSERT_EQ(fragments.counters.discarded + fragments.counters.mergedFirst + fragments.counters.mergedSecond, 0u)
            << "a pixel has more than 8 fragments";
        for (const uint32_t merge : {AGAA_MERGE_VISIBLE, AGAA_MERGE_PAPER, AGAA_MERGE_NONE}) {
            SCOPED_TRACE(std::to_string(samples) + " samples, merge " + std::to_string(merge));
            if (samples != 64 && merge != AGAA_MERGE_VISIBLE)
                continue; // the width of masks and the rule are apart
            settings.config.aggregates = 2;
            settings.config.surfaceCosine = 0.9f;
            settings.config.coverage.merge = merge;
            const Kept kept = this->keep(settings, shot);
            paper::Pixel sums;
            for (size_t p = 0; p < kept.pixels.size(); ++p) {
                paper::Pixel pixel;
                pixel.store = [samples](paper::Surface& s) { storeSurface(s, samples); };
                for (const paper::Surface& fragment : fragments.pixels[p])
                    pixel.insert(fragment, rulesOf(settings, fragment, p));
                expectSame(kept.pixels[p], pixel.surfaces, p);
                sums.mergedFirst += pixel.mergedFirst;
                sums.mergedSecond += pixel.mergedSecond;
                sums.discarded += pixel.discarded;
                sums.lostSamples += pixel.lostSamples;
            }
            EXPECT_EQ(kept.counters.fragments, fragments.counters.fragments);
            EXPECT_EQ(kept.counters.mergedFirst, sums.mergedFirst);
            EXPECT_EQ(kept.counters.mergedSecond, sums.mergedSecond);
            EXPECT_EQ(kept.counters.discarded, sums.discarded);
            EXPECT_EQ(kept.counters.lostSamples, sums.lostSamples);
            EXPECT_GT(sums.mergedFirst, 10u);
            EXPECT_GT(sums.discarded, 10u);
            EXPECT_EQ(sums.mergedSecond > 10, merge != AGAA_MERGE_NONE);
            EXPECT_EQ(kept.counters.lostFragments, 0u);
            std::printf("%u samples, merge %u: %u + %u merged, %u discarded, %u samples lost\n", samples, merge,
                        sums.mergedFirst, sums.mergedSecond, sums.discarded, sums.lostSamples);
        }
    }
}

// Hard case 51: ids decide the order of the draws, so that frames repeat, and other ids show something else.
TYPED_TEST_P(DcaaCases, IdsDecideTheOrder) {
    Shot shot{.triangles = tangle(400), .change = addAmbient};
    ViewSettings settings = dcaaSettings(64, 2);
    settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
    const Shown first = this->render(settings, shot);
    EXPECT_EQ(this->render(settings, shot).rgb, first.rgb);
    std::reverse(shot.triangles.begin(), shot.triangles.end());
    const Shown reversed = this->render(settings, shot);
    EXPECT_NE(reversed.rgb, first.rgb);
    EXPECT_EQ(reversed.counters.fragments, first.counters.fragments);
}

// Hard cases 49 and 50: a floor and a wall that begin behind the eye, and slivers, in both depth conventions.
TYPED_TEST_P(DcaaCases, TrianglesThroughTheEyePlaneShowWhatSamplesShow) {
    std::mt19937 random(3);
    Shot shot{.triangles = randomTriangles({.triangles = 40}, 8), .change = addAmbient};
    for (const auto& [a, b, c] : {std::array{glm::vec3(-9, -1, 5), glm::vec3(9, -1, 5), glm::vec3(0, -1, -30)},
                                  std::array{glm::vec3(2, -4, 3), glm::vec3(2, 4, 3), glm::vec3(3, 0, -20)}}) {
        Triangle t;
        t.position[0] = a, t.position[1] = b, t.position[2] = c;
        t.material = randomMaterial(random);
        t.material.normal = glm::vec4(planeNormal(t), 0.5f);
        shot.triangles.push_back(t);
    }
    ViewSettings many;
    many.config.technique = "ssaa";
    many.config.samples = 32;
    many.facts.shadowMapCount = 0;
    const Shown truth = this->render(many, shot);
    const Shown shown = this->render(dcaaSettings(64, 8), shot);
    EXPECT_EQ(nonFinite(shown.rgb), 0u);
    const Difference d = compare(shown.rgb, truth.rgb);
    ViewSettings reversed = dcaaSettings(64, 8);
    reversed.flags = AGAA_VIEW_REVERSED_Z;
    reversed.projection = reversedInfinite(60, 1.5f, 0.1f);
    const Difference other = compare(this->render(reversed, shot).rgb, shown.rgb);
    std::printf("PSNR %.1f dB to 32 samples, %.1f dB between depth conventions\n", d.psnr, other.psnr);
    EXPECT_GT(d.psnr, isInOrder(this->context.caps()) ? 27 : 26.5) << "32 samples at places of the device's own";
    EXPECT_GT(other.psnr, 80);
}

// All fragments of these pixels find a surface of their own, so that merging does nothing.
TYPED_TEST_P(DcaaCases, ExactShowsWhatSurfacesWithoutMergingShow) {
    const Shot shot{.triangles = tangle(170), .change = addAmbient};
    for (const auto& [samples, tier] : {std::pair{32u, AGAA_TIER_FRAGMENT_LISTS},
                                        {64u, AGAA_TIER_FRAGMENT_LISTS},
                                        {128u, AGAA_TIER_FRAGMENT_LISTS},
                                        {64u, AGAA_TIER_MATERIAL_LISTS}}) {
        SCOPED_TRACE(samples);
        ViewSettings settings = dcaaSettings(samples, 8, tier);
        settings.config.surfaceCosine = 1;
        const Shown surfaces = this->render(settings, shot);
        EXPECT_EQ(surfaces.counters.discarded + surfaces.counters.mergedSecond, 0u);
        settings.config.coverage.flags = AGAA_COVERAGE_EXACT;
        const Shown exact = this->render(settings, shot);
        const Difference d = compare(exact.rgb, surfaces.rgb);
        std::printf("%u samples: PSNR %.1f dB\n", samples, d.psnr);
        EXPECT_GE(d.psnr, 70) << "slopes of 8 bits, ends of ranges within a quarter of an octave";
        EXPECT_EQ(exact.counters.fragments, surfaces.counters.fragments);
        EXPECT_EQ(exact.counters.visible, surfaces.counters.visible);
        EXPECT_NEAR(double(exact.counters.shadingEvents), double(surfaces.counters.shadingEvents),
                    0.01 * double(surfaces.counters.shadingEvents));
    }
}

// Ambient light does not reach what the view leaves out of its materials.
TYPED_TEST_P(DcaaCases, ExactLeavesOutWhatTheViewLacks) {
    Shot shot{.triangles = tangle(40), .change = addAmbient};
    for (Triangle& t : shot.triangles) {
        t.material.specular = glm::vec4(0.7f);
        t.material.emissive = glm::vec4(0.5f);
    }
    ViewSettings settings = dcaaSettings(32, 4, AGAA_TIER_FRAGMENT_LISTS);
    settings.config.coverage.flags = AGAA_COVERAGE_EXACT;
    settings.facts.flags &= ~uint64_t(AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE);
    const Shown shown = this->render(settings, shot);
    for (Triangle& t : shot.triangles)
        t.material.specular = t.material.emissive = glm::vec4(0);
    expectSameImage(shown.rgb, this->render(settings, shot).rgb, this->context.caps(), 0);
    EXPECT_GT(sumOf(shown.rgb), 0);
}

// Layers over the whole view, which is larger than a pool of the smallest size: tiles are drawn in several batches, and
// the image is the one of a pool with room for all.
TYPED_TEST_P(DcaaCases, BatchesShowWhatOneDrawShows) {
    Shot shot;
    std::mt19937 random(5);
    for (int layer = 4; layer >= 0; --layer) // the nearest last, which is lost where there is no room
        for (const Triangle& t :
             rectangle(float(10 * layer), float(7 * layer), 322, 242, float(1 + layer), randomMaterial(random)))
            shot.triangles.push_back(t);
    for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
        SCOPED_TRACE(agaaTierName(tier));
        ViewSettings settings = dcaaSettings(64, 4, tier);
        settings.width = 322;
        settings.height = 242;
        settings.projection = pixelOrthographic(322, 242, 10);
        const Shown whole = this->render(settings, shot);
        EXPECT_EQ(whole.counters.lostFragments, 0u);
        settings.config.coverage.fragmentsPerPixel = 1;
        settings.config.coverage.maxBatches = 8;
        const Shown divided = this->render(settings, shot);
        EXPECT_EQ(divided.rgb, whole.rgb);
        EXPECT_EQ(divided.counters.fragments, whole.counters.fragments);
        EXPECT_EQ(divided.counters.lostFragments, 0u);
        EXPECT_EQ(whole.counters.batches, 1u);
        EXPECT_GE(divided.counters.batches, 6u) << "one that counts, and five that each have room for a layer";
        EXPECT_LE(divided.counters.batches, 8u);
        EXPECT_GT(whole.counters.fragments, 4u * 322 * 242);
        // With too few draws fragments are lost, and counted.
        for (const uint32_t maxBatches : {3u, 1u}) {
            settings.config.coverage.maxBatches = maxBatches;
            const Shown few = this->render(settings, shot);
            EXPECT_NE(few.rgb, whole.rgb);
            EXPECT_GT(few.counters.lostFragments, 0u);
            EXPECT_EQ(few.counters.fragments, whole.counters.fragments);
        }
        // One that is enough is not followed by others.
        settings.config.coverage.fragmentsPerPixel = 8;
        settings.config.coverage.maxBatches = 8;
        const Shown enough = this->render(settings, shot);
        EXPECT_EQ(enough.rgb, whole.rgb);
        EXPECT_EQ(enough.counters.fragments, whole.counters.fragments);
        EXPECT_EQ(enough.counters.batches, 1u);
    }
}

// One tile fills a third of the pool. The other tiles need no more draws because of it.
TYPED_TEST_P(DcaaCases, OneFullTileDoesNotShrinkBatches) {
    Shot shot;
    std::mt19937 random(6);
    for (int layer = 4; layer >= 0; --layer)
        for (const Triangle& t : rectangle(0, 0, 256, 256, float(2 + layer), randomMaterial(random)))
            shot.triangles.push_back(t);
    for (int layer = 0; layer < 320; ++layer)
        for (const Triangle& t : rectangle(128, 128, 136, 136, 1 + 0.001f * float(layer), facing(glm::vec3(0.5f))))
            shot.triangles.push_back(t);
    ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_LISTS);
    settings.width = settings.height = 256;
    settings.projection = pixelOrthographic(256, 256, 10);
    settings.config.coverage.fragmentsPerPixel = 1;
    settings.config.coverage.maxBatches = 7; // a pool has room for 65,536 of the 352,000 fragments
    const Shown divided = this->render(settings, shot);
    EXPECT_GT(divided.counters.fragments, 5u * 256 * 256 + 320 * 64) << "pixels at a diagonal have two per layer";
    EXPECT_EQ(divided.counters.lostFragments, 0u);
    EXPECT_LE(divided.counters.batches, 7u);
}

REGISTER_TYPED_TEST_SUITE_P(DcaaCases, IdsDecideTheOrder, TrianglesThroughTheEyePlaneShowWhatSamplesShow,
                            ExactShowsWhatSurfacesWithoutMergingShow, ExactLeavesOutWhatTheViewLacks,
                            BatchesShowWhatOneDrawShows, OneFullTileDoesNotShrinkBatches, EdgesCoverTheirShare,
                            ShowsWhatManySamplesShow, StreamedSurfacesShowAllCoveredSamples,
                            TheOrderOfDrawsCanBeReversed, ColoursDecideWhichSurfacesMerge, MergesAsAlgorithm1OfThePaper,
                            HardCase67OrderOfDrawsIsFree);

} // namespace agaa::test
