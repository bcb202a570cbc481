// "adaptive" against supersampling with the same samples, and what its options promise. Each graphics API instantiates
// these.
#pragma once

#include "hard_case_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agaa::test {

inline ViewSettings adaptiveSettings(uint32_t n, uint64_t flags = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING) {
    ViewSettings settings;
    settings.config.technique = "adaptive";
    settings.config.samples = n;
    settings.config.adaptive.flags = flags;
    settings.facts.shadowMapCount = 0;
    return settings;
}

inline Shot adaptiveShot(uint32_t seed = 61) {
    return {.triangles = randomTriangles({.triangles = 150, .duplicates = 0.1f, .masked = 0.2f}, seed),
            .change = addAmbient};
}

template <class Host> class AdaptiveCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }

    static double largestDifference(const Shown& a, const Shown& b) {
        double largest = 0;
        for (size_t i = 0; i < a.rgb.size(); ++i)
            largest =
                std::max(largest, std::abs(double(a.rgb[i]) - double(b.rgb[i])) / (1 + std::abs(double(b.rgb[i]))));
        return largest;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(AdaptiveCases);

// First samples are kept in half floats; nothing else differs.
TYPED_TEST_P(AdaptiveCases, WithoutMetricsItIsSupersampling) {
    for (size_t setting = 0; const uint32_t n : {1u, 2u, 4u, 8u, 9u, 16u, 32u}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(n);
        ViewSettings every = adaptiveSettings(n, AGAA_ADAPTIVE_DEVICE_PATTERN), ssaa = adaptiveSettings(n);
        ssaa.config.technique = "ssaa";
        const Shown full = this->render(ssaa, adaptiveShot());
        const Shown shown = this->render(every, adaptiveShot());
        EXPECT_LE(this->largestDifference(shown, full), 1e-3);
        EXPECT_EQ(shown.counters.shadingEvents, full.counters.shadingEvents);
        EXPECT_EQ(shown.counters.visible, full.counters.visible);
        EXPECT_EQ(shown.counters.shadedPixels, full.counters.shadedPixels);
        EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
    }
}

TYPED_TEST_P(AdaptiveCases, FewerSamplesComeNearAllOfThem) {
    for (size_t setting = 0; const uint32_t n : {4u, 9u, 16u}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(n);
        ViewSettings ssaa = adaptiveSettings(n);
        ssaa.config.technique = "ssaa";
        ssaa.config.visibilityTier = AGAA_TIER_ORDERED_GRID;
        const Shown full = this->render(ssaa, adaptiveShot());
        const Shown shown = this->render(adaptiveSettings(n), adaptiveShot());
        const double share = double(shown.counters.shadingEvents) / double(shown.counters.visible);
        const Difference d = compare(shown.rgb, full.rgb);
        std::printf("n=%u: %.3f of the samples, PSNR %.1f dB\n", n, share, d.psnr);
        EXPECT_LT(share, 0.8);
        EXPECT_GE(d.psnr, 80);
        uint64_t pixels = 0;
        for (const uint64_t count : shown.counters.pixelsByEvents)
            pixels += count;
        EXPECT_EQ(pixels, shown.counters.shadedPixels);
    }
}

// Each triangle has one material, so that it does not matter where it is fetched.
TYPED_TEST_P(AdaptiveCases, ByIdsItIsTheSame) {
    for (size_t setting = 0; const uint32_t n : {1u, 4u, 8u, 9u, 16u, 32u})
        for (const uint64_t flags : {uint64_t(0), AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING}) {
            if (!rendersSetting<TypeParam>(setting++ / 2 + (flags != 0)))
                continue;
            SCOPED_TRACE("n=" + std::to_string(n) + (flags ? "" : " without metrics"));
            ViewSettings ids = adaptiveSettings(n, flags), gbuffer = adaptiveSettings(n, flags);
            ids.config.generationTier = AGAA_TIER_IDS;
            const Shown drawn = this->render(gbuffer, adaptiveShot());
            const Shown fetched = this->render(ids, adaptiveShot());
            EXPECT_EQ(fetched.geometryPasses, 1u);
            EXPECT_EQ(fetched.counters.visible, drawn.counters.visible);
            EXPECT_EQ(fetched.counters.shadedPixels, drawn.counters.shadedPixels);
            EXPECT_GE(compare(fetched.rgb, drawn.rgb).psnr, 60);
            EXPECT_GE(fetched.counters.materials, fetched.counters.shadingEvents);
            EXPECT_EQ(drawn.counters.materials, 0u);
            EXPECT_TRUE(fetched.validation.isValid) << fetched.validation.explanation;
        }
}

// The ways of section 4.2 to shade unequal numbers of samples.
TYPED_TEST_P(AdaptiveCases, WaysToShadeGiveOneImage) {
    const Shown plain = this->render(adaptiveSettings(9), adaptiveShot());
    constexpr uint64_t both = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING;
    for (const uint64_t flags : {AGAA_ADAPTIVE_LOOP, AGAA_ADAPTIVE_SORTED, AGAA_ADAPTIVE_LOOP | AGAA_ADAPTIVE_SORTED}) {
        const Shown shown = this->render(adaptiveSettings(9, both | flags), adaptiveShot());
        EXPECT_LE(this->largestDifference(shown, plain), 1e-6) << flags;
        EXPECT_EQ(shown.counters.shadingEvents, plain.counters.shadingEvents) << flags;
    }
    const Shown buckets = this->render(adaptiveSettings(9, both | AGAA_ADAPTIVE_BUCKETS), adaptiveShot());
    EXPECT_GT(buckets.counters.shadingEvents, plain.counters.shadingEvents);
    const Shown tiles = this->render(adaptiveSettings(9, both | AGAA_ADAPTIVE_TILE_MAXIMUM), adaptiveShot());
    EXPECT_GT(tiles.counters.shadingEvents, buckets.counters.shadingEvents);
    const Shown sortedTiles =
        this->render(adaptiveSettings(9, both | AGAA_ADAPTIVE_TILE_MAXIMUM | AGAA_ADAPTIVE_SORTED), adaptiveShot());
    EXPECT_LE(this->largestDifference(sortedTiles, tiles), 1e-6);
    EXPECT_EQ(sortedTiles.counters.shadingEvents, tiles.counters.shadingEvents);
}

// Hard case 15: one plane, seen nearly edge on, at any distance. The printed metric takes its depths for differences.
TYPED_TEST_P(AdaptiveCases, HardCase15OnePlaneIsShadedOnce) {
    for (const float distance : {1.0f, 10.0f, 80.0f})
        for (const uint64_t flags : {uint64_t(0), AGAA_ADAPTIVE_PRINTED_METRIC}) {
            std::vector<Triangle> wall = rectangle(-200, -200, 200, 200, 0, facing({0.5f, 0.5f, 0.5f}));
            const glm::vec3 normal = glm::normalize(glm::vec3(0, 1, 0.1f));
            for (Triangle& t : wall) {
                t.material.normal = glm::vec4(normal, 1);
                for (glm::vec3& corner : t.position)
                    corner = {corner.x, corner.y * 0.1f - 0.1f * distance, -corner.y - distance};
            }
            const Shown shown = this->render(adaptiveSettings(9, AGAA_ADAPTIVE_GEOMETRY | flags), {.triangles = wall});
            EXPECT_GT(shown.counters.shadedPixels, 48u * 32u / 4u) << distance;
            if (!flags) {
                EXPECT_EQ(shown.counters.shadingEvents, shown.counters.shadedPixels) << distance;
            } else if (distance == 1.0f) {
                EXPECT_GT(shown.counters.shadingEvents, shown.counters.shadedPixels);
            }
        }
}

// Samples of the background count as others, so that the edge of a plane is shaded more often. Without a background
// nothing changes.
TYPED_TEST_P(AdaptiveCases, TheBackgroundCountsIfItIsAsked) {
    constexpr uint64_t printed = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_PRINTED_METRIC;
    for (const bool coversAll : {false, true}) {
        const float edge = coversAll ? -1.0f : 10.4f;
        const Shot shot{.triangles = rectangle(edge, edge, 60, 60, 8, facing({0.5f, 0.5f, 0.5f}))};
        const auto shown = [&](uint64_t flags) {
            ViewSettings settings = adaptiveSettings(9, flags);
            settings.projection = pixelOrthographic(48, 32, 10);
            return this->render(settings, shot);
        };
        const Shown without = shown(printed), with = shown(printed | AGAA_ADAPTIVE_BACKGROUND);
        EXPECT_EQ(without.counters.shadingEvents, without.counters.shadedPixels);
        EXPECT_EQ(with.counters.shadingEvents > without.counters.shadingEvents, !coversAll);
        EXPECT_EQ(with.counters.shadedPixels, without.counters.shadedPixels);
        if (coversAll) {
            EXPECT_EQ(with.rgb, without.rgb);
        }
    }
}

// A lamp near a plane lights the samples of a pixel differently. A light that is far away does not, and changes
// nothing.
TYPED_TEST_P(AdaptiveCases, SamplesDifferByLightIfItIsAsked) {
    const std::vector<Triangle> wall = rectangle(0, 0, 48, 32, 8, facing({0.5f, 0.5f, 0.5f}));
    AgaaLight lamp = AGAA_LIGHT_INIT;
    lamp.type = AGAA_LIGHT_POINT;
    lamp.position[0] = 20.5f;
    lamp.position[1] = 11.5f;
    lamp.position[2] = -7.5f; // half a pixel in front of the wall
    lamp.color[0] = lamp.color[1] = lamp.color[2] = 4;
    lamp.range = 8;
    AgaaLight sun = AGAA_LIGHT_INIT;
    sun.type = AGAA_LIGHT_DIRECTIONAL;
    sun.direction[2] = -1;
    for (const AgaaTier tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
        for (const bool isNear : {true, false})
            for (const uint32_t maxLights : {1u, 16u}) { // with 16, lights are culled
                const auto shown = [&](uint64_t flags) {
                    ViewSettings settings = adaptiveSettings(9, AGAA_ADAPTIVE_GEOMETRY | flags);
                    settings.config.generationTier = tier;
                    settings.facts.maxLights = maxLights;
                    settings.projection = pixelOrthographic(48, 32, 10);
                    return this->render(settings, {.triangles = wall, .lights = {isNear ? lamp : sun}});
                };
                const Shown without = shown(0), with = shown(AGAA_ADAPTIVE_LIGHTS);
                EXPECT_EQ(without.counters.shadingEvents, without.counters.shadedPixels);
                EXPECT_EQ(with.counters.shadedPixels, without.counters.shadedPixels);
                if (isNear) {
                    EXPECT_GT(with.counters.shadingEvents, without.counters.shadingEvents + 8);
                    EXPECT_LT(with.counters.shadingEvents, 2 * without.counters.shadingEvents);
                } else {
                    EXPECT_EQ(with.rgb, without.rgb);
                    EXPECT_EQ(with.counters.shadingEvents, without.counters.shadingEvents);
                }
            }
}

// Columns of half a pixel are glossy and turned by 4 degrees, which is below the threshold of normals. Only one half of
// them reflects the sun.
TYPED_TEST_P(AdaptiveCases, SamplesDifferByHighlights) {
    constexpr uint64_t lights = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_LIGHTS;
    std::vector<Triangle> panel;
    for (int column = 0; column < 2 * 48; ++column) {
        Material m = facing({0.2f, 0.2f, 0.2f});
        m.specular = glm::vec4(0.5f);
        const float turn = column % 2 ? 0.07f : 0;
        m.normal = glm::vec4(std::sin(turn), 0, std::cos(turn), 4e-4f);
        for (const Triangle& t : rectangle(float(column) / 2, 0, float(column + 1) / 2, 32, 8, m))
            panel.push_back(t);
    }
    AgaaLight sun = AGAA_LIGHT_INIT;
    sun.type = AGAA_LIGHT_DIRECTIONAL;
    sun.direction[2] = -1;
    const auto shown = [&](uint32_t n, uint64_t flags, float memory = 0, float target = 0) {
        ViewSettings settings = adaptiveSettings(n, flags);
        settings.config.adaptive.glossWeight = 0;
        settings.config.adaptive.countMemory = memory;
        settings.config.adaptive.targetEvents = target;
        settings.projection = pixelOrthographic(48, 32, 10);
        return this->render(settings, {.triangles = panel, .lights = {sun}});
    };
    for (const uint32_t n : {4u, 9u, 16u}) {
        const Shown without = shown(n, AGAA_ADAPTIVE_GEOMETRY), with = shown(n, lights);
        EXPECT_EQ(without.counters.shadingEvents, without.counters.shadedPixels) << n;
        EXPECT_EQ(with.counters.shadingEvents, 2 * with.counters.shadedPixels) << n;
        // The light of samples follows other words of the buffer.
        for (const Shown& other :
             {shown(n, lights | AGAA_ADAPTIVE_SORTED), shown(n, lights, 0.5f), shown(n, lights, 0, 2)}) {
            EXPECT_EQ(other.counters.shadingEvents, with.counters.shadingEvents) << n;
            EXPECT_LE(this->largestDifference(other, with), 1e-6) << n;
        }
    }
}

// Hard case 43: one pixel brighter than all that is displayed raises the numbers of at most five. Columns of a third of
// a pixel differ by less than the threshold, so that there is something for the lights to show differently.
TYPED_TEST_P(AdaptiveCases, HardCase43ABrightPixelStaysAlone) {
    for (const uint64_t flags : {AGAA_ADAPTIVE_SHADING | AGAA_ADAPTIVE_PRINTED_METRIC, AGAA_ADAPTIVE_SHADING}) {
        std::vector<Triangle> scene;
        for (int column = 0; column < 3 * 48; ++column)
            for (const Triangle& t : rectangle(float(column) / 3, 0, float(column + 1) / 3, 32, 8,
                                               facing(glm::vec3(column % 3 == 1 ? 0.5f : 0.54f))))
                scene.push_back(t);
        ViewSettings settings = adaptiveSettings(9, flags);
        settings.projection = pixelOrthographic(48, 32, 10);
        const auto raised = [&](const std::vector<Triangle>& triangles) {
            const Shown shown = this->render(settings, {.triangles = triangles});
            EXPECT_EQ(shown.counters.shadedPixels, 48u * 32u);
            EXPECT_EQ(nonFinite(shown.rgb), 0u);
            return shown.counters.shadedPixels - shown.counters.pixelsByEvents[0];
        };
        EXPECT_EQ(raised(scene), 0u) << flags;
        Material glow = facing({1, 1, 1});
        glow.emissive = glm::vec4(1e30f, 1e30f, 1e30f, 1);
        for (const Triangle& t : rectangle(20, 10, 21, 11, 4, glow))
            scene.push_back(t);
        // All samples of the bright pixel are alike, which the printed metric does not know.
        EXPECT_EQ(raised(scene), flags & AGAA_ADAPTIVE_PRINTED_METRIC ? 5u : 4u) << flags;
    }
}

// Red beside blue emission of equal luma, in columns of a third of a pixel.
inline std::vector<Triangle> columnsOfEqualLuma(float width) {
    std::vector<Triangle> panel;
    for (int column = 0; float(column) * width < 48; ++column) {
        Material m = facing({0, 0, 0});
        m.emissive = column % 2 ? glm::vec4(0, 0, 0.2126f / 0.0722f, 0) : glm::vec4(1, 0, 0, 0);
        m.diffuse = glm::vec4(glm::vec3(column % 3 == 1 ? 0.5f : 0.54f), 1);
        for (const Triangle& t : rectangle(float(column) * width, 0, float(column + 1) * width, 32, 8, m))
            panel.push_back(t);
    }
    return panel;
}

// Colours differ by their channels, whatever luma says: in the choice of samples, and between neighbouring pixels.
TYPED_TEST_P(AdaptiveCases, HardCase62ColorsOfEqualLumaDiffer) {
    const auto moreThanOnePerPixel = [&](ViewSettings settings, const std::vector<Triangle>& panel) {
        settings.projection = pixelOrthographic(48, 32, 10);
        const Shown shown = this->render(settings, {.triangles = panel, .lights = {}});
        EXPECT_EQ(shown.counters.shadedPixels, 48u * 32u);
        return shown.counters.shadedPixels - shown.counters.pixelsByEvents[0];
    };
    ViewSettings classified = adaptiveSettings(8);
    classified.config.technique = "simple_complex";
    EXPECT_EQ(moreThanOnePerPixel(classified, columnsOfEqualLuma(1.0f / 3)), 48u * 32u);
    EXPECT_EQ(moreThanOnePerPixel(adaptiveSettings(9, AGAA_ADAPTIVE_GEOMETRY), columnsOfEqualLuma(1.0f / 3)),
              48u * 32u);
    // Each pixel has one colour, and columns of little difference for the neighbours to demand.
    std::vector<Triangle> stripes;
    for (const Triangle& t : columnsOfEqualLuma(1.0f / 3)) {
        const int pixel = int((t.position[0].x + t.position[1].x + t.position[2].x) / 3);
        stripes.push_back(t);
        stripes.back().material.emissive = pixel % 2 ? glm::vec4(0, 0, 0.2126f / 0.0722f, 0) : glm::vec4(1, 0, 0, 0);
    }
    EXPECT_EQ(moreThanOnePerPixel(adaptiveSettings(9, AGAA_ADAPTIVE_SHADING), stripes), 48u * 32u);
}

// Each frame keeps its target whatever came before: a step has no transient, and a still image does not change.
TYPED_TEST_P(AdaptiveCases, TargetsAreKeptAndUsed) {
    for (const uint64_t metrics : {AGAA_ADAPTIVE_GEOMETRY, AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING})
        for (const uint32_t seed : {61u, 7u}) {
            if (!rendersSetting<TypeParam>(metrics != AGAA_ADAPTIVE_GEOMETRY))
                continue; // seeds share their shaders
            double before = 0, demand = 0;
            for (const float target : {32.0f, 0.5f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f}) {
                ViewSettings settings = adaptiveSettings(9, metrics);
                settings.config.adaptive.targetEvents = target;
                const Shown shown = this->render(settings, adaptiveShot(seed));
                const double events = double(shown.counters.shadingEvents) / double(shown.counters.shadedPixels);
                if (target == 32.0f) { // as many as differ by a sixteenth of the thresholds
                    demand = events;
                    continue;
                }
                EXPECT_LE(events, std::max(target, 1.0f)) << seed;
                EXPECT_GE(events, before);
                if (metrics == AGAA_ADAPTIVE_GEOMETRY) {
                    EXPECT_GE(events, std::min(double(std::max(target, 1.0f)), demand) * 0.85) << target;
                }
                before = events;
            }
            std::printf("seed %u: %.2f events per pixel are demanded, %.2f are the most that a target gave\n", seed,
                        demand, before);
            ViewSettings settings = adaptiveSettings(9, metrics);
            settings.config.adaptive.targetEvents = 1.5f;
            const Shown first = this->render(settings, adaptiveShot(seed)),
                        second = this->render(settings, adaptiveShot(seed));
            EXPECT_EQ(this->largestDifference(first, second), 0);
        }
}

// The paper's method at once: numbers by its metric, the first samples in order, their mean.
TYPED_TEST_P(AdaptiveCases, ThePapersMethodIsAMeanOfSamples) {
    constexpr uint64_t paper = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING | AGAA_ADAPTIVE_PRINTED_METRIC |
                               AGAA_ADAPTIVE_IN_ORDER | AGAA_ADAPTIVE_EQUAL_WEIGHTS | AGAA_ADAPTIVE_LOOP;
    ViewSettings ssaa = adaptiveSettings(9);
    ssaa.config.technique = "ssaa";
    const Shown full = this->render(ssaa, adaptiveShot());
    ViewSettings settings = adaptiveSettings(9, paper);
    const Shown usual = this->render(settings, adaptiveShot());
    EXPECT_LT(usual.counters.shadingEvents, full.counters.shadingEvents);
    EXPECT_GE(compare(usual.rgb, full.rgb).psnr, 25);
    settings.config.adaptive.normalScale = settings.config.adaptive.shadingScale =
        1e6f; // all samples of pixels with edges
    settings.config.adaptive.depthScale = 1e12f;
    settings.config.adaptive.shadingThreshold = settings.config.adaptive.shadingMinimum = 0;
    EXPECT_GE(compare(this->render(settings, adaptiveShot()).rgb, full.rgb).psnr, 45);
}

TYPED_TEST_P(AdaptiveCases, ExtremeScalesStayFinite) {
    for (const float scale : {0.0f, 1e6f})
        for (const uint64_t printed : {uint64_t(0), AGAA_ADAPTIVE_PRINTED_METRIC}) {
            ViewSettings settings = adaptiveSettings(16, AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING | printed);
            settings.config.adaptive.depthScale = scale * 1e6f;
            settings.config.adaptive.normalScale = settings.config.adaptive.shadingScale = scale;
            settings.config.adaptive.shadingThreshold = settings.config.adaptive.shadingMinimum = 0;
            const Shown shown = this->render(settings, adaptiveShot());
            for (const float value : shown.rgb)
                ASSERT_TRUE(std::isfinite(value));
            EXPECT_LE(shown.counters.shadingEvents, shown.counters.visible);
            EXPECT_GE(shown.counters.shadingEvents, shown.counters.shadedPixels);
        }
}

TYPED_TEST_P(AdaptiveCases, EventsAreShownWhateverTheOptions) {
    constexpr uint64_t both = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING;
    for (const uint64_t flags :
         {uint64_t(0), AGAA_ADAPTIVE_SHADING, both | AGAA_ADAPTIVE_PRINTED_METRIC, both | AGAA_ADAPTIVE_SORTED,
          both | AGAA_ADAPTIVE_TILE_MAXIMUM, both | AGAA_ADAPTIVE_BUCKETS | AGAA_ADAPTIVE_LOOP}) {
        ViewSettings settings = adaptiveSettings(9, flags);
        settings.config.measurement.debugView = AGAA_DEBUG_VIEW_EVENTS;
        const Shown shown = this->render(settings, adaptiveShot());
        double sum = 0;
        for (size_t i = 0; i < shown.rgb.size(); i += 3)
            sum += double(shown.rgb[i]);
        EXPECT_EQ(sum, double(shown.counters.shadingEvents)) << flags;
        EXPECT_GT(sum, 0);
    }
}

// Renders a busy scene, then one plane in five frames. Returns the counters of each frame. calm: receives the first
// image of the plane.
template <class Host>
std::vector<AgaaCounters> countersAfterBusyScene(typename Host::Context& context, const ViewSettings& settings,
                                                 std::vector<float>& calm) {
    const Shot busy = adaptiveShot();
    return showBy<Host>(context, settings, busy, [&](typename Host::View& view) {
        std::vector<AgaaCounters> counters = {view.statistics().counters};
        view.setTriangles(rectangle(-100, -100, 100, 100, 5, facing({0.5f, 0.4f, 0.3f})));
        for (int i = 0; i < 5; ++i) {
            AgaaFrame frame = view.frame();
            frame.lights = busy.lights.data();
            frame.lightCount = uint32_t(busy.lights.size());
            busy.change(frame);
            Host::run(view, [&](typename Host::Frame& native) {
                EXPECT_EQ(Host::recordFrame(view.get(), &frame, &native), AGAA_OK);
            });
            counters.push_back(view.statistics().counters);
            if (i == 0)
                calm = withoutAlpha(Host::rgba(view));
        }
        return counters;
    });
}

// With a memory of a half, numbers of samples fall to one within four frames, whichever metric demanded them, and no
// colour of an earlier frame is visible.
TYPED_TEST_P(AdaptiveCases, RememberedNumbersDecay) {
    constexpr uint64_t both = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING;
    for (const uint64_t metrics : {both, uint64_t(AGAA_ADAPTIVE_SHADING)}) {
        SCOPED_TRACE(metrics);
        std::vector<float> images[2];
        for (const bool remembers : {false, true}) {
            ViewSettings settings = adaptiveSettings(9, metrics);
            settings.config.adaptive.countMemory = remembers ? 0.5f : 0.0f;
            const std::vector<AgaaCounters> frames =
                countersAfterBusyScene<TypeParam>(this->context, settings, images[remembers]);
            const AgaaCounters& busy = frames[0];
            EXPECT_GT(double(busy.shadingEvents), 1.3 * double(busy.shadedPixels));
            const auto further = [&](size_t i) { return frames[i].shadingEvents - frames[i].shadedPixels; };
            for (size_t i = 2; i < frames.size(); ++i)
                EXPECT_LE(further(i), further(i - 1));
            EXPECT_EQ(further(remembers ? 4 : 1), 0u);
            if (remembers) { // a pixel with k samples keeps the mean of k and 1, rounded down to a half of k or up
                EXPECT_GE(2 * further(1) + 2 * busy.shadedPixels, busy.shadingEvents + busy.pixelsByEvents[0]);
                EXPECT_LE(2 * further(1) + busy.shadedPixels, busy.shadingEvents);
                EXPECT_GT(further(1), further(2));
                EXPECT_GT(further(2), 0u);
            }
        }
        for (size_t i = 0; i < images[0].size(); ++i)
            ASSERT_NEAR(images[1][i], images[0][i], 1e-3f) << i;
    }
}

REGISTER_TYPED_TEST_SUITE_P(AdaptiveCases, WithoutMetricsItIsSupersampling, FewerSamplesComeNearAllOfThem,
                            ByIdsItIsTheSame, WaysToShadeGiveOneImage, HardCase15OnePlaneIsShadedOnce,
                            HardCase43ABrightPixelStaysAlone, TheBackgroundCountsIfItIsAsked,
                            SamplesDifferByLightIfItIsAsked, SamplesDifferByHighlights,
                            HardCase62ColorsOfEqualLumaDiffer, TargetsAreKeptAndUsed, ThePapersMethodIsAMeanOfSamples,
                            ExtremeScalesStayFinite, EventsAreShownWhateverTheOptions, RememberedNumbersDecay);

} // namespace agaa::test
