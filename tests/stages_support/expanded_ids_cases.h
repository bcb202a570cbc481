// The tier ids whose samples compute passes find (AgaaFetchFunction::maxTriangles), beside those that the rasteriser
// finds. Each graphics API instantiates these.
#pragma once

#include "batch_cases.h"
#include "compute_triangles_cases.h"
#include "ids_cases.h"

namespace agaa::test {

template <class Host> class ExpandedIdsCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(ExpandedIdsCases);

// Rasterisers round vertices to 1/256 of a pixel, so that a sample next to an edge may change sides, and interpolate
// depth in another way, so that surfaces may intersect elsewhere.
inline void expectThoseOfTheRasteriser(const Shown& got, const Shown& expected, double leastPsnr) {
    EXPECT_EQ(expected.geometryPasses, 1u);
    EXPECT_EQ(got.geometryPasses, 0u);
    EXPECT_GT(sumOf(expected.rgb), 100);
    const Difference d = compare(got.rgb, expected.rgb);
    const double visible = double(expected.counters.visible);
    std::printf("PSNR %.1f dB, %.3f %% of pixels beyond 24/255, visible samples %.5f times\n", d.psnr,
                100 * d.farPixels, double(got.counters.visible) / visible);
    EXPECT_GE(d.psnr, leastPsnr);
    EXPECT_LE(d.farPixels, 0.01);
    EXPECT_NEAR(double(got.counters.visible), visible, 0.001 * visible);
    EXPECT_EQ(got.counters.once, got.counters.visible);
    EXPECT_NEAR(double(got.counters.shadingEvents), double(expected.counters.shadingEvents),
                0.01 * double(expected.counters.shadingEvents));
    EXPECT_EQ(got.counters.unannounced, 0u);
    EXPECT_TRUE(got.validation.isValid) << got.validation.explanation;
}

TYPED_TEST_P(ExpandedIdsCases, ImagesAreThoseOfTheRasteriser) {
    const uint64_t stored = AGAA_CONFIG_BUFFERED;
    SettingCounter<TypeParam> counter;
    for (const auto& [n, c, flags] : {std::tuple{1u, 1u, UINT64_C(0)},
                                      {4u, 2u, stored},
                                      {8u, 4u, stored},
                                      {8u, 2u, UINT64_C(0)},
                                      {16u, 2u, UINT64_C(0)},
                                      {32u, 4u, UINT64_C(0)}}) {
        if (!counter.rendersNext())
            continue;
        SCOPED_TRACE("n=" + std::to_string(n) + " c=" + std::to_string(c));
        Shot shot = idsShot();
        for (Triangle& t : shot.triangles) {
            t.isMasked = false;
            t.material.diffuse.w = 1;
        }
        ViewSettings settings = idsSettings(n, c, AGAA_TIER_IDS, flags);
        if (n == 16) {
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.projection = reversedInfinite(60, 1.5f, 0.1f);
        }
        const Shown expected = this->render(settings, shot);
        expectThoseOfTheRasteriser(this->render(computed(settings), shot), expected, 25);
    }
}

// Rounding to 1/256 of a pixel hardly moves these vertices, and surfaces of one depth do not intersect.
TYPED_TEST_P(ExpandedIdsCases, SamplesAreThoseOfTheRasteriser) {
    Shot shot{.change = addAmbient};
    std::mt19937 random(7);
    const auto place = [&](uint32_t size) { return float(random() % (64 * size)) / 64 + 1.0f / 128; };
    for (int i = 0; i < 300; ++i) {
        Triangle t = rectangle(0, 0, 1, 1, 1 + float(i % 97) / 50, randomMaterial(random))[0];
        const glm::vec2 at(place(258), place(258));
        for (glm::vec3& p : t.position)
            p = {at.x + place(i % 3 ? 12 : 90), at.y + place(i % 3 ? 12 : 90), p.z};
        shot.triangles.push_back(t);
    }
    SettingCounter<TypeParam> counter;
    for (const auto& [n, visibility] : {std::pair{4u, AGAA_TIER_AUTO},
                                        {8u, AGAA_TIER_AUTO},
                                        {32u, AGAA_TIER_AUTO},
                                        {8u, AGAA_TIER_LAYERS},
                                        {16u, AGAA_TIER_LAYERS},
                                        {32u, AGAA_TIER_LAYERS}}) {
        if (!counter.rendersNext())
            continue;
        SCOPED_TRACE(testing::Message() << n << ' ' << agaaTierName(visibility));
        ViewSettings settings = idsSettings(n, 4);
        settings.config.visibilityTier = visibility;
        settings.width = settings.height = 258;
        settings.projection = pixelOrthographic(258, 258, 10);
        const Shown expected = this->render(settings, shot);
        const Shown got = this->render(computed(settings), shot);
        expectThoseOfTheRasteriser(got, expected, 45);
        const double visible = double(expected.counters.visible);
        EXPECT_NEAR(double(got.counters.visible), visible, 1e-4 * visible);
        EXPECT_LE(compare(got.rgb, expected.rgb).farPixels, 1e-4);
    }
}

// Translucent surfaces have the masks of the rasterised tier, and reports of facts count them once.
TYPED_TEST_P(ExpandedIdsCases, MasksAreThoseOfTheRasteriser) {
    for (const auto& [alpha, visibility] :
         {std::pair{0.6f, AGAA_TIER_AUTO}, {1.0f, AGAA_TIER_AUTO}, {0.6f, AGAA_TIER_LAYERS}}) {
        SCOPED_TRACE(testing::Message() << alpha << ' ' << agaaTierName(visibility));
        Shot shot{.triangles = layersOver(258, 258, 3), .change = addAmbient};
        for (Triangle& t : shot.triangles) {
            t.isMasked = true;
            t.material.diffuse.w = alpha;
        }
        ViewSettings settings = idsSettings(8, 2);
        settings.config.visibilityTier = visibility;
        settings.width = settings.height = 258;
        settings.projection = pixelOrthographic(258, 258, 10);
        settings.facts.flags |= AGAA_FACT_ALPHA_MASKED;
        const Shown expected = this->render(settings, shot);
        const Shown got = this->render(computed(settings), shot);
        expectThoseOfTheRasteriser(got, expected, 90);
        EXPECT_EQ(got.counters.visible, expected.counters.visible);
        settings.config.flags |= AGAA_CONFIG_CHECK_FACTS;
        shot.triangles.push_back(layerOf(258, 258, 11, shot.triangles[0].material)); // beyond the far plane
        shot.triangles.back().isMasked = true;
        const Shown checked = this->render(computed(settings), shot);
        EXPECT_EQ(checked.rgb, got.rgb);
        EXPECT_EQ(checked.facts.alphaMasked, 3u * 258 * 258);
        EXPECT_EQ(checked.facts.translucent, checked.facts.alphaMasked);
    }
}

// The alpha of a cut-out falls along the card and is 0.5 on a line. It is interpolated from 4 or 16 points of the
// pixel, which is exact, or is one value for the pixel.
TYPED_TEST_P(ExpandedIdsCases, CutoutsEndWhereAlphaDoes) {
    Shot shot{.triangles = {layerOf(258, 258, 1, {})}, .change = addAmbient};
    shot.triangles[0].isMasked = true;
    ViewSettings settings = computed(idsSettings(8, 2));
    settings.width = settings.height = 258;
    settings.projection = pixelOrthographic(258, 258, 10);
    settings.facts.flags |= AGAA_FACT_ALPHA_MASKED;
    // The corners of layerOf() are known in pixels.
    const std::string whole = "vec2 place = p.at.x * vec2(-516.0, 0.0) + p.at.y * vec2(516.0, 0.0) + "
                              "p.at.z * vec2(516.0, 1032.0);\n"
                              "vec2 slope = vec2(-1.0, -0.37) / 64.0;\n"
                              "a.alpha = 0.5 + 121.3 / 64.0 + dot(slope, place);\na.alphaCutoff = 0.5;\n";
    const std::string near = whole + "a.hasAlphaNear = true;\nfor (int k = 0; k < 4; ++k)\n"
                                     "    a.alphaNear[k] = a.alpha + dot(slope, agaa_alphaPoint(uint(k)));\n";
    const std::string rows = whole + "a.hasAlphaRows = true;\nfor (int r = 0; r < 4; ++r)\n"
                                     "    for (int c = 0; c < 4; ++c)\n        a.alphaRows[r][c] = a.alpha + "
                                     "dot(slope, agaa_alphaRowPoint(uint(r), uint(c)));\n";
    // The area of the trapezium left of the line: 258 rows from 121.3 to 121.3 - 0.37 * 258 pixels.
    const double area = 258 * (121.3 - 0.37 * 129);
    for (const std::string& text : {near, rows}) {
        shot.alpha = text.c_str();
        const Shown shown = this->render(settings, shot);
        EXPECT_NEAR(double(shown.counters.visible) / 8, area, 1);
        EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
    }
    shot.alpha = whole.c_str();
    const uint64_t visible = this->render(settings, shot).counters.visible;
    EXPECT_EQ(visible % 8, 0u);
    EXPECT_NEAR(double(visible) / 8, area, 4);
}

// Triangles of more pixels than a workgroup takes at once; instances; an image of odd size.
TYPED_TEST_P(ExpandedIdsCases, LargeTrianglesAndInstances) {
    ViewSettings settings = idsSettings(8, 2);
    settings.width = 323;
    settings.height = 241;
    settings.instances = 3;
    const Shot shot{.triangles = leaningSurfaces(), .change = addAmbient};
    const Shown expected = this->render(settings, shot);
    expectThoseOfTheRasteriser(this->render(computed(settings), shot), expected, 60);
}

// Of surfaces at one depth the first one is shown, at all samples; the two triangles of a rectangle miss none.
TYPED_TEST_P(ExpandedIdsCases, TheFirstOfEqualDepthsIsShown) {
    Shot first{.triangles = rectangle(0, 0, 258, 258, 1, {}), .change = addAmbient};
    ViewSettings settings = computed(idsSettings(8, 2));
    settings.width = settings.height = 258;
    settings.projection = pixelOrthographic(258, 258, 10);
    const Shown expected = this->render(settings, first);
    EXPECT_EQ(expected.counters.visible, 8u * 258 * 258);
    Shot twice = first;
    for (Triangle t : first.triangles) {
        t.material.diffuse = glm::vec4(1, 0, 0, 1);
        twice.triangles.push_back(t);
    }
    for (int frame = 0; frame < 3; ++frame)
        EXPECT_EQ(this->render(settings, twice).rgb, expected.rgb);
}

// Surfaces through the near plane end there.
TYPED_TEST_P(ExpandedIdsCases, NearPlane) {
    Shot shot{.change = addAmbient};
    for (Triangle t : leaningSurfaces()) {
        t.position[0].z = t.position[1].z = 1; // behind the eye
        shot.triangles.push_back(t);
    }
    for (const bool isReversed : {false, true}) {
        if (!rendersSetting<TypeParam>(isReversed))
            continue;
        SCOPED_TRACE(isReversed);
        ViewSettings settings = idsSettings(8, 2);
        if (isReversed) {
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.projection = reversedInfinite(60, 1.5f, 0.1f);
        }
        const Shown expected = this->render(settings, shot);
        expectThoseOfTheRasteriser(this->render(computed(settings), shot), expected, 120);
    }
}

// Limits, and corners that cannot be drawn.
TYPED_TEST_P(ExpandedIdsCases, WrongTriangles) {
    const ViewSettings settings = computed(idsSettings(8, 2));
    Shot shot = idsShot();
    Shot few = shot;
    few.triangles.resize(70);
    const Shown expected = this->render(settings, few);
    shot.announcedTriangles = 70;
    const Shown limited = this->render(settings, shot);
    EXPECT_EQ(limited.rgb, expected.rgb);
    EXPECT_EQ(limited.counters.unannounced, 80u);
    shot.announcedTriangles = 0;
    shot.corners = R"(
    if (primitive >= 70u) {
        uint kind = primitive % 4u;
        a.x = kind == 0u ? uintBitsToFloat(0x7FC00000u) : a.x;
        b.w = kind == 1u ? uintBitsToFloat(0x7F800000u) : b.w;
        c.z = kind == 2u ? uintBitsToFloat(0xFF800000u) : c.z;
        c = kind == 3u ? a : c;
    })";
    EXPECT_EQ(this->render(settings, shot).rgb, expected.rgb);
    shot.draws = "d.primitives = draw % 2u == 0u ? 0xFFFFFFFFu : 0x80000000u;";
    const Shown many = this->render(settings, shot);
    EXPECT_FALSE(many.validation.isValid);
    EXPECT_EQ(nonFinite(many.rgb), 0u);
    shot.draws = "d.primitives = 0u;";
    const Shown none = this->render(settings, shot);
    EXPECT_EQ(none.counters.visible, 0u);
    EXPECT_EQ(none.counters.unannounced, 0u);
}

TYPED_TEST_P(ExpandedIdsCases, CulledFacingAndNoCallback) {
    const ViewSettings settings = computed(idsSettings(8, 2));
    Shot shot = idsShot();
    shot.change = [](AgaaFrame& frame) { frame.draw = nullptr; };
    uint64_t visible = 0;
    for (const char* draws : {"d.culledFacing = 1;", "d.culledFacing = -1;"}) {
        shot.draws = draws;
        const Shown some = this->render(settings, shot);
        EXPECT_GT(some.counters.visible, 1000u);
        visible += some.counters.visible;
    }
    shot.draws = "";
    const uint64_t all = this->render(settings, shot).counters.visible;
    EXPECT_LT(all, visible);
    EXPECT_GT(all, visible / 2);
}

REGISTER_TYPED_TEST_SUITE_P(ExpandedIdsCases, ImagesAreThoseOfTheRasteriser, SamplesAreThoseOfTheRasteriser,
                            MasksAreThoseOfTheRasteriser, CutoutsEndWhereAlphaDoes, LargeTrianglesAndInstances,
                            TheFirstOfEqualDepthsIsShown, NearPlane, WrongTriangles, CulledFacingAndNoCallback);

} // namespace agaa::test
