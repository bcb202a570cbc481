// Containment: bad values of every attribute in every technique and tier. A view shows a grid of pixels, each with one
// fragment of one bad value before a ground, and is compared with the same view of good values, and of the values by
// which the SDK replaces bad ones. Each graphics API instantiates these.
#pragma once

#include "containment.h"
#include "setting_share.h"
#include "view_bench.h"

#include "core/abi/handles.h"

namespace agaa::test {

template <class Host> class ContainmentCases : public testing::Test {
protected:
    // Software rasterisers do without the words of the interlock.
    ContainmentCases() : hasInterlock(context.caps().flags & AGAA_DEVICE_FRAGMENT_INTERLOCK) {
        if (context.caps().flags & AGAA_DEVICE_SOFTWARE)
            context.get()->caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
    }
    bool runs(const TechniqueTier& tier) const { return test::runs(tier, context.get()->caps); }

    GridFrames render(const TechniqueTier& tier, const BadGrid& grid) {
        ViewSettings settings = grid.settings(tier);
        settings.hasInterlock = hasInterlock;
        ViewBench<Host> bench(context, settings, grid.shot(tier));
        GridFrames frames;
        frames.extent = {settings.width, settings.height};
        const auto words = [&] {
            return tier.flags & AGAA_CONFIG_READBACK ? bench.view().readBuffer("aggregates") : std::vector<uint32_t>();
        };
        frames.good = bench.show(grid.triangles(GridFill::Good));
        frames.bad = bench.show(grid.triangles(GridFill::Bad));
        frames.badWords = words();
        frames.replaced = bench.show(grid.triangles(GridFill::Replaced));
        frames.replacedWords = words();
        frames.bright = bench.show(grid.triangles(GridFill::Bright));
        const Plan& plan = bench.view().plan();
        frames.setCoverage(bench.view().positions(), tier.n, plan.view.hwSamples);
        return frames;
    }

    typename Host::Context context;
    bool hasInterlock;
};
TYPED_TEST_SUITE_P(ContainmentCases);

// Hard case 37: a bad value is shown as the value that replaces it, bit by bit. It changes its pixel by at most its
// share of the samples, and no other pixel. The frame counts it. Positions and fetched corners that are not finite
// break a duty of the host; they still change no other pixel.
TYPED_TEST_P(ContainmentCases, HardCase37ABadFragmentIsContained) {
    constexpr TechniqueTier unfiltered{.technique = "single", .n = 1};
    const GridFrames single = this->render(unfiltered, BadGrid::materials(unfiltered));
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || !this->runs(tier))
            continue;
        const BadGrid grid = BadGrid::materials(tier);
        const GridFrames frames = this->render(tier, grid);
        expectReplaced(frames, tier, grid);
        expectNoNeighbourChanges(frames, tier, grid);
        expectWithinWeight(frames, single, tier, grid);
    }
}

// Plane normals that are shaded, in the passes that shade, sum and store materials.
TYPED_TEST_P(ContainmentCases, HardCase37ABadPlaneNormalIsContained) {
    using enum TechniqueTier::Evaluations;
    const BadGrid grid = BadGrid::planeNormals();
    for (const TechniqueTier& tier :
         {TechniqueTier{.technique = "msaa", .n = 4, .evaluations = EachTexel},
          {.technique = "agaa", .n = 8, .tier = AGAA_TIER_PER_SAMPLE, .evaluations = EachSample},
          {.technique = "agaa", .n = 8, .tier = AGAA_TIER_GBUFFER, .evaluations = EachTexel}}) {
        SCOPED_TRACE(testing::Message() << tier);
        const GridFrames frames = this->render(tier, grid);
        expectReplaced(frames, tier, grid);
        expectNoNeighbourChanges(frames, tier, grid);
    }
}

// A plane normal without length has no direction, as one that is not finite: agaa_planeNormal() returns it for
// primitives without a plane. Both become the direction to the eye, which differs from pixel to pixel here.
TYPED_TEST_P(ContainmentCases, PlaneNormalsWithoutADirectionFaceTheEye) {
    ViewSettings settings;
    settings.width = settings.height = 16;
    settings.projection = perspective(90, 1, 0.1f, 100);
    settings.facts.flags |= AGAA_FACT_PLANE_NORMALS;
    settings.facts.shadowMapCount = 0;
    settings.config.technique = "ssaa";
    settings.config.samples = 4;
    const auto image = [&](const glm::vec3& normal) {
        Triangle t;
        t.position[0] = {-50, -50, -5};
        t.position[1] = {100, -50, -5};
        t.position[2] = {-50, 100, -5};
        t.material = facing(glm::vec3(0.5f));
        t.material.geometricNormal = glm::vec4(normal, 0);
        return show(this->context, settings, {.triangles = {t}}).rgb;
    };
    const std::vector<float> none = image(glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_LT(none[0], 0.8f * none[3 * (8 * 16 + 8)]) << "the eye is in another direction than the sun";
    EXPECT_EQ(image(glm::vec3(0)), none);
    EXPECT_EQ(image(glm::vec3(1e-40f)), none);
}

// Custom attributes, which aggregates in memory show.
TYPED_TEST_P(ContainmentCases, HardCase37ABadCustomAttributeIsContained) {
    using enum TechniqueTier::Evaluations;
    constexpr uint64_t readable = AGAA_CONFIG_READBACK | AGAA_CONFIG_BUFFERED;
    const BadGrid grid = BadGrid::customAttributes();
    for (const TechniqueTier& tier :
         {TechniqueTier{
              .technique = "agaa", .n = 8, .tier = AGAA_TIER_PER_SAMPLE, .flags = readable, .evaluations = EachSample},
          {.technique = "agaa", .n = 8, .tier = AGAA_TIER_GBUFFER, .flags = readable, .evaluations = EachTexel},
          {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS, .flags = readable},
          {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS}}) {
        SCOPED_TRACE(testing::Message() << tier);
        const GridFrames frames = this->render(tier, grid);
        expectReplaced(frames, tier, grid);
        expectNoNeighbourChanges(frames, tier, grid);
        EXPECT_EQ(frames.badWords.empty(), !(tier.flags & AGAA_CONFIG_READBACK));
        EXPECT_EQ(frames.badWords, frames.replacedWords);
    }
}

REGISTER_TYPED_TEST_SUITE_P(ContainmentCases, HardCase37ABadFragmentIsContained, HardCase37ABadPlaneNormalIsContained,
                            PlaneNormalsWithoutADirectionFaceTheEye, HardCase37ABadCustomAttributeIsContained);

} // namespace agaa::test
