// How fragments merge, written once more in other words, against the shader's.
#include "fragment_random.h"
#include "paper_merge.h"
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using math_f::KeptSurfaces;
using Shader = KeptSurfaces::agaa_CoveredSurface;
using namespace paper;

// ---- random pixels ---------------------------------------------------------------------------------

glm::uvec4 wordsOf(const Bits& bits) {
    glm::uvec4 words(0u);
    for (uint32_t i = 0; i < 128; ++i)
        words[int(i / 32)] |= uint32_t(bits[i]) << (i % 32);
    return words;
}

Shader shaderOf(const Surface& s) {
    return {wordsOf(s.coverage),
            {s.depth, s.slopeX, s.slopeY},
            {s.middle, s.below, s.above},
            {s.normal[0], s.normal[1], s.normal[2]}};
}

// Few depths and few directions, so that all branches are taken and ties occur.
Surface randomFragment(FragmentRandom& random, uint32_t samples) {
    Surface s{};
    const uint32_t first = random.below(samples), count = 1 + random.below(samples);
    for (uint32_t i = 0; i < count; ++i)
        s.coverage.set((first + i) % samples);
    s.depth = 0.1f * float(random.below(9));
    if (random.below(3))
        s.slopeX = random(-0.2f, 0.2f), s.slopeY = random(-0.2f, 0.2f);
    s.middle = s.depth + 0.05f * float(random.below(3)) - 0.05f;
    s.below = 0.05f * float(random.below(3));
    s.above = 0.05f * float(random.below(3));
    const float angle = 0.3f * float(random.below(7));
    s.normal[0] = std::sin(angle);
    s.normal[2] = std::cos(angle);
    return s;
}

void expectEqual(const KeptSurfaces& got, const Pixel& expected) {
    ASSERT_EQ(got.agaa_keptCount, expected.surfaces.size());
    for (size_t i = 0; i < expected.surfaces.size(); ++i) {
        const Shader want = shaderOf(expected.surfaces[i]);
        const Shader& is = got.agaa_kept[i];
        ASSERT_EQ(is.mask, want.mask) << i;
        ASSERT_EQ(is.plane, want.plane) << i;
        ASSERT_EQ(is.depths, want.depths) << i;
        ASSERT_EQ(is.normal, want.normal) << i;
    }
}

// Planes whose slopes are in the units of view space.
constexpr math_f::agaa_FacetFrame kFacets = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}};

float facetCosine(const Surface& a, const Surface& b) {
    const auto normal = [](const Surface& s) {
        return math_f::agaa_facetNormal(kFacets, {s.depth, s.slopeX, s.slopeY});
    };
    return glm::dot(normal(a), normal(b));
}

KeptSurfaces::agaa_MergeRules shaderRules(const Rules& rules) {
    return {uint32_t(rules.limit), rules.cosine, rules.slack, uint32_t(rules.rule), kFacets, false};
}

std::vector<Surface> randomPixel(FragmentRandom& random, uint32_t samples) {
    std::vector<Surface> fragments(random.below(24));
    for (Surface& s : fragments)
        s = randomFragment(random, samples);
    return fragments;
}

// Of three unlike normals, the nearest pair merges in a full pixel, unless colours differ more.
TEST(SurfaceMerge, ColoursCountAsNormalsDo) {
    const auto surface = [](float angle, uint32_t mask) {
        return Shader{{mask, 0, 0, 0}, {0.5f, 0, 0}, {0.5f, 0, 0}, {std::sin(angle), 0, std::cos(angle)}};
    };
    for (const auto& [rule, into] : {std::pair{AGAA_RULE_VISIBLE, 1u}, {AGAA_RULE_COLOR, 0u}}) {
        const KeptSurfaces::agaa_MergeRules rules = {2, 0.98f, 1e-6f, rule, kFacets, false};
        KeptSurfaces kept;
        kept.colors[1] = 1; // of the second surface; the fragment has that of the first
        kept.agaa_insertSurface(surface(0, 1), rules);
        kept.agaa_insertSurface(surface(1.2f, 2), rules);
        EXPECT_EQ(kept.agaa_insertSurface(surface(0.7f, 4), rules).to, into) << rule;
    }
}

TEST(SurfaceMerge, IsAlgorithm1OfThePaper) {
    FragmentRandom random{std::mt19937(1)};
    uint32_t kinds[4] = {};
    for (int run = 0; run < 20000; ++run) {
        const uint32_t samples = 32u << random.below(3);
        const Rules rules = {1 + random.below(8), std::cos(3.14159265f / 16), random.below(2) ? 2e-6f : 0.0f,
                             decltype(Rules::rule)(random.below(3)), facetCosine};
        KeptSurfaces shader{};
        Pixel paper;
        uint32_t lost = 0, mergedFirst = 0, mergedSecond = 0, discarded = 0;
        for (const Surface& s : randomPixel(random, samples)) {
            const auto done = shader.agaa_insertSurface(shaderOf(s), shaderRules(rules));
            lost += done.lost;
            mergedFirst += !done.isSecond && done.hasMerged;
            mergedSecond += done.isSecond && done.hasMerged;
            discarded += done.isSecond && !done.hasMerged;
            ++kinds[!done.isSecond ? done.share < 1 ? 0 : 1 : done.lost ? 2 : 3];
            paper.insert(s, rules);
        }
        ASSERT_NO_FATAL_FAILURE(expectEqual(shader, paper)) << run;
        ASSERT_EQ(lost, paper.lostSamples);
        ASSERT_EQ(mergedFirst, paper.mergedFirst);
        ASSERT_EQ(mergedSecond, paper.mergedSecond);
        ASSERT_EQ(discarded, paper.discarded);
    }
    for (const uint32_t count : kinds)
        EXPECT_GT(count, 1000u);
}

// What the caller does with attributes by the answers is what the function does with normals before they are made unit.
TEST(SurfaceMerge, AnswersSayWhatBecomesOfAttributes) {
    FragmentRandom random{std::mt19937(2)};
    for (int run = 0; run < 5000; ++run) {
        const Rules rules = {1 + random.below(4), 0.98f, 0.0f, Rules::Paper, facetCosine}; // which averages depths, too
        KeptSurfaces shader{};
        float value[9] = {};
        for (const Surface& s : randomPixel(random, 64)) {
            const auto done = shader.agaa_insertSurface(shaderOf(s), shaderRules(rules));
            value[rules.limit] = s.depth;
            const auto mix = [&](uint32_t to, float from, float share) { value[to] += (from - value[to]) * share; };
            if (done.from != AGAA_NO_SURFACE)
                mix(done.into, value[done.from], done.moved);
            if (done.to != AGAA_NO_SURFACE)
                done.share < 1 ? mix(done.to, value[rules.limit], done.share)
                               : void(value[done.to] = value[rules.limit]);
        }
        for (uint32_t i = 0; i < shader.agaa_keptCount; ++i)
            ASSERT_EQ(value[i], shader.agaa_kept[i].plane.x) << run;
    }
}

// Hard case 51: the result depends on the order, so that a test of the order can fail.
TEST(SurfaceMerge, DependsOnTheOrder) {
    FragmentRandom random{std::mt19937(3)};
    const Rules rules = {4, 0.98f, 0.0f, Rules::Visible, facetCosine};
    uint32_t differing = 0, repeated = 0;
    for (int run = 0; run < 1000; ++run) {
        std::vector<Surface> fragments(8);
        for (Surface& s : fragments)
            s = randomFragment(random, 64);
        KeptSurfaces results[3] = {};
        for (const Surface& s : fragments)
            for (int i = 0; i < 2; ++i)
                results[i].agaa_insertSurface(shaderOf(s), shaderRules(rules));
        std::reverse(fragments.begin(), fragments.end());
        for (const Surface& s : fragments)
            results[2].agaa_insertSurface(shaderOf(s), shaderRules(rules));
        const auto same = [](const KeptSurfaces& a, const KeptSurfaces& b) {
            bool is = a.agaa_keptCount == b.agaa_keptCount;
            for (uint32_t i = 0; is && i < a.agaa_keptCount; ++i)
                is = a.agaa_kept[i].mask == b.agaa_kept[i].mask && a.agaa_kept[i].plane == b.agaa_kept[i].plane;
            return is;
        };
        differing += !same(results[0], results[2]);
        repeated += same(results[0], results[1]);
    }
    EXPECT_EQ(repeated, 1000u);
    EXPECT_GT(differing, 500u);
}

// Whatever is merged or discarded, no sample is covered that no fragment covered, and none is lost that is not counted.
TEST(SurfaceMerge, KeepsCoverage) {
    FragmentRandom random{std::mt19937(4)};
    for (int run = 0; run < 5000; ++run) {
        const Rules rules = {1 + random.below(5), 0.98f, 0.0f, decltype(Rules::rule)(random.below(3)), facetCosine};
        KeptSurfaces shader{};
        glm::uvec4 all(0u);
        uint32_t lost = 0;
        for (const Surface& s : randomPixel(random, 128)) {
            lost += shader.agaa_insertSurface(shaderOf(s), shaderRules(rules)).lost;
            all |= wordsOf(s.coverage);
        }
        glm::uvec4 kept(0u);
        for (uint32_t i = 0; i < shader.agaa_keptCount; ++i)
            kept |= shader.agaa_kept[i].mask;
        ASSERT_EQ(kept & ~all, glm::uvec4(0u));
        ASSERT_LE(math_f::agaa_coverageCount(all & ~kept), lost);
    }
}

} // namespace
