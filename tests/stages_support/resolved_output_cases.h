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
    static constexpr float panelDepth = 0.3f, groundDepth = 0.8f; // of an orthographic view of 10 units
    static inline const AgaaLayout layout = layoutWithKind();

    static bool resolvesSurfaces(const TechniqueTier& tier) { return tier.technique != std::string("msaa"); }

    static ViewSettings settingsOf(const TechniqueTier& tier, bool isReversed = false) {
        ViewSettings settings = pixelView({tier.technique, tier.n});
        if (isReversed)
            reverseDepth(settings);
        apply(tier, settings);
        settings.config.layout = &layout;
        settings.facts.flags = AGAA_FACT_AMBIENT;
        settings.facts.shadowMapCount = 0;
        settings.surface = "s.velocity = s.diffuse.xy; s.kind = s.diffuse.x > 0.9 ? 7.0 : 3.0;";
        return settings;
    }
    // A bright panel before a dark ground, which ends in the middle, over the background. Each pixel has two colours at
    // most, because the ground's edges lie between pixels.
    static Shot shot() {
        Material dark = facing({0.125f, 0.25f, 0.125f});
        dark.normal = {0.6f, 0, 0.8f, 1};
        Shot shot;
        shot.triangles = rectangle(0, 0, 16, 16, 10 * groundDepth, dark);
        for (const Triangle& t : rectangle(4.3f, 3.4f, 27.6f, 12.7f, 10 * panelDepth, facing({1, 1, 1})))
            shot.triangles.push_back(t);
        shot.lights = {};
        shot.material = "m.velocity = m.diffuse.xy; m.kind = m.diffuse.x > 0.9 ? 7.0 : 3.0;";
        shot.change = [](AgaaFrame& frame) {
            std::ranges::fill(frame.ambient, panel);
            std::fill_n(frame.background, 3, background);
        };
        return shot;
    }
    static std::vector<AgaaResolvedOutput> outputsOf(const TechniqueTier& tier) {
        std::vector<AgaaResolvedOutput> outputs = {{AGAA_RESOLVED_NEAREST_DEPTH, 0, nullptr},
                                                   {AGAA_RESOLVED_MEAN_DEPTH, 0, nullptr},
                                                   {AGAA_RESOLVED_COVERAGE, 0, nullptr}};
        if (resolvesSurfaces(tier))
            for (const AgaaResolvedOutput& of : {AgaaResolvedOutput{AGAA_RESOLVED_NORMAL, 0, nullptr},
                                                 AgaaResolvedOutput{AGAA_RESOLVED_CUSTOM, 0, "velocity"}})
                outputs.push_back(of);
        if (resolvesSurfaces(tier))
            outputs.push_back({AGAA_RESOLVED_CUSTOM, 0, "kind"});
        return outputs;
    }
    static constexpr size_t pixels = 32 * 16;
};
TYPED_TEST_SUITE_P(ResolvedOutputCases);

// The share of the panel in a pixel follows from the image, which is linear in it.
TYPED_TEST_P(ResolvedOutputCases, ValuesAreThoseOfTheSamples) {
    using Cases = ResolvedOutputCases<TypeParam>;
    std::map<std::string, double> worst;
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        const bool isChosen = rendersSetting<TypeParam>(setting++) || !Cases::resolvesSurfaces(tier);
        if (!isChosen || tier.isBatched || tier.isMixed || tier.layout || !runs(tier, this->context.get()->caps))
            continue;
        const bool isReversed = setting % 3 == 0; // the far plane has depth 0
        const auto depthOf = [&](float depth) { return double(isReversed ? 1 - depth : depth); };
        const Shot shot = Cases::shot();
        ResolvedBench<TypeParam> host(this->context, Cases::settingsOf(tier, isReversed), Cases::outputsOf(tier), shot,
                                      {32, 16});
        host.bench->setTriangles(shot.triangles);
        std::vector<float> rgb;
        for (int frame = 0; frame < 2; ++frame) // sums of the first are not those of the second
            rgb = host.bench->rgb();
        std::vector<std::vector<glm::vec3>> values;
        for (size_t i = 0; i < host.outputs.count; ++i)
            values.push_back(host.images.read(i));
        uint32_t mixed = 0;
        const float groundLight = rgb[0];
        EXPECT_NEAR(groundLight, 0.125f * Cases::panel, 0.01f);
        const auto compare = [&](const char* what, float value, double expected, double tolerance, size_t pixel) {
            const double error = std::abs(double(value) - expected);
            worst[what] = std::max(worst[what], error);
            EXPECT_LE(error, tolerance) << what << " of pixel " << pixel % 32 << ", " << pixel / 32 << ": " << value
                                        << " for " << expected;
        };
        for (size_t i = 0; i < Cases::pixels; ++i) {
            const bool hasGround = i % 32 < 16;
            const double behind = hasGround ? double(groundLight) : double(Cases::background);
            const bool isInside = i % 32 >= 4 && i % 32 <= 27 && i / 32 >= 3 && i / 32 <= 12; // the pixel's centre
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
            if (!Cases::resolvesSurfaces(tier))
                continue;
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
        const std::vector<AgaaResolvedOutput> outputs = Cases::outputsOf(tier);
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
        if (!rendersSetting<TypeParam>(setting++) || !Cases::resolvesSurfaces(tier) || tier.isBatched || tier.layout ||
            tier.isMixed || !runs(tier, this->context.get()->caps))
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
        ResolvedBench<TypeParam> host(this->context, settings, Cases::outputsOf(tier), shot, {32, 16});
        host.bench->setTriangles(shot.triangles);
        EXPECT_EQ(host.bench->rgb(), plain.rgb());
    }
}

REGISTER_TYPED_TEST_SUITE_P(ResolvedOutputCases, ValuesAreThoseOfTheSamples, ValuesNeedNoOthers,
                            UnfilteredValuesAreNotMixed, ImageStaysTheSame);

} // namespace agaa::test
