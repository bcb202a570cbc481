// Depths, normals, coverage and custom attributes of pixels (AgaaResolvedOutputs), in every technique and tier. Each
// graphics API instantiates these.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"
#include "view_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace agaa::test {

// Diffuse albedo, normals, motion vectors, and a class that is not averaged.
inline AgaaLayout layoutWithKind() {
    AgaaLayout layout = layoutWithVelocity();
    AgaaLayoutAttribute* const end = layout.attributes + layout.attributeCount;
    layout.attributeCount = uint32_t(std::remove_if(layout.attributes, end,
                                                    [](const AgaaLayoutAttribute& a) {
                                                        return a.semantic == AGAA_SEMANTIC_SPECULAR ||
                                                               a.semantic == AGAA_SEMANTIC_ROUGHNESS ||
                                                               a.semantic == AGAA_SEMANTIC_EMISSIVE;
                                                    }) -
                                     layout.attributes);
    AgaaLayoutAttribute kind = AGAA_LAYOUT_ATTRIBUTE_INIT;
    kind.semantic = AGAA_SEMANTIC_CUSTOM;
    kind.channels = 1;
    kind.sampleBits = 8;
    kind.filter = AGAA_FILTER_NONE;
    kind.range = 255;
    kind.name = "kind";
    layout.attributes[layout.attributeCount++] = kind;
    return layout;
}

// Outputs of a view, with the host's images for them.
template <class Host> struct ResolvedBench {
    ResolvedBench(typename Host::Context& context, ViewSettings settings, const std::vector<AgaaResolvedOutput>& wanted,
                  const Shot& shot, glm::uvec2 size)
        : images(size.x, size.y, wanted.size()) {
        outputs.count = uint32_t(wanted.size());
        std::ranges::copy(wanted, outputs.outputs);
        outputs.pNext = settings.chained;
        settings.chained = &outputs;
        bench.emplace(context, settings, shot);
        bench->change = [this](typename Host::Frame& frame) { images.chain(frame); };
    }

    AgaaResolvedOutputs outputs = AGAA_RESOLVED_OUTPUTS_INIT;
    typename Host::ResolvedImages images;
    std::optional<ViewBench<Host>> bench;
};

template <class Host> class ResolvedOutputCases : public HardCaseTest<Host> {
protected:
    static constexpr float panel = 2, background = 0.0625f;
    static constexpr float panelDepth = 0.3f, groundDepth = 0.8f,
                           hiddenDepth = 0.9f; // of an orthographic view of 10 units
    static inline const AgaaLayout layout = layoutWithKind();

    static ViewSettings settingsOf(const TechniqueTier& tier, bool isReversed = false) {
        ViewSettings settings = pixelView({tier.technique, tier.n});
        const glm::uvec2 extent = extentOf(tier);
        settings.width = extent.x;
        settings.height = extent.y;
        settings.projection = pixelOrthographic(extent.x, extent.y, 10);
        if (isReversed)
            reverseDepth(settings);
        apply(tier, settings);
        settings.config.layout = &layout;
        settings.facts.flags = AGAA_FACT_AMBIENT;
        settings.facts.shadowMapCount = 0;
        settings.surface = "s.velocity = s.diffuse.xy; s.kind = s.diffuse.x > 0.9 ? 7.0 : 3.0;";
        return settings;
    }
    static glm::uvec2 extentOf(const TechniqueTier& tier) {
        return tier.isBatched ? batchedExtent : glm::uvec2(32, 16);
    }
    // A bright panel before a dark ground, which ends in the middle, over the background. Each pixel has two colours at
    // most, because the ground's edges lie between pixels.
    static Shot shot(const TechniqueTier& tier = {}) {
        const glm::vec2 extent = extentOf(tier);
        Material dark = facing({0.125f, 0.25f, 0.125f});
        dark.normal = {0.6f, 0, 0.8f, 1};
        Shot shot;
        const auto add = [&](glm::vec2 from, glm::vec2 to, float depth, const Material& material) {
            for (const Triangle& t : rectangle(from.x, from.y, to.x, to.y, 10 * depth, material))
                shot.triangles.push_back(t);
        };
        const glm::vec2 middle = {extent.x / 2, extent.y};
        for (int hidden = 0; tier.isBatched && hidden < 3; ++hidden) // fragments for more than one batch
            add({0, 0}, middle, hiddenDepth, facing({1, 0, 1}));
        add({0, 0}, middle, groundDepth, dark);
        add({4.3f, 3.4f}, extent - glm::vec2(4.4f, 3.3f), panelDepth, facing({1, 1, 1}));
        for (Triangle& t : shot.triangles)
            t.seed = uint32_t(&t - shot.triangles.data()); // some of which are not fetched, where draws are mixed
        shot.fetchFlags = tier.isMixed ? AGAA_FETCH_NOT_ALL_DRAWS : 0;
        shot.lights = {};
        shot.material = "m.velocity = m.diffuse.xy; m.kind = m.diffuse.x > 0.9 ? 7.0 : 3.0;";
        shot.change = [](AgaaFrame& frame) {
            std::ranges::fill(frame.ambient, panel);
            std::fill_n(frame.background, 3, background);
        };
        return shot;
    }
    static inline const std::vector<AgaaResolvedOutput> allOutputs = {
        {AGAA_RESOLVED_NEAREST_DEPTH, 0, nullptr}, {AGAA_RESOLVED_MEAN_DEPTH, 0, nullptr},
        {AGAA_RESOLVED_COVERAGE, 0, nullptr},      {AGAA_RESOLVED_NORMAL, 0, nullptr},
        {AGAA_RESOLVED_CUSTOM, 0, "velocity"},     {AGAA_RESOLVED_CUSTOM, 0, "kind"}};
    static constexpr size_t pixels = 32 * 16;

    // Returns the texels of the outputs of a frame, one after the other.
    static std::vector<glm::vec3> valuesOf(ResolvedBench<Host>& host) {
        host.bench->rgb();
        std::vector<glm::vec3> values;
        for (size_t i = 0; i < host.outputs.count; ++i) {
            const std::vector<glm::vec3> texels = host.images.read(i);
            values.insert(values.end(), texels.begin(), texels.end());
        }
        return values;
    }
};
TYPED_TEST_SUITE_P(ResolvedOutputCases);

// The share of the panel in a pixel follows from the image, which is linear in it.
TYPED_TEST_P(ResolvedOutputCases, ValuesAreThoseOfTheSamples) {
    using Cases = ResolvedOutputCases<TypeParam>;
    std::map<std::string, double> worst;
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        const bool isChosen = rendersSetting<TypeParam>(setting++) || tier.technique == std::string("msaa");
        if (!isChosen || tier.layout || !runs(tier, this->context.get()->caps))
            continue;
        const bool isReversed = setting % 3 == 0; // the far plane has depth 0
        const auto depthOf = [&](float depth) { return double(isReversed ? 1 - depth : depth); };
        const Shot shot = Cases::shot(tier);
        const glm::uvec2 extent = Cases::extentOf(tier);
        ResolvedBench<TypeParam> host(this->context, Cases::settingsOf(tier, isReversed), Cases::allOutputs, shot,
                                      extent);
        host.bench->setTriangles(shot.triangles);
        std::vector<float> rgb;
        for (int frame = 0; frame < 2; ++frame) // sums of the first are not those of the second
            rgb = host.bench->rgb();
        EXPECT_EQ(host.bench->view().statistics().counters.batches > 1, tier.isBatched);
        std::vector<std::vector<glm::vec3>> values;
        for (size_t i = 0; i < host.outputs.count; ++i)
            values.push_back(host.images.read(i));
        uint32_t mixed = 0;
        const float groundLight = rgb[0];
        EXPECT_NEAR(groundLight, 0.125f * Cases::panel, 0.01f);
        const auto compare = [&](const char* what, float value, double expected, double tolerance, size_t pixel) {
            const double error = std::abs(double(value) - expected);
            worst[what] = std::max(worst[what], error);
            EXPECT_LE(error, tolerance) << what << " of pixel " << pixel % extent.x << ", " << pixel / extent.x << ": "
                                        << value << " for " << expected;
        };
        for (size_t i = 0; i < size_t(extent.x) * extent.y; ++i) {
            const glm::uvec2 at = {i % extent.x, i / extent.x};
            const bool hasGround = at.x < extent.x / 2;
            // The panel's share by the places of samples, where the view tells them.
            const auto& places = host.bench->view().positions();
            if (tier.n > 1 && tier.n <= 32 && places.size() >= tier.n) {
                uint32_t inside = 0;
                for (uint32_t s = 0; s < tier.n; ++s) {
                    const glm::vec2 place = glm::vec2(at) + glm::vec2(places[s].x, places[s].y);
                    inside += place.x > 4.3f && place.y > 3.4f && place.x < float(extent.x) - 4.4f &&
                              place.y < float(extent.y) - 3.3f;
                }
                const double expected = double(inside) / tier.n;
                const double behindIt = hasGround ? expected + (1 - expected) : expected;
                compare("coverage by places", values[2][i].x, behindIt, 1e-7, i);
                compare("mean depth by places", values[1][i].x,
                        behindIt > 0 ? (expected * depthOf(Cases::panelDepth) +
                                        (hasGround ? 1 - expected : 0) * depthOf(Cases::groundDepth)) /
                                           behindIt
                                     : depthOf(1),
                        5e-7, i);
            }
            const double behind = hasGround ? double(groundLight) : double(Cases::background);
            const bool isInside = at.x >= 4 && at.x <= extent.x - 5 && at.y >= 3 && at.y <= extent.y - 4; // its centre
            const double share =
                tier.n == 1 ? double(isInside) : (double(rgb[3 * i]) - behind) / (double(Cases::panel) - behind);
            const double groundShare = hasGround ? 1 - share : 0, covered = share + groundShare;
            const bool showsPanel = share > 1e-3, showsAny = hasGround || showsPanel;
            mixed += share > 0.05 && share < 0.95;
            const double far = depthOf(1), panel = depthOf(Cases::panelDepth), ground = depthOf(Cases::groundDepth);
            compare("nearest depth", values[0][i].x, showsPanel ? panel : hasGround ? ground : far, 2e-7, i);
            compare("mean depth", values[1][i].x, showsAny ? (share * panel + groundShare * ground) / covered : far,
                    1e-6, i);
            compare("coverage", values[2][i].x, covered, 1e-7, i);
            const double total = showsAny ? covered : 1;
            compare("normal x", values[3][i].x, groundShare * 0.6 / total, 3e-5, i);
            compare("normal z", values[3][i].z, (groundShare * 0.8 + share) / total, 3e-5, i);
            compare("velocity x", values[4][i].x, (groundShare * 0.125 + share) / total, 5e-5, i);
            compare("velocity y", values[4][i].y, (groundShare * 0.25 + share) / total, 5e-5, i);
            compare("kind", values[5][i].x, showsPanel ? 7 : hasGround ? 3 : 0, 1e-6, i);
        }
        EXPECT_GE(mixed, tier.n > 1 ? 40u : 0u);
        if (testing::Test::HasFailure())
            return;
    }
    for (const auto& [what, error] : worst)
        std::printf("largest error of %s: %.2g\n", what.c_str(), error);
}

// Each value alone has the texels that it has beside others.
TYPED_TEST_P(ResolvedOutputCases, ValuesNeedNoOthers) {
    using Cases = ResolvedOutputCases<TypeParam>;
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "msaa", .n = 4},
                                      {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS},
                                      {.technique = "agaa", .n = 64, .tier = AGAA_TIER_FRAGMENTS},
                                      {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS}}) {
        SCOPED_TRACE(testing::Message() << tier);
        const Shot shot = Cases::shot();
        const auto valuesOf = [&](const std::vector<AgaaResolvedOutput>& outputs) {
            ResolvedBench<TypeParam> host(this->context, Cases::settingsOf(tier), outputs, shot, {32, 16});
            host.bench->setTriangles(shot.triangles);
            host.bench->rgb();
            std::vector<std::vector<glm::vec3>> values;
            for (size_t i = 0; i < outputs.size(); ++i)
                values.push_back(host.images.read(i));
            return values;
        };
        const std::vector<AgaaResolvedOutput>& outputs = Cases::allOutputs;
        const std::vector<std::vector<glm::vec3>> together = valuesOf(outputs);
        for (size_t i = 0; i < outputs.size(); ++i)
            EXPECT_EQ(valuesOf({outputs[i]})[0], together[i]) << "output " << i;
    }
}

// An attribute that is not averaged keeps one of its values where two materials are one surface.
TYPED_TEST_P(ResolvedOutputCases, UnfilteredValuesAreNotMixed) {
    using Cases = ResolvedOutputCases<TypeParam>;
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || tier.layout || tier.isMixed ||
            !runs(tier, this->context.get()->caps))
            continue;
        ViewSettings settings = Cases::settingsOf(tier);
        settings.config.aggregates = 1;
        const std::vector<AgaaResolvedOutput> outputs = {{AGAA_RESOLVED_CUSTOM, 0, "kind"}};
        Shot shot = Cases::shot(); // both rectangles are one plane
        shot.triangles = rectangle(0, 0, 8.4f, 16, 5, facing({0.125f, 0.25f, 0.125f}));
        for (const Triangle& t : rectangle(8.4f, 0, 32, 16, 5, facing({1, 1, 1})))
            shot.triangles.push_back(t);
        ResolvedBench<TypeParam> host(this->context, settings, outputs, shot, {32, 16});
        host.bench->setTriangles(shot.triangles);
        host.bench->rgb();
        const std::vector<glm::vec3> kinds = host.images.read(0);
        for (size_t i = 0; i < Cases::pixels; ++i) {
            const bool isEither = i % 32 == 8;
            EXPECT_TRUE(std::abs(kinds[i].x - 7) < 1e-5f || std::abs(kinds[i].x - 3) < 1e-5f) << kinds[i].x;
            EXPECT_TRUE(isEither || std::abs(kinds[i].x - (i % 32 < 8 ? 3.0f : 7.0f)) < 1e-5f) << "pixel " << i;
        }
    }
}

// A view with outputs has the image of a view without.
TYPED_TEST_P(ResolvedOutputCases, ImageStaysTheSame) {
    using Cases = ResolvedOutputCases<TypeParam>;
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || tier.layout || tier.isMixed ||
            !runs(tier, this->context.get()->caps))
            continue;
        const Shot shot = Cases::shot();
        const ViewSettings settings = Cases::settingsOf(tier);
        ViewBench<TypeParam> plain(this->context, settings, shot);
        plain.setTriangles(shot.triangles);
        ResolvedBench<TypeParam> host(this->context, settings, Cases::allOutputs, shot, {32, 16});
        host.bench->setTriangles(shot.triangles);
        EXPECT_EQ(host.bench->rgb(), plain.rgb());
    }
}

// Frames in parts, with a shading function over what the output holds, and at a place of a larger output have the
// values of others.
TYPED_TEST_P(ResolvedOutputCases, OtherFramesHaveTheSameValues) {
    using Cases = ResolvedOutputCases<TypeParam>;
    AgaaShadingFunction function = AGAA_SHADING_FUNCTION_INIT;
    function.level = AGAA_SHADING_EVENT;
    function.glsl = "vec3 agaaShade(AgaaSurface s) { return 0.5 * s.diffuse + 0.001 * s.kind; }\n";
    constexpr glm::uvec2 extent = {32, 16}, wide = {48, 40}, corner = {9, 13};
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "msaa", .n = 4},
                                      {.technique = "ssaa", .n = 8},
                                      {.technique = "agaa", .n = 8, .tier = AGAA_TIER_POST_DEPTH_ATOMICS},
                                      {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS},
                                      {.technique = "agaa", .n = 64, .tier = AGAA_TIER_FRAGMENTS},
                                      {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS}}) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!runs(tier, this->context.get()->caps))
            continue;
        const Shot shot = Cases::shot();
        ResolvedBench<TypeParam> host(this->context, Cases::settingsOf(tier), Cases::allOutputs, shot, extent);
        host.bench->setTriangles(shot.triangles);
        const std::vector<glm::vec3> values = Cases::valuesOf(host);
        host.bench->segments = {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING};
        EXPECT_EQ(Cases::valuesOf(host), values);

        ViewSettings settings = Cases::settingsOf(tier);
        settings.flags |= AGAA_VIEW_COMPOSITE;
        settings.chained = &function;
        ResolvedBench<TypeParam> shaded(this->context, settings, Cases::allOutputs, shot, extent);
        shaded.bench->setTriangles(shot.triangles);
        EXPECT_EQ(Cases::valuesOf(shaded), values);

        settings = Cases::settingsOf(tier);
        settings.width = wide.x;
        settings.height = wide.y;
        Shot placed = Cases::shot();
        placed.change = [change = placed.change, extent, corner](AgaaFrame& frame) {
            change(frame);
            frame.width = extent.x;
            frame.height = extent.y;
            frame.outputX = corner.x;
            frame.outputY = corner.y;
        };
        ResolvedBench<TypeParam> larger(this->context, settings, Cases::allOutputs, placed, wide);
        larger.bench->setTriangles(shot.triangles);
        larger.bench->rgb();
        for (size_t i = 0; i < Cases::allOutputs.size(); ++i) {
            const std::vector<glm::vec3> texels = larger.images.read(i);
            for (uint32_t y = 0; y < extent.y; ++y)
                for (uint32_t x = 0; x < extent.x; ++x)
                    ASSERT_EQ(texels[(y + corner.y) * wide.x + x + corner.x], values[(i * extent.y + y) * extent.x + x])
                        << "output " << i << " of pixel " << x << ", " << y;
        }
    }
}

REGISTER_TYPED_TEST_SUITE_P(ResolvedOutputCases, ValuesAreThoseOfTheSamples, ValuesNeedNoOthers,
                            UnfilteredValuesAreNotMixed, ImageStaysTheSame, OtherFramesHaveTheSameValues);

} // namespace agaa::test
