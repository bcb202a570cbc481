// Triangles that compute passes expand, beside those that the host's geometry shader expands: all that frames leave is
// equal bit by bit. Each graphics API instantiates these.
#pragma once

#include "batch_cases.h"
#include "pulling_cases.h"

namespace agaa::test {

template <class Host> class ComputeTrianglesCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }
    // Compares both ways and returns what compute passes show.
    Shown expectThoseOfGeometryShaders(ViewSettings settings, const Shot& shot) {
        const Shown expected = render(settings, shot);
        settings.computesTriangles = true;
        const Shown got = render(settings, shot);
        EXPECT_GT(sumOf(expected.rgb), 100);
        EXPECT_EQ(got.rgb, expected.rgb);
        EXPECT_EQ(got.counters.fragments, expected.counters.fragments);
        EXPECT_EQ(got.counters.shadingEvents, expected.counters.shadingEvents);
        EXPECT_EQ(got.counters.batches, expected.counters.batches);
        EXPECT_EQ(got.counters.lostFragments, 0u);
        EXPECT_EQ(got.counters.unannounced, 0u);
        EXPECT_EQ(got.geometryPasses, 0u);
        EXPECT_TRUE(got.validation.isValid) << got.validation.explanation;
        return got;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(ComputeTrianglesCases);

inline ViewSettings computed(ViewSettings settings) {
    settings.computesTriangles = true;
    return settings;
}

// Triangles of all sizes, of which some are masked.
inline Shot maskedTriangles() {
    Shot shot = everyTriangle();
    for (Triangle& t : shot.triangles)
        if (!t.isMasked)
            t.material.diffuse.w = 1;
    return shot;
}

// Each kind of list with a number of samples of its own, because the passes differ only in the width of masks.
TYPED_TEST_P(ComputeTrianglesCases, ImagesAreThoseOfGeometryShaders) {
    const Shot shot = maskedTriangles();
    for (const auto& [each, isReversed] : {std::pair{dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_LISTS), false},
                                           {exactSettings(32), true},
                                           {fragmentsSettings(128, 4), false},
                                           {exactSettings(128), true}}) {
        if (!rendersSetting<TypeParam>(each.config.samples / 64))
            continue;
        SCOPED_TRACE(std::string(each.config.technique) + ", " + std::to_string(each.config.samples) + " samples");
        ViewSettings settings = each;
        settings.facts.flags |= AGAA_FACT_ALPHA_MASKED;
        if (isReversed) {
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.projection = reversedInfinite(60, 1.5f, 0.1f);
        }
        this->expectThoseOfGeometryShaders(settings, shot);
    }
}

// Triangles of more pixels than a workgroup takes at once are divided into blocks; the image has an odd size.
TYPED_TEST_P(ComputeTrianglesCases, LargeTrianglesAndInstances) {
    ViewSettings settings = exactSettings(64);
    settings.width = 323;
    settings.height = 241;
    settings.instances = 3;
    this->expectThoseOfGeometryShaders(settings, Shot{.triangles = randomTriangles({.triangles = 150}, 61)});
}

// Draws in batches expand the triangles again.
TYPED_TEST_P(ComputeTrianglesCases, Batches) {
    const Shot shot{.triangles = layersOver(258, 258, 5)};
    for (auto& [name, settings] : listedViews(258, 258)) {
        if (!settings.fetches())
            continue;
        SCOPED_TRACE(name);
        EXPECT_GE(this->expectThoseOfGeometryShaders(settings, shot).counters.batches, 5u);
    }
}

// The table of half-planes gives the same samples in compute passes.
TYPED_TEST_P(ComputeTrianglesCases, SamplesOfTheHost) {
    std::vector<float> positions;
    for (uint32_t i = 0; i < 64; ++i)
        for (const double step : {0.7548776662466927, 0.5698402909980532})
            positions.push_back(float(std::fmod(0.5 + step * i, 1.0)));
    ViewSettings settings = exactSettings(64);
    settings.config.coverage.samplePositions = positions.data();
    this->expectThoseOfGeometryShaders(settings, Shot{.triangles = randomTriangles({.triangles = 150}, 61)});
}

// Triangles that turn one way are not drawn.
TYPED_TEST_P(ComputeTrianglesCases, CulledFacing) {
    const ViewSettings settings = computed(exactSettings(64));
    Shot shot{.triangles = randomTriangles({.triangles = 150}, 61)};
    const uint64_t all = this->render(settings, shot).counters.fragments;
    shot.draws = "d.culledFacing = 1;";
    const uint64_t some = this->render(settings, shot).counters.fragments;
    shot.draws = "d.culledFacing = -1;";
    const uint64_t others = this->render(settings, shot).counters.fragments;
    EXPECT_GT(some, all / 10);
    EXPECT_GT(others, all / 10);
    EXPECT_EQ(some + others, all);
}

// Primitives beyond what was announced are not drawn and are counted; nothing is read or written out of bounds.
TYPED_TEST_P(ComputeTrianglesCases, CountsBeyondTheLimits) {
    const ViewSettings settings = computed(exactSettings(64));
    Shot shot{.triangles = randomTriangles({.triangles = 150}, 61)};
    Shot few = shot;
    few.triangles.resize(70);
    const Shown expected = this->render(settings, few);
    shot.announcedTriangles = 70;
    Shown got = this->render(settings, shot);
    EXPECT_EQ(got.rgb, expected.rgb);
    EXPECT_EQ(got.counters.unannounced, 80u);
    shot.announcedTriangles = 0;
    shot.announced = 70;
    got = this->render(settings, shot);
    EXPECT_EQ(got.rgb, expected.rgb);
    EXPECT_EQ(got.counters.unannounced, 80u);
    shot.announcedTriangles = 70;
    shot.draws = "d.primitives = draw % 2u == 0u ? 0xFFFFFFFFu : 0x80000000u;";
    got = this->render(settings, shot);
    EXPECT_FALSE(got.validation.isValid);
    EXPECT_EQ(nonFinite(got.rgb), 0u);
    shot = few;
    shot.draws = "d.primitives = 0u;";
    got = this->render(settings, shot);
    EXPECT_EQ(got.counters.fragments, 0u);
    EXPECT_EQ(got.counters.unannounced, 0u);
}

// Corners that are not finite, or in one place, give no fragment and leave other triangles as they are.
TYPED_TEST_P(ComputeTrianglesCases, BadCorners) {
    const ViewSettings settings = computed(exactSettings(64));
    Shot shot{.triangles = randomTriangles({.triangles = 150}, 61)};
    Shot few = shot;
    few.triangles.resize(100);
    const Shown expected = this->render(settings, few);
    shot.corners = R"(
    if (primitive >= 100u) {
        uint kind = primitive % 6u;
        a.x = kind == 0u ? uintBitsToFloat(0x7FC00000u) : a.x;
        b.w = kind == 1u ? uintBitsToFloat(0x7F800000u) : b.w;
        c.z = kind == 2u ? uintBitsToFloat(0xFF800000u) : c.z;
        if (kind >= 3u)
            c = a;
        if (kind >= 4u)
            b = a;
        if (kind == 5u)
            a = b = c = vec4(0.0);
    })";
    const Shown got = this->render(settings, shot);
    EXPECT_EQ(got.rgb, expected.rgb);
    EXPECT_EQ(got.counters.fragments, expected.counters.fragments);
    shot.corners = R"(
    if (primitive >= 100u) {
        uint kind = primitive % 3u;
        a.xy *= kind == 0u ? 1e30 : 1.0;
        a *= kind == 1u ? 1e-38 : 1.0;
        a.w = kind == 2u ? 0.0 : a.w;
        b.w = kind == 2u ? 1e-38 : b.w;
    })";
    EXPECT_EQ(nonFinite(this->render(settings, shot).rgb), 0u);
}

// The report of a frame has what its masks demand once, however often the triangles are expanded.
TYPED_TEST_P(ComputeTrianglesCases, FactsOfMasksAreThoseOfGeometryShaders) {
    Shot shot{.triangles = layersOver(258, 258, 3)};
    for (Triangle& t : shot.triangles) {
        t.isMasked = true;
        t.material.diffuse.w = 0.6f;
    }
    ViewSettings settings = listedViews(258, 258)[1].settings;
    settings.facts.flags |= AGAA_FACT_ALPHA_MASKED;
    settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
    for (const float fragmentsPerPixel : {8.0f, 1.0f}) {
        SCOPED_TRACE(fragmentsPerPixel);
        settings.config.coverage.fragmentsPerPixel = fragmentsPerPixel;
        const Shown expected = this->render(settings, shot);
        const Shown got = this->render(computed(settings), shot);
        EXPECT_EQ(got.counters.batches > 1, fragmentsPerPixel == 1);
        EXPECT_EQ(got.facts.alphaMasked, 3u * 258 * 258);
        EXPECT_EQ(got.facts.translucent, got.facts.alphaMasked);
        EXPECT_EQ(got.facts.cutouts, 0u);
        EXPECT_EQ(expected.facts.alphaMasked, got.facts.alphaMasked);
        EXPECT_EQ(expected.facts.translucent, got.facts.translucent);
    }
}

// Views need neither geometry shaders nor a draw callback.
TYPED_TEST_P(ComputeTrianglesCases, ViewsNeedNoDraw) {
    const ViewSettings settings = exactSettings(64);
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61)};
    const Shown expected = this->render(settings, shot);
    AgaaDeviceCaps& caps = this->context.get()->caps;
    caps.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    Shot noCallback = shot;
    noCallback.change = [](AgaaFrame& frame) { frame.draw = nullptr; };
    EXPECT_EQ(this->render(computed(settings), noCallback).rgb, expected.rgb);
}

REGISTER_TYPED_TEST_SUITE_P(ComputeTrianglesCases, ImagesAreThoseOfGeometryShaders, LargeTrianglesAndInstances, Batches,
                            SamplesOfTheHost, CulledFacing, CountsBeyondTheLimits, BadCorners,
                            FactsOfMasksAreThoseOfGeometryShaders, ViewsNeedNoDraw);

} // namespace agaa::test
