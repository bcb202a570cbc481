// Fragment lists with too little room, in every tier that has lists. Each graphics API instantiates these.
#pragma once

#include "fragments_cases.h"

#include "shaders/tables/layouts.inc"

namespace agaa::test {

struct ListedView {
    const char* name;
    ViewSettings settings;
};

inline std::vector<ListedView> listedViews(uint32_t width, uint32_t height) {
    ViewSettings carriedExact = exactSettings(64);
    carriedExact.config.generationTier = AGAA_TIER_MATERIAL_LISTS;
    std::vector<ListedView> views = {{"merged", dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_LISTS)},
                                     {"exact", exactSettings(64)},
                                     {"exact, carried", carriedExact},
                                     {"fragments", fragmentsSettings(64, 4)}};
    for (ListedView& view : views) {
        view.settings.width = width;
        view.settings.height = height;
        view.settings.projection = pixelOrthographic(width, height, 10);
        view.settings.config.coverage.fragmentsPerPixel = 1;
    }
    return views;
}

// Returns a triangle that covers the view, so that each pixel has one fragment.
inline Triangle layerOf(float width, float height, float depth, const Material& material) {
    return rectangle(-2 * width, 0, 2 * width, 4 * height, depth, material)[0];
}

// Returns layers over the whole view, from back to front.
inline std::vector<Triangle> layersOver(uint32_t width, uint32_t height, int count) {
    std::mt19937 random(5);
    std::vector<Triangle> triangles;
    for (int layer = count; layer > 0; --layer)
        triangles.push_back(layerOf(float(width), float(height), float(layer), randomMaterial(random)));
    return triangles;
}

template <class Host> class BatchCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(BatchCases);

// The smallest lists have room for little more than one of five layers, of which the front one has holes.
TYPED_TEST_P(BatchCases, DefaultsLoseNothingInAnyTier) {
    Shot shot{.triangles = layersOver(258, 258, 5)};
    shot.triangles.pop_back();
    for (int i = 0; i < 5; ++i)
        for (const Triangle& t : rectangle(3.3f, 10.0f + 50 * float(i), 240, 41.7f + 50 * float(i), 1, {}))
            shot.triangles.push_back(t);
    for (auto& [name, settings] : listedViews(258, 258)) {
        SCOPED_TRACE(name);
        const Shown divided = this->render(settings, shot);
        settings.config.coverage.fragmentsPerPixel = 8;
        const Shown whole = this->render(settings, shot);
        EXPECT_EQ(whole.counters.batches, 1u);
        EXPECT_GE(divided.counters.batches, 5u);
        EXPECT_EQ(divided.counters.lostFragments, 0u);
        EXPECT_EQ(divided.counters.fragments, whole.counters.fragments);
        EXPECT_EQ(divided.counters.shadingEvents, whole.counters.shadingEvents);
        EXPECT_EQ(divided.rgb, whole.rgb);
    }
}

// With four draws, one counts and three find the nearest fragments, for which the smallest lists have room once a
// pixel.
TYPED_TEST_P(BatchCases, TooFewDrawsKeepTheNearest) {
    Shot shot{.triangles = layersOver(258, 258, 5)};
    const Shot front{.triangles = {shot.triangles.back()}};
    Shot reversed = shot;
    std::ranges::reverse(reversed.triangles);
    for (auto& [name, settings] : listedViews(258, 258)) {
        SCOPED_TRACE(name);
        settings.config.coverage.maxBatches = 4;
        const size_t lines = this->context.lines.size();
        const Shown shown = this->render(settings, shot);
        EXPECT_EQ(shown.counters.batches, 4u);
        EXPECT_EQ(shown.counters.fragments, 5u * 258 * 258);
        EXPECT_EQ(shown.counters.lostFragments, 4u * 258 * 258);
        EXPECT_EQ(shown.rgb, this->render(settings, front).rgb);
        EXPECT_EQ(shown.rgb, this->render(settings, reversed).rgb) << "the order of draws decides what is lost";
        EXPECT_EQ(this->context.lines.size(), lines) << "no frame follows that could say what was lost";
    }
}

// A tile with more fragments than the lists keeps the nearest of each pixel. The other tiles lose nothing.
TYPED_TEST_P(BatchCases, ATileWithoutRoomKeepsTheNearest) {
    Shot shot{.triangles = layersOver(64, 64, 3)};
    Shot few = shot;
    for (int i = 0; i < 1000; ++i) { // two triangles, so that pixels have two fragments
        Material material = facing(glm::vec3(0.5f));
        material.diffuse = {float(i % 7) / 7, float(i % 5) / 5, 0.5f, 1};
        for (const Triangle& t : rectangle(16, 0, 24, 8, 0.9f - 0.0005f * float(i), material)) {
            shot.triangles.push_back(t);
            if (i >= 990)
                few.triangles.push_back(t);
        }
    }
    for (auto& [name, settings] : listedViews(64, 64)) {
        SCOPED_TRACE(name);
        const Shown shown = this->render(settings, shot);
        const Shown expected = this->render(settings, few);
        EXPECT_GT(shown.counters.fragments, 65536u);
        EXPECT_EQ(shown.counters.lostFragments, shown.counters.fragments - 3u * 64 * 64 + 3 * 64 - 64 * 16);
        EXPECT_EQ(shown.rgb, expected.rgb);
    }
}

// A view that loses fragments says so once, when a later frame begins.
TYPED_TEST_P(BatchCases, LossIsLoggedOnce) {
    ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_MATERIAL_LISTS);
    settings.width = settings.height = 258;
    settings.projection = pixelOrthographic(258, 258, 10);
    settings.config.coverage.fragmentsPerPixel = 1;
    for (const uint32_t maxBatches : {1u, 4u, 0u}) {
        SCOPED_TRACE(maxBatches);
        settings.config.coverage.maxBatches = maxBatches;
        const size_t before = this->context.lines.size();
        typename TypeParam::View view(this->context, settings);
        view.setTriangles(layersOver(258, 258, 3));
        for (int i = 0; i < 3; ++i) {
            const AgaaFrame frame = view.frame();
            TypeParam::run(view, [&](typename TypeParam::Frame& native) {
                EXPECT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_OK);
            });
        }
        ASSERT_EQ(this->context.lines.size() - before, maxBatches ? 1u : 0u);
        EXPECT_TRUE(maxBatches == 0 || this->context.lines.back().text.find("fragments") != std::string::npos);
    }
}

// Tiles are divided once, before the first of many draws. Each draw takes much longer than all tests whether tiles are
// left to divide.
TYPED_TEST_P(BatchCases, TimesOfPassesLeaveOutThePassesBetween) {
    ViewSettings settings = listedViews(258, 258)[0].settings;
    settings.config.flags |= AGAA_CONFIG_TIMESTAMPS;
    const auto statistics = showBy<TypeParam>(this->context, settings, {.triangles = layersOver(258, 258, 5)},
                                              [](auto& view) { return view.statistics(); });
    EXPECT_GT(statistics.counters.batches, 2u);
    const auto timeOf = [&](const std::string& name) {
        for (uint32_t i = 0; i < statistics.passCount; ++i)
            if (statistics.passes[i].name == name) {
                EXPECT_EQ(statistics.passes[i].isTimed, 1u) << name;
                return statistics.passes[i].milliseconds;
            }
        ADD_FAILURE() << "no pass " << name;
        return 0.0;
    };
    EXPECT_LT(timeOf("divide tiles"), 0.5 * timeOf("fragments"));
}

// Returns the number of fragments that a frame appends to its lists.
template <class Host>
uint32_t listedFragments(typename Host::Context& context, ViewSettings settings, const Shot& shot) {
    settings.config.flags |= AGAA_CONFIG_READBACK;
    settings.config.coverage.fragmentsPerPixel = 8;
    settings.config.coverage.maxBatches = 1; // the count is of one draw
    return showBy<Host>(context, settings, shot,
                        [](typename Host::View& view) { return view.readBuffer("fragments")[AGAA_LIST_COUNT]; });
}

// Each of five layers covers all pixels. From front to back, the first one hides the others before they are listed.
// Case 35 compares images.
TYPED_TEST_P(BatchCases, FragmentsBehindOneThatCoversAreNotListed) {
    const uint32_t pixels = 48 * 32;
    Shot farthestFirst{.triangles = layersOver(48, 32, 5)}, nearestFirst = farthestFirst;
    std::ranges::reverse(nearestFirst.triangles);
    for (auto& [name, settings] : listedViews(48, 32)) {
        SCOPED_TRACE(name);
        EXPECT_EQ(listedFragments<TypeParam>(this->context, settings, farthestFirst), 5 * pixels);
        EXPECT_EQ(listedFragments<TypeParam>(this->context, settings, nearestFirst), pixels);
    }
    ViewSettings inDrawOrder = listedViews(48, 32)[0].settings;
    inDrawOrder.config.coverage.flags |= AGAA_COVERAGE_DRAW_ORDER;
    EXPECT_EQ(listedFragments<TypeParam>(this->context, inDrawOrder, nearestFirst), 5 * pixels);
}

REGISTER_TYPED_TEST_SUITE_P(BatchCases, FragmentsBehindOneThatCoversAreNotListed, DefaultsLoseNothingInAnyTier,
                            TooFewDrawsKeepTheNearest, ATileWithoutRoomKeepsTheNearest, LossIsLoggedOnce,
                            TimesOfPassesLeaveOutThePassesBetween);

} // namespace agaa::test
