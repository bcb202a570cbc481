// Fragments of decoupled coverage that carry their materials, beside those whose materials are fetched. Each graphics
// API instantiates these.
#pragma once

#include "agreement.h"
#include "dcaa_cases.h"

#include "shader_math.h"

#include <bit>

namespace agaa::test {

inline ViewSettings carriedSettings(uint32_t samples = 64, uint32_t surfaces = 4) {
    return dcaaSettings(samples, surfaces, AGAA_TIER_MATERIAL_LISTS);
}

template <class Host> class CarriedCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(CarriedCases);

// Lists and surfaces, and the image up to the rounding of materials before they merge.
TYPED_TEST_P(CarriedCases, MergesAsFetchedFragments) {
    for (const auto& [samples, isTangle] : {std::pair{64u, true}, {64u, false}, {32u, false}, {128u, true}}) {
        SCOPED_TRACE(std::to_string(samples) + (isTangle ? " tangle" : " random"));
        const Shot shot{.triangles = isTangle ? tangle(300) : randomTriangles({.triangles = 150}, 61),
                        .change = addAmbient};
        const Kept fetched = this->keep(dcaaSettings(samples), shot),
                   carried = this->keep(carriedSettings(samples), shot);
        for (size_t p = 0; p < fetched.pixels.size(); ++p) {
            if (isInOrder(
                    this->context.caps())) { // merging puts other lists in order, and some fragments before the first
                ASSERT_EQ(carried.lists[p].size(), fetched.lists[p].size()) << p;
            }
            expectSame(carried.pixels[p], fetched.pixels[p], p, !isInOrder(this->context.caps()));
        }
        const AgaaCounters &a = fetched.counters, &b = carried.counters;
        EXPECT_EQ(b.fragments, a.fragments);
        EXPECT_EQ(b.mergedFirst, a.mergedFirst);
        EXPECT_EQ(b.mergedSecond, a.mergedSecond);
        EXPECT_EQ(b.discarded, a.discarded);
        EXPECT_TRUE(b.mergedFirst > 0 || !isTangle);
        EXPECT_GT(b.mergedFirst + b.mergedSecond + b.discarded, 0u);
        const Difference d = compare(carried.rgb, fetched.rgb);
        std::printf("%u samples: PSNR %.1f dB to fetched materials\n", samples, d.psnr);
        EXPECT_GT(d.psnr, 100);
    }
}

// The samples of cut-outs and translucent surfaces, and the place where materials are evaluated among them.
TYPED_TEST_P(CarriedCases, MaterialsAreEvaluatedInTheMiddleOfWhatIsCovered) {
    Shot shot{.triangles = randomTriangles({.triangles = 200, .masked = 0.5f}, 17), .change = addAmbient};
    ViewSettings carried = carriedSettings();
    carried.surface = "s.diffuse = agaa_cornerWeights(agaa_coveredMiddle(s)).at; s.emissive = vec3(0.0);";
    ViewSettings opaque = dcaaSettings();
    // Fetched ones by the middle of the same samples: those of fragments without alpha.
    for (Triangle& t : shot.triangles)
        t.isMasked = false;
    shot.material = "m.diffuse = p.at; m.emissive = vec3(0.0);";
    const Difference d = compare(this->render(carried, shot).rgb, this->render(opaque, shot).rgb);
    std::printf("PSNR %.1f dB\n", d.psnr);
    EXPECT_GT(d.psnr, isInOrder(this->context.caps()) ? 90 : 75) << "78.0 on an NVIDIA H200";
    // A cut-out's samples are on one side of the pixel, and so is their middle.
    carried.surface =
        "s.alphaCutoff = 0.5; s.hasAlphaNear = true; s.alphaNear = vec4(-1.0, 1.0, -1.0, 1.0) * 0.4 + 0.5; "
        "s.emissive = vec3(agaa_coveredMiddle(s), 0.0); s.diffuse = s.specular = vec3(0.0);";
    carried.projection = pixelOrthographic(48, 32, 10);
    Shot cutOut{.triangles = rectangle(4, 4, 40, 28, 5, {})};
    for (Triangle& t : cutOut.triangles)
        t.isMasked = true;
    const Shown shown = this->render(carried, cutOut);
    const float* rgb = &shown.rgb[3 * (48 * 10 + 30)]; // one triangle covers the pixel
    EXPECT_NEAR(rgb[0], 0.5 * 0.25, 0.01);
    EXPECT_NEAR(rgb[1], 0.0, 0.01);
}

// Lobes widen by the derivatives of normals that the host gives, or do not.
TYPED_TEST_P(CarriedCases, CurvedPrimitivesWidenLobes) {
    Shot shot{.triangles = randomTriangles({.triangles = 60}, 5), .change = addAmbient};
    for (Triangle& t : shot.triangles)
        t.material.normal = glm::vec4(planeNormal(t), 0.01f);
    ViewSettings carried = carriedSettings();
    const Shown flat = this->render(carried, shot);
    carried.surface = "s.normalDx = vec3(0.2, 0.0, 0.1); s.normalDy = vec3(0.0, 0.4, 0.0);";
    shot.material = "m.normalDx = vec3(0.2, 0.0, 0.1); m.normalDy = vec3(0.0, 0.4, 0.0);";
    const Shown curved = this->render(carried, shot);
    const Difference d = compare(curved.rgb, this->render(dcaaSettings(), shot).rgb);
    std::printf("PSNR %.1f dB, %.1f dB to flat ones\n", d.psnr, compare(curved.rgb, flat.rgb).psnr);
    EXPECT_GT(d.psnr, 100);
    EXPECT_LT(compare(curved.rgb, flat.rgb).psnr, 60);
}

// Normals spread along one direction more than across it: the same by fragments that carry it, up to its rounding, and
// by those whose materials are fetched; merged and exact.
TYPED_TEST_P(CarriedCases, LobesWidenInEachDirection) {
    Shot shot{.triangles = randomTriangles({.triangles = 60}, 5), .change = addAmbient};
    for (Triangle& t : shot.triangles)
        t.material.normal = glm::vec4(planeNormal(t), 0.001f);
    shot.material = "m.normalDx = vec3(0.3, 0.0, 0.1); m.normalDy = vec3(0.0, 0.02, 0.0);";
    for (const uint64_t flags : {UINT64_C(0), AGAA_COVERAGE_EXACT})
        for (const uint32_t ndf : {AGAA_NDF_LEAN, AGAA_NDF_SGGX}) {
            if (!TypeParam::runsAll && (ndf == AGAA_NDF_SGGX) != (flags != 0))
                continue;
            SCOPED_TRACE(std::to_string(flags) + " " + std::to_string(ndf));
            ViewSettings fetched = dcaaSettings(64, 3), carried = carriedSettings(64, 3);
            carried.surface = "s.normalDx = vec3(0.3, 0.0, 0.1); s.normalDy = vec3(0.0, 0.02, 0.0);";
            carried.config.coverage.flags = fetched.config.coverage.flags = flags;
            carried.config.coverage.fragmentsPerPixel = fetched.config.coverage.fragmentsPerPixel = 64;
            const Shown round = this->render(fetched, shot);
            carried.config.ndf = fetched.config.ndf = ndf;
            const Shown elliptic = this->render(fetched, shot);
            const double same = compare(this->render(carried, shot).rgb, elliptic.rgb).psnr;
            const double other = compare(round.rgb, elliptic.rgb).psnr;
            std::printf("PSNR %.1f dB, %.1f dB to round lobes\n", same, other);
            EXPECT_EQ(nonFinite(elliptic.rgb), 0u);
            EXPECT_GT(same, 75);
            EXPECT_LT(other, 60);
        }
}

// Two normals of a pixel end in one surface: what memory keeps of them is what all samples' normals say. The larger
// share comes first, and last, so that either one takes the other.
TYPED_TEST_P(CarriedCases, SpreadsAreThoseOfTheNormalsThatMerged) {
    const glm::vec3 a = glm::normalize(glm::vec3(0.4f, 0.1f, 1)), b = glm::normalize(glm::vec3(-0.2f, 0.3f, 1));
    for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS})
        for (const float share : {0.25f, 0.75f}) {
            if (!TypeParam::runsAll && (tier == AGAA_TIER_FRAGMENT_LISTS) != (share < 0.5f))
                continue;
            SCOPED_TRACE(std::string(agaaTierName(tier)) + " " + std::to_string(share));
            ViewSettings settings = dcaaSettings(64, 1, tier);
            settings.config.ndf = AGAA_NDF_LEAN;
            settings.projection = pixelOrthographic(48, 32, 10);
            Material first, second;
            first.normal = glm::vec4(a, 0.01f);
            second.normal = glm::vec4(b, 0.01f);
            Shot shot{.triangles = rectangle(10, 10, 10 + share, 11, 5, first)};
            for (const Triangle& t : rectangle(10 + share, 10, 11, 11, 5, second))
                shot.triangles.push_back(t);
            const std::vector<uint32_t> words = this->keep(settings, shot).words[10 * 48 + 10];
            ASSERT_GT(words.size(), 6u);
            EXPECT_EQ(std::popcount(words[0]) + std::popcount(words[1]), 64);
            const glm::vec2 code = glm::vec2(float(words[4] & 0xFFFFu), float(words[4] >> 16)) / 65535.0f;
            const glm::vec3 n = math_f::agaa_decodeOct(code, 16);
            EXPECT_GT(glm::dot(n, glm::normalize(share * a + (1 - share) * b)), 0.999f);
            glm::vec3 t, u;
            math_f::agaa_spreadBasis(n, t, u);
            const auto moment = [&](const glm::vec3& x, const glm::vec3& y) {
                return share * glm::dot(a, x) * glm::dot(a, y) + (1 - share) * glm::dot(b, x) * glm::dot(b, y);
            };
            const auto low = [](uint32_t word) { return std::bit_cast<float>(word << 16); };
            const auto high = [](uint32_t word) { return std::bit_cast<float>(word & 0xFFFF0000u); };
            EXPECT_NEAR(low(words[5]), moment(t, t), 0.004f);
            EXPECT_NEAR(high(words[5]), moment(u, u), 0.004f);
            EXPECT_NEAR(low(words[6]), moment(t, u), 0.004f);
            EXPECT_NEAR(high(words[6]), glm::length(share * a + (1 - share) * b), 0.004f);
            EXPECT_GT(moment(t, t) + moment(u, u), 0.02f);
        }
}

// With AGAA_COVERAGE_DRAW_ORDER the numbers that the host gives decide the order, and where they are the same, what
// fragments carry: the order of the draws does not.
TYPED_TEST_P(CarriedCases, NumbersThenContentDecideTheOrder) {
    Shot shot{.triangles = tangle(400), .change = addAmbient}, reversed = shot;
    std::reverse(reversed.triangles.begin(), reversed.triangles.end());
    ViewSettings settings = carriedSettings(64, 2);
    settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER;
    ViewSettings turned = settings;
    const Shown first = this->render(settings, shot);
    EXPECT_NE(this->render(settings, reversed).rgb, first.rgb);
    turned.surface = "s.primitive = 399u - s.primitive;";
    EXPECT_EQ(this->render(turned, reversed).rgb, first.rgb);
    settings.surface = "s.draw = s.primitive = 0u;";
    const Shown equal = this->render(settings, shot);
    EXPECT_NE(equal.rgb, first.rgb);
    EXPECT_EQ(this->render(settings, reversed).rgb, equal.rgb);
}

// What is not finite, and surfaces at the far plane.
TYPED_TEST_P(CarriedCases, WhatIsNotFiniteIsReplaced) {
    ViewSettings settings = carriedSettings();
    settings.surface = "s.diffuse.x = uintBitsToFloat(0x7FC00000u); s.normalDx = vec3(s.diffuse.x);";
    const Shot shot{.triangles = randomTriangles({.triangles = 40}, 9), .change = addAmbient};
    const Shown shown = this->render(settings, shot);
    EXPECT_EQ(nonFinite(shown.rgb), 0u);
    EXPECT_EQ(shown.counters.sanitised, shown.counters.fragments);
    ViewSettings flat = carriedSettings();
    flat.projection = pixelOrthographic(48, 32, 10);
    const Shown far = this->render(flat, {.triangles = rectangle(4, 4, 40, 28, 10, {})});
    EXPECT_EQ(far.counters.visible, 0u);
    EXPECT_GT(this->render(flat, {.triangles = rectangle(4, 4, 40, 28, 9.9f, {})}).counters.visible, 0u);
}

// Fragments at the far plane ask for no room, and each one is counted in one draw alone.
TYPED_TEST_P(CarriedCases, BatchesAreForFragmentsInLists) {
    ViewSettings settings = carriedSettings();
    settings.width = 322;
    settings.height = 242;
    settings.projection = pixelOrthographic(322, 242, 10);
    settings.surface = "s.diffuse.x = uintBitsToFloat(0x7FC00000u);";
    settings.config.coverage.fragmentsPerPixel = 1;
    settings.config.coverage.maxBatches = 8;
    Shot shot{.triangles = rectangle(0, 0, 322, 242, 10, {})};
    for (const Triangle& t : rectangle(2, 2, 300, 240, 5, {}))
        shot.triangles.push_back(t);
    const Shown one = this->render(settings, shot);
    EXPECT_EQ(one.counters.batches, 1u) << "the far rectangle is in no list";
    EXPECT_EQ(one.counters.sanitised, one.counters.fragments);
    for (const Triangle& t : rectangle(2, 2, 300, 240, 4, {}))
        shot.triangles.push_back(t);
    const Shown several = this->render(settings, shot);
    EXPECT_GE(several.counters.batches, 3u);
    EXPECT_EQ(several.counters.lostFragments, 0u);
    EXPECT_EQ(several.counters.fragments, 2 * one.counters.fragments);
    EXPECT_EQ(several.counters.sanitised, several.counters.fragments);
}

REGISTER_TYPED_TEST_SUITE_P(CarriedCases, BatchesAreForFragmentsInLists, MergesAsFetchedFragments,
                            MaterialsAreEvaluatedInTheMiddleOfWhatIsCovered, CurvedPrimitivesWidenLobes,
                            LobesWidenInEachDirection, SpreadsAreThoseOfTheNormalsThatMerged,
                            NumbersThenContentDecideTheOrder, WhatIsNotFiniteIsReplaced);

} // namespace agaa::test
