// The depth prepass of "dcaa" (Wang et al., I3D 2016, section 4.2). Each graphics API instantiates these.
#pragma once

#include "batch_cases.h"
#include "hard_case_test.h"

namespace agaa::test {

struct PrepassView {
    const char* name;
    ViewSettings settings;
};

// Returns views of 48 x 32 pixels, in every tier that has lists. Rectangles are in pixels.
inline std::vector<PrepassView> prepassViews() {
    ViewSettings carriedExact = exactSettings(64);
    carriedExact.config.generationTier = AGAA_TIER_MATERIAL_LISTS;
    std::vector<PrepassView> views = {{"merged", dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_LISTS)},
                                      {"carried", dcaaSettings(64, 4, AGAA_TIER_MATERIAL_LISTS)},
                                      {"exact", exactSettings(64)},
                                      {"exact, carried", carriedExact}};
    for (PrepassView& view : views)
        view.settings.projection = pixelOrthographic(48, 32, 10);
    return views;
}

inline ViewSettings withPrepass(ViewSettings settings) {
    settings.config.coverage.flags |= AGAA_COVERAGE_DEPTH_PREPASS;
    return settings;
}

inline Material glowing(float value) {
    Material material;
    material.emissive = glm::vec4(value, value, value, 0);
    return material;
}

inline void addRectangle(Shot& shot, float left, float right, float depth, const Material& material) {
    for (const Triangle& t : rectangle(left, -10, right, 42, depth, material))
        shot.triangles.push_back(t);
}

inline float redOf(const Shown& shown, uint32_t x, uint32_t y) { return shown.rgb[3 * (size_t(y) * 48 + x)]; }

// Returns one view that merges and one that does not, of which one fetches materials.
inline std::vector<PrepassView> fewPrepassViews() {
    const std::vector<PrepassView> all = prepassViews();
    return {all.front(), all.back()};
}

template <class Host> class DepthPrepassCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(DepthPrepassCases);

// Lists in the order of the draws keep every fragment, and merging evaluates the material of each.
TYPED_TEST_P(DepthPrepassCases, DropsHiddenFragments) {
    Shot shot{.lights = {}};
    for (int layer = 5; layer > 0; --layer)
        addRectangle(shot, -10, 58, float(layer), glowing(0.1f * float(layer)));
    for (const bool reversedZ : {false, true}) {
        ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_LISTS);
        settings.projection = pixelOrthographic(48, 32, 10);
        if (reversedZ)
            reverseDepth(settings);
        settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
        const Shown all = this->render(settings, shot), few = this->render(withPrepass(settings), shot);
        EXPECT_EQ(all.counters.materials, all.counters.fragments);
        EXPECT_EQ(few.counters.materials, few.counters.fragments);
        EXPECT_EQ(few.counters.fragments * 5, all.counters.fragments) << "one of five layers shows";
        EXPECT_EQ(few.rgb, all.rgb);
    }
}

// A gap of a quarter of a sample's distance, which no sample of a device sees, is lost. What stays counts as whole.
TYPED_TEST_P(DepthPrepassCases, UnseenGapsCloseWithoutALeak) {
    Shot shot{.lights = {}};
    addRectangle(shot, -10, 58, 8, glowing(0.9f));
    addRectangle(shot, -10, 20 + 30.25f / 64, 2, glowing(0.2f));
    addRectangle(shot, 20 + 30.75f / 64, 58, 2, glowing(0.2f));
    for (const auto& [name, settings] : prepassViews()) {
        SCOPED_TRACE(name);
        const Shown exact = this->render(settings, shot), shown = this->render(withPrepass(settings), shot);
        EXPECT_NEAR(redOf(exact, 20, 16), 0.2f + 0.7f / 64, 2e-3f);
        EXPECT_NEAR(redOf(shown, 20, 16), 0.2f, 1e-3f);
        EXPECT_EQ(redOf(shown, 10, 16), redOf(exact, 10, 16));
        EXPECT_EQ(shown.counters.visible, exact.counters.visible - 32) << "a sample in each row of pixels";
        EXPECT_EQ(shown.geometryPasses, 2u);
        EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
    }
}

// Next to the background nothing is dropped, and edges stay soft, also before triangles at the far plane, which are
// background. The paper's rule drops samples that show; they show the background.
TYPED_TEST_P(DepthPrepassCases, EdgesBeforeTheBackgroundAreExact) {
    Shot shot{.lights = {}};
    addRectangle(shot, -10, 58, 10, glowing(0.5f));
    addRectangle(shot, 10.3f, 20.2f, 8, glowing(0.9f));
    addRectangle(shot, 11.1f, 20.7f, 2, glowing(0.2f));
    bool isReversed = false;
    for (auto& [name, settings] : prepassViews()) {
        SCOPED_TRACE(std::string(name) + (isReversed ? ", reversed z" : ""));
        settings.config.coverage.merge = isReversed ? AGAA_MERGE_PAPER : AGAA_MERGE_VISIBLE;
        if (isReversed)
            reverseDepth(settings);
        isReversed = !isReversed;
        EXPECT_EQ(this->render(withPrepass(settings), shot).rgb, this->render(settings, shot).rgb);
    }
}

// Depth buffers round. Coplanar surfaces that face the eye are not behind their own samples, at any depth.
TYPED_TEST_P(DepthPrepassCases, RoundedDepthHidesNoSurface) {
    for (const float depth : {0.0000137f, 0.37f, 9.99f}) {
        SCOPED_TRACE(depth);
        Shot shot{.lights = {}};
        addRectangle(shot, -10, 20.3f, depth, glowing(0.2f));
        addRectangle(shot, 20.3f, 58, depth, glowing(0.9f));
        for (const auto& [name, settings] : fewPrepassViews()) {
            SCOPED_TRACE(name);
            EXPECT_EQ(this->render(withPrepass(settings), shot).rgb, this->render(settings, shot).rgb);
        }
    }
}

// Lists that have no room for all layers have room for the one that shows.
TYPED_TEST_P(DepthPrepassCases, HiddenFragmentsNeedNoBatches) {
    for (auto& [name, settings] : fewPrepassViews()) {
        SCOPED_TRACE(name);
        settings.width = settings.height = 258;
        settings.projection = pixelOrthographic(258, 258, 10);
        settings.config.coverage.fragmentsPerPixel = 1;
        Shot layers{.lights = {}};
        for (int layer = 6; layer > 0; --layer)
            layers.triangles.push_back(layerOf(258, 258, float(layer), glowing(0.1f * float(layer))));
        const Shown divided = this->render(settings, layers), whole = this->render(withPrepass(settings), layers);
        EXPECT_GT(divided.counters.batches, 5u);
        EXPECT_EQ(whole.counters.batches, 1u);
        EXPECT_EQ(whole.counters.lostFragments, 0u);
        EXPECT_EQ(whole.rgb, divided.rgb);
    }
}

// The bound holds in all draws of a frame whose lists overflow.
TYPED_TEST_P(DepthPrepassCases, BatchesKeepTheBound) {
    for (auto& [name, settings] : fewPrepassViews()) {
        SCOPED_TRACE(name);
        settings.width = settings.height = 258;
        settings.projection = pixelOrthographic(258, 258, 10);
        Shot layers{.lights = {}};
        for (int layer = 6; layer > 0; --layer)
            layers.triangles.push_back(layerOf(258, 258, 1 + 1e-7f * float(layer), glowing(0.1f * float(layer))));
        layers.triangles.push_back(layerOf(258, 258, 5, glowing(0.9f)));
        const Shown roomy = this->render(withPrepass(settings), layers);
        settings.config.coverage.fragmentsPerPixel = 1;
        const Shown divided = this->render(withPrepass(settings), layers);
        EXPECT_EQ(roomy.counters.fragments, 6u * 258 * 258) << "the last layer is behind";
        EXPECT_EQ(divided.counters.fragments, roomy.counters.fragments);
        EXPECT_GT(divided.counters.batches, 5u);
        EXPECT_EQ(divided.counters.lostFragments, 0u);
        EXPECT_EQ(divided.rgb, roomy.rgb);
    }
}

REGISTER_TYPED_TEST_SUITE_P(DepthPrepassCases, DropsHiddenFragments, UnseenGapsCloseWithoutALeak,
                            EdgesBeforeTheBackgroundAreExact, RoundedDepthHidesNoSurface, HiddenFragmentsNeedNoBatches,
                            BatchesKeepTheBound);

} // namespace agaa::test
