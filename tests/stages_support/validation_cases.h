// agaaValidateFrame against hosts whose geometry passes are known to disagree. Rectangles on whole pixels, so that
// every figure and every pixel named is known without looking. Each graphics API instantiates these for its host, a
// type with the members Context and View.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace agaa::test {

constexpr uint32_t validatedSamples = 8;
constexpr uint32_t allSamples = (1u << validatedSamples) - 1;

struct PixelRectangle {
    uint32_t x0, y0, x1, y1;
    constexpr uint64_t pixels() const { return uint64_t(x1 - x0) * (y1 - y0); }
    constexpr bool holds(uint32_t x, uint32_t y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};
constexpr PixelRectangle first = {4, 4, 20, 20}, second = {24, 8, 40, 28}, masked = {8, 22, 16, 30};
// Triangles of these in the list.
constexpr Run ofFirst = {0, 2}, ofSecond = {2, 2}, ofAll = {0, 100};
// Half of the masked one's samples.
constexpr uint64_t maskedSamples = masked.pixels() * validatedSamples / 2;
constexpr uint64_t visibleSamples = (first.pixels() + second.pixels()) * validatedSamples + maskedSamples;

inline std::vector<Triangle> validatedScene() {
    std::vector<Triangle> list;
    const auto add = [&](const PixelRectangle& r, float depth, float alpha) {
        Material material;
        material.diffuse.w = alpha;
        for (Triangle& t : rectangle(float(r.x0), float(r.y0), float(r.x1), float(r.y1), depth, material)) {
            t.isMasked = alpha < 1;
            t.seed = 7; // samples at the common edge are of one mask
            list.push_back(t);
        }
    };
    add(first, 2, 1);
    add(second, 3, 1);
    add(masked, 4, 0.5f);
    return list;
}

// Two geometry passes, which can disagree.
struct TwoPasses {
    const char* technique;
    uint32_t generationTier;
};
constexpr TwoPasses allTwoPasses[] = {
    {"agaa", AGAA_TIER_AUTO}, {"agaa", AGAA_TIER_PER_SAMPLE}, {"msaa", AGAA_TIER_AUTO}};

inline ViewSettings validatedSettings(const Mistake& mistake = {}) {
    ViewSettings settings;
    settings.config.samples = validatedSamples;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    settings.projection = pixelOrthographic(48, 32, 10);
    settings.mistake = mistake;
    return settings;
}

inline ViewSettings validatedSettings(const TwoPasses& passes, const Mistake& mistake = {}) {
    ViewSettings settings = validatedSettings(mistake);
    settings.config.technique = passes.technique;
    settings.config.generationTier = passes.generationTier;
    return settings;
}

inline void reverseZ(ViewSettings& settings) {
    settings.flags |= AGAA_VIEW_REVERSED_Z;
    for (int column = 0; column < 4; ++column) // z becomes w - z
        settings.projection[column][2] = settings.projection[column][3] - settings.projection[column][2];
}

template <class Host>
AgaaFrameValidation validationOf(const ViewSettings& settings, const std::vector<Triangle>& scene = validatedScene()) {
    typename Host::Context context;
    typename Host::View view(context, settings);
    view.setTriangles(scene);
    const AgaaFrame frame = view.frame();
    view.render(frame);
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    EXPECT_EQ(agaaValidateFrame(view.get(), frame.frameIndex, &validation), AGAA_OK);
    EXPECT_EQ(validation.frameIndex, frame.frameIndex);
    return validation;
}

// As many pixels as there is room for, none twice, each in the rectangle and with these samples.
inline void expectPixels(const AgaaFrameValidation& v, const PixelRectangle& where, uint32_t visible,
                         uint32_t uncovered, uint32_t overlapping) {
    EXPECT_EQ(v.invalidPixels, where.pixels());
    ASSERT_EQ(v.pixelCount, uint32_t(AGAA_MAX_INVALID_PIXELS));
    std::set<std::pair<uint32_t, uint32_t>> places;
    for (const AgaaInvalidPixel& pixel : v.pixels) {
        places.emplace(pixel.x, pixel.y);
        EXPECT_TRUE(where.holds(pixel.x, pixel.y)) << pixel.x << ", " << pixel.y;
        EXPECT_EQ(pixel.visible[0], visible);
        EXPECT_EQ(pixel.uncovered[0], uncovered);
        EXPECT_EQ(pixel.overlapping[0], overlapping);
    }
    EXPECT_EQ(places.size(), size_t(AGAA_MAX_INVALID_PIXELS));
}

inline void expectExplanation(const AgaaFrameValidation& v, const char* words) {
    EXPECT_NE(std::string(v.explanation).find(words), std::string::npos) << v.explanation;
}

inline void expectInvalid(const AgaaFrameValidation& v, uint64_t visible, uint64_t uncovered, uint64_t overlapping) {
    EXPECT_EQ(v.isValid, 0u);
    EXPECT_EQ(v.visible, visible);
    EXPECT_EQ(v.uncovered, uncovered);
    EXPECT_EQ(v.once, visible - uncovered);
    EXPECT_EQ(v.overlapping, overlapping);
}

inline void expectValid(const AgaaFrameValidation& v, uint64_t visible) {
    EXPECT_EQ(v.isValid, 1u);
    EXPECT_EQ(v.visible, visible);
    EXPECT_EQ(v.once, visible);
    EXPECT_EQ(v.uncovered + v.overlapping + v.misplaced + v.unannounced + v.invalidPixels + v.pixelCount, 0u);
    const AgaaInvalidPixel nothing{};
    for (const AgaaInvalidPixel& pixel : v.pixels)
        EXPECT_EQ(std::memcmp(&pixel, &nothing, sizeof pixel), 0);
    expectExplanation(v, "exactly once");
}

template <class Host> class ValidationTest : public testing::Test {};
TYPED_TEST_SUITE_P(ValidationTest);

TYPED_TEST_P(ValidationTest, ARightFrameIsValid) {
    for (const TwoPasses& passes : allTwoPasses) {
        for (const bool reversed : {false, true}) {
            SCOPED_TRACE(passes.technique);
            ViewSettings settings = validatedSettings(passes);
            if (reversed)
                reverseZ(settings);
            const AgaaFrameValidation v = validationOf<TypeParam>(settings);
            expectValid(v, visibleSamples);
            expectExplanation(v, "in the material pass");
        }
    }
    // Frames without a second pass are not told of mistakes that only a second pass can make.
    for (const TwoPasses& onePass : {TwoPasses{"agaa", AGAA_TIER_GBUFFER}, TwoPasses{"ssaa", AGAA_TIER_AUTO}}) {
        const AgaaFrameValidation v = validationOf<TypeParam>(validatedSettings(onePass));
        expectValid(v, visibleSamples);
        expectExplanation(v, "only geometry pass");
    }
}

TYPED_TEST_P(ValidationTest, AnObjectLeftOutIsMissed) {
    for (const TwoPasses& passes : allTwoPasses) {
        SCOPED_TRACE(passes.technique);
        const AgaaFrameValidation v = validationOf<TypeParam>(validatedSettings(passes, {.materialSkips = ofSecond}));
        expectInvalid(v, visibleSamples, second.pixels() * validatedSamples, 0);
        expectPixels(v, second, allSamples, allSamples, 0);
        expectExplanation(v, "left out of the material pass");
    }
}

TYPED_TEST_P(ValidationTest, AnObjectTooManyIsMulti) {
    for (const char* technique : {"agaa", "msaa"}) {
        SCOPED_TRACE(technique);
        const AgaaFrameValidation v = validationOf<TypeParam>(
            validatedSettings({technique, AGAA_TIER_AUTO}, {.prepassSkips = ofSecond, .noDepthTest = true}));
        const uint64_t samples = second.pixels() * validatedSamples;
        expectInvalid(v, visibleSamples - samples, 0, samples);
        expectPixels(v, second, 0, 0, allSamples);
        expectExplanation(v, "objects are drawn that the prepass left out");
    }
}

TYPED_TEST_P(ValidationTest, DifferentObjectsAreBoth) {
    const AgaaFrameValidation v = validationOf<TypeParam>(
        validatedSettings({.prepassSkips = ofSecond, .materialSkips = ofFirst, .noDepthTest = true}));
    const uint64_t more = second.pixels() * validatedSamples;
    expectInvalid(v, visibleSamples - more, first.pixels() * validatedSamples, more);
    EXPECT_EQ(v.invalidPixels, first.pixels() + second.pixels());
    for (const AgaaInvalidPixel& pixel : v.pixels) {
        const bool isMissed = first.holds(pixel.x, pixel.y);
        EXPECT_NE(isMissed, second.holds(pixel.x, pixel.y));
        EXPECT_EQ(pixel.uncovered[0], isMissed ? allSamples : 0);
        EXPECT_EQ(pixel.overlapping[0], isMissed ? 0 : allSamples);
    }
    expectExplanation(v, "draw different objects");
}

// Hard case 26: positions of the material pass differ by a few units in the last place.
TYPED_TEST_P(ValidationTest, AnotherPositionIsMissed) {
    const AgaaFrameValidation v = validationOf<TypeParam>(validatedSettings({.materialDepth = 1 + 0x1p-20f}));
    expectInvalid(v, visibleSamples, visibleSamples, 0);
    EXPECT_EQ(v.invalidPixels, first.pixels() + second.pixels() + masked.pixels());
    for (const AgaaInvalidPixel& pixel : v.pixels)
        EXPECT_EQ(pixel.uncovered[0], pixel.visible[0]);
    expectExplanation(v, "positions differ in the last bit");
}

TYPED_TEST_P(ValidationTest, AnotherMaskIsMissed) {
    const AgaaFrameValidation v = validationOf<TypeParam>(validatedSettings({.materialAlpha = 0.5f}));
    expectInvalid(v, visibleSamples, maskedSamples / 2, 0);
    EXPECT_EQ(v.invalidPixels, masked.pixels());
    for (const AgaaInvalidPixel& pixel : v.pixels) {
        EXPECT_TRUE(masked.holds(pixel.x, pixel.y));
        EXPECT_NE(pixel.uncovered[0], 0u);
        EXPECT_EQ(pixel.uncovered[0] & ~pixel.visible[0], 0u);
        EXPECT_EQ(pixel.overlapping[0], 0u);
    }
    expectExplanation(v, "alpha mask");
}

// The first of duplicates at one depth is kept in either way: the others cost time, but nothing is wrong.
TYPED_TEST_P(ValidationTest, WithoutTheStencilTestDuplicatesAreTies) {
    std::vector<Triangle> scene = validatedScene();
    scene.insert(scene.end(), scene.begin(), scene.begin() + 2);
    const AgaaFrameValidation right = validationOf<TypeParam>(validatedSettings(), scene);
    expectValid(right, visibleSamples);
    EXPECT_EQ(right.ties, 0u);
    const AgaaFrameValidation without = validationOf<TypeParam>(validatedSettings({.noStencilTest = true}), scene);
    expectValid(without, visibleSamples);
    EXPECT_EQ(without.ties, first.pixels() * validatedSamples);
}

// The frame's projection has another direction of y than the one that the host draws with.
TYPED_TEST_P(ValidationTest, AnotherCameraMisplaces) {
    ViewSettings settings = validatedSettings();
    for (const char* technique : {"agaa", "ssaa"}) {
        settings.config.technique = technique;
        typename TypeParam::Context context;
        typename TypeParam::View view(context, settings);
        view.setTriangles(validatedScene());
        AgaaFrame frame = view.frame();
        frame.projection[5] = -frame.projection[5];
        view.render(frame);
        AgaaFrameValidation v = AGAA_FRAME_VALIDATION_INIT;
        ASSERT_EQ(agaaValidateFrame(view.get(), frame.frameIndex, &v), AGAA_OK);
        EXPECT_EQ(v.isValid, 0u);
        EXPECT_GT(v.misplaced, (first.pixels() + second.pixels()) / 2);
        EXPECT_EQ(v.uncovered + v.overlapping, 0u);
        expectExplanation(v, "AgaaFrame's camera");
    }
}

// Positions that are not finite are nowhere, in every technique, and no such value reaches the image.
TYPED_TEST_P(ValidationTest, HardCase64PositionsThatAreNotFiniteAreMisplaced) {
    for (const auto& [technique, samples] : {std::pair{"single", 1u},
                                             {"fxaa", 1u},
                                             {"ssaa", 4u},
                                             {"simple_complex", 4u},
                                             {"msaa", 4u},
                                             {"sbaa", 4u},
                                             {"adaptive", 4u},
                                             {"agaa", 4u}})
        for (const char* dividend : {"zero", "1.0"}) {
            SCOPED_TRACE(std::string(technique) + " " + dividend);
            ViewSettings settings = validatedSettings();
            settings.config.technique = technique;
            settings.config.samples = samples;
            const std::string surface =
                std::string("float zero = min(gl_FragCoord.x, 0.0); s.position = vec3(") + dividend + " / zero);";
            settings.surface = surface.c_str();
            typename TypeParam::Context context;
            const Shown shown = show(context, settings, {.triangles = validatedScene()});
            EXPECT_FALSE(shown.validation.isValid);
            EXPECT_GE(shown.validation.misplaced, first.pixels() + second.pixels());
            expectExplanation(shown.validation, "AgaaFrame's camera");
            EXPECT_EQ(nonFinite(shown.rgb), 0u);
        }
}

TYPED_TEST_P(ValidationTest, NothingDrawnIsInvalid) {
    const AgaaFrameValidation v =
        validationOf<TypeParam>(validatedSettings({.prepassSkips = ofAll, .materialSkips = ofAll}));
    expectInvalid(v, 0, 0, 0);
    EXPECT_EQ(v.pixelCount, 0u);
    expectExplanation(v, "Nothing is visible");
}

TYPED_TEST_P(ValidationTest, ADrawPassWithoutFragmentsIsNamed) {
    for (const TwoPasses& passes : allTwoPasses) {
        const bool isForward = std::string(passes.technique) == "msaa";
        SCOPED_TRACE(passes.technique);
        const AgaaFrameValidation v = validationOf<TypeParam>(validatedSettings(passes, {.materialSkips = ofAll}));
        expectInvalid(v, visibleSamples, visibleSamples, 0);
        expectExplanation(v, isForward ? "\"forward\" wrote none" : "\"generate aggregates\" wrote none");
        expectExplanation(v, "layout(binding)");
        const AgaaFrameValidation none =
            validationOf<TypeParam>(validatedSettings(passes, {.prepassSkips = ofAll, .materialSkips = ofAll}));
        expectExplanation(none, "\"prepass\" produced no fragment");
        expectExplanation(none, "layout(binding)");
    }
}

REGISTER_TYPED_TEST_SUITE_P(ValidationTest, ARightFrameIsValid, AnObjectLeftOutIsMissed, AnObjectTooManyIsMulti,
                            DifferentObjectsAreBoth, AnotherPositionIsMissed, AnotherMaskIsMissed,
                            WithoutTheStencilTestDuplicatesAreTies, AnotherCameraMisplaces,
                            HardCase64PositionsThatAreNotFiniteAreMisplaced, NothingDrawnIsInvalid,
                            ADrawPassWithoutFragmentsIsNamed);

} // namespace agaa::test
