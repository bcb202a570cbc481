// Triangles that the host's vertex shader expands, beside those that its geometry shader expands: all that frames leave
// is equal bit by bit. Each graphics API instantiates these.
#pragma once

#include "interlock_cases.h"
#include "setting_share.h"

#include "shaders/tables/layouts.inc"

#include <limits>

namespace agaa::test {

// Of each pixel, the words of its fragments but for their places in the buffer, from the last drawn on. Merging puts
// lists in order, so the others are before it where fragments do not arrive in the order of their numbers.
struct FragmentWords {
    std::vector<std::vector<uint32_t>> pixels;
    size_t count = 0; // of fragments

    FragmentWords(const Plan& plan, const std::vector<uint32_t>& buffer)
        : pixels(size_t(plan.view.width) * plan.view.height) {
        constexpr size_t countWords = AGAA_LIST_HEADS; // before the first fragments
        const size_t length = AGAA_FRAGMENT_MASK_AT + plan.view.samples / 32 + plan.payloadWords;
        for (size_t p = 0; p < pixels.size(); ++p)
            for (uint32_t at = buffer[countWords + p]; at != 0; ++count) {
                const auto record =
                    buffer.begin() + ptrdiff_t(countWords + AGAA_LIST_PIXEL_WORDS * pixels.size() + (at - 1) * length);
                pixels[p].push_back(record[0]);
                pixels[p].insert(pixels[p].end(), record + AGAA_FRAGMENT_DEPTH_AT, record + ptrdiff_t(length));
                at = record[AGAA_FRAGMENT_NEXT_AT];
            }
    }
};

template <class Host> class PullingCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }
    FragmentWords fragments(ViewSettings settings, const Shot& shot) {
        settings.config.flags |= AGAA_CONFIG_READBACK;
        settings.config.coverage.maxBatches = 1; // the lists of one draw
        return showBy<Host>(context, settings, shot, [](typename Host::View& view) {
            return FragmentWords(view.plan(), view.readBuffer("fragments"));
        });
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(PullingCases);

inline ViewSettings pulled(ViewSettings settings) {
    settings.flags |= AGAA_VIEW_VERTEX_PULLING;
    return settings;
}

// Triangles of all sizes, slivers, points, triangles that begin behind the eye, and one with a vertex that is not
// finite.
inline Shot everyTriangle() {
    Shot shot{.triangles = randomTriangles({.triangles = 150, .masked = 0.4f}, 61), .change = addAmbient};
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        Triangle t = shot.triangles[0];
        t.position[0] = a, t.position[1] = b, t.position[2] = c;
        t.seed = uint32_t(shot.triangles.size());
        shot.triangles.push_back(t);
    };
    add({-9, -1, 5}, {9, -1, 5}, {0, -1, -30});
    add({2, -4, 3}, {2, 4, 3}, {3, 0, -20});
    add({2, 4, 3}, {2, -4, 3}, {3, 0.5f, -20});
    add({-30, 1, 0}, {30, 1, 0}, {0, 1.1f, -9});
    add({-1, 0, -5}, {1, 0.1f, -5}, {0, 0.05f, -5});
    add({0.5f, 0.5f, -4}, {0.5f, 0.5f, -4}, {0.5f, 0.5f, -4});
    add({0, 0, 5}, {1, 0, 5}, {0, 1, 5});
    add({0, std::numeric_limits<float>::quiet_NaN(), -5}, {1, 0, -5}, {0, 1, -5});
    return shot;
}

TYPED_TEST_P(PullingCases, FragmentsAndSurfacesAreThoseOfGeometryShaders) {
    const Shot shot = everyTriangle();
    for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS})
        for (const uint32_t samples : {32u, 64u, 128u})
            for (const bool isReversed : {false, true}) {
                if (isReversed && samples != 64)
                    continue; // the width of masks and the near plane are apart
                if (!rendersSetting<TypeParam>(samples / 64 + isReversed + (tier == AGAA_TIER_MATERIAL_LISTS)))
                    continue;
                SCOPED_TRACE(std::string(agaaTierName(tier)) + ", " + std::to_string(samples) + " samples, reversed " +
                             std::to_string(isReversed));
                ViewSettings settings = dcaaSettings(samples, 4, tier);
                if (isReversed) {
                    settings.flags = AGAA_VIEW_REVERSED_Z;
                    settings.projection = reversedInfinite(60, 1.5f, 0.1f);
                }
                if (isInOrder(this->context.caps())) {
                    const FragmentWords expected = this->fragments(settings, shot),
                                        got = this->fragments(pulled(settings), shot);
                    EXPECT_GT(expected.count, 1000u);
                    EXPECT_EQ(got.count, expected.count);
                    EXPECT_EQ(got.pixels, expected.pixels);
                }
                const Kept kept = this->keep(settings, shot);
                EXPECT_GT(sumOf(kept.rgb), 100);
                expectSameFrame(this->keep(pulled(settings), shot), kept, this->context.caps());
            }
}

TYPED_TEST_P(PullingCases, AggregatesOfFragmentsAreThoseOfGeometryShaders) {
    const Shot shot = everyTriangle();
    ViewSettings settings;
    settings.config.technique = "agaa";
    settings.config.samples = 64;
    settings.config.generationTier = AGAA_TIER_FRAGMENTS;
    settings.facts.shadowMapCount = 0;
    const Shown expected = this->render(settings, shot), got = this->render(pulled(settings), shot);
    EXPECT_GT(sumOf(expected.rgb), 100);
    expectSameImage(got.rgb, expected.rgb, this->context.caps());
    EXPECT_EQ(got.counters.fragments, expected.counters.fragments);
    EXPECT_EQ(got.counters.primitives, expected.counters.primitives);
    EXPECT_EQ(got.counters.shadingEvents, expected.counters.shadingEvents);
    EXPECT_EQ(got.geometryPasses, 1u);
    EXPECT_TRUE(got.validation.isValid) << got.validation.explanation;
}

// A fragment has the numbers and the attributes of its own triangle in each draw, in views that are drawn several
// times.
TYPED_TEST_P(PullingCases, InstancesAndBatches) {
    ViewSettings settings = dcaaSettings(64, 2, AGAA_TIER_MATERIAL_LISTS);
    settings.instances = 3;
    settings.width = 322;
    settings.height = 242;
    settings.config.coverage.fragmentsPerPixel = 1;
    settings.config.coverage.maxBatches = 16;
    const Shot shot = everyTriangle();
    const Shown expected = this->render(settings, shot), got = this->render(pulled(settings), shot);
    EXPECT_GT(expected.counters.batches, 1u);
    EXPECT_EQ(expected.counters.lostFragments, 0u);
    EXPECT_EQ(got.counters.batches, expected.counters.batches);
    EXPECT_EQ(got.counters.fragments, expected.counters.fragments);
    EXPECT_EQ(got.rgb, expected.rgb);
}

// Merging under interlock, by shaders without its words: in order on software rasterisers.
TYPED_TEST_P(PullingCases, SurfacesOfInterlockAreThoseOfGeometryShaders) {
    if (!(this->context.caps().flags & AGAA_DEVICE_SOFTWARE))
        GTEST_SKIP() << "the device need not rasterise the fragments of a pixel in order";
    this->context.get()->caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
    const ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_FRAGMENT_INTERLOCK);
    const Shot shot = everyTriangle();
    expectSameFrame(this->keep(pulled(settings), shot), this->keep(settings, shot), this->context.caps());
}

// What hosts are told, and what devices without geometry shaders can do.
TYPED_TEST_P(PullingCases, ViewsNeedNoGeometryShaders) {
    AgaaDeviceCaps& caps = this->context.get()->caps;
    caps.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    const ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_MATERIAL_LISTS);
    const std::string refusal = expectRefused(this->context, settings, AGAA_ERROR_UNSUPPORTED, "no geometry shaders");
    EXPECT_NE(refusal.find("geometry shaders"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("AGAA_VIEW_VERTEX_PULLING"), std::string::npos) << refusal;
    const Shot shot = everyTriangle();
    const Shown got = this->render(pulled(settings), shot);
    caps.flags |= AGAA_DEVICE_GEOMETRY_SHADERS;
    EXPECT_EQ(got.rgb, this->render(settings, shot).rgb);
    for (const bool pulls : {false, true}) {
        const ViewSettings own = pulls ? pulled(settings) : settings;
        const AgaaViewDesc desc = viewDesc(own);
        AgaaView view = nullptr;
        ASSERT_EQ(this->context.createView(desc, view), AGAA_OK);
        AgaaDrawPass pass = AGAA_DRAW_PASS_INIT;
        uint32_t count = 1;
        EXPECT_EQ(agaaGetDrawPasses(view, &count, &pass), AGAA_OK);
        EXPECT_EQ(pass.glslVertex != nullptr, pulls);
        EXPECT_EQ(pass.glslGeometry != nullptr, !pulls);
        EXPECT_EQ(pass.state.vertexPulling, uint32_t(pulls));
        agaaDestroyView(view);
    }
}

REGISTER_TYPED_TEST_SUITE_P(PullingCases, FragmentsAndSurfacesAreThoseOfGeometryShaders,
                            AggregatesOfFragmentsAreThoseOfGeometryShaders, InstancesAndBatches,
                            SurfacesOfInterlockAreThoseOfGeometryShaders, ViewsNeedNoGeometryShaders);

} // namespace agaa::test
