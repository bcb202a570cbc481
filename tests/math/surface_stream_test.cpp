// Surfaces that take samples from each other (surface_stream.glsl): what each sample shows, against all fragments.
#include "fragment_random.h"
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace {

using Kept = math_f::KeptSurfaces;
using Fragment = Kept::agaa_CoveredSurface;

Fragment randomFacet(FragmentRandom& random, uint32_t samples, float angle) {
    Fragment s{};
    const uint32_t first = random.below(samples), count = 1 + random.below(samples);
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t i = (first + k) % samples;
        s.mask[int(i / 32)] |= 1u << (i % 32);
    }
    s.plane = {0.1f * float(random.below(9)), random(-0.2f, 0.2f), random(-0.2f, 0.2f)};
    s.depths = {s.plane.x, 0.3f, 0.3f};
    s.normal = {std::sin(angle), 0, std::cos(angle)};
    return s;
}

bool covers(const Fragment& s, uint32_t i) { return s.mask[int(i / 32)] >> (i % 32) & 1u; }

// In double, by the pattern's places.
double depthAt(const Fragment& s, uint32_t i, uint32_t samples) {
    const glm::dvec2 at = glm::dvec2(math_f::agaa_coveragePosition(i, samples));
    const double low = double(s.depths.x) - double(s.depths.y), high = double(s.depths.x) + double(s.depths.z);
    return std::clamp(double(s.plane.x) + double(s.plane.y) * at.x + double(s.plane.z) * at.y, low, high);
}

struct Streamed {
    Kept kept;
    uint32_t lost = 0;
};

Streamed stream(const std::vector<Fragment>& fragments, uint32_t limit, uint32_t rule, uint32_t samples) {
    const math_f::agaa_FacetFrame facets = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0.2f}};
    Streamed out;
    std::fill(std::begin(out.kept.nearest), std::end(out.kept.nearest), out.kept.agaa_noDepth());
    for (const Fragment& s : fragments)
        out.lost += out.kept.agaa_streamSurface(s, {limit, 0.9f, 1e-6f, rule, facets, true}, samples).lost;
    return out;
}

uint32_t countOf(const Kept& kept, uint32_t i) {
    uint32_t count = 0;
    for (uint32_t k = 0; k < kept.agaa_keptCount; ++k)
        count += covers(kept.agaa_kept[k], i);
    return count;
}

} // namespace

TEST(SurfaceStream, SamplesKeepTheLeastDepthAndBelongToOneSurface) {
    FragmentRandom random{std::mt19937(7)};
    uint32_t lost = 0, shown = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const uint32_t samples = 32u << random.below(3), limit = 1 + random.below(8);
        std::vector<Fragment> fragments(1 + random.below(12));
        for (Fragment& s : fragments)
            s = randomFacet(random, samples, 0.3f * float(random.below(7)));
        const Streamed merged = stream(fragments, limit, AGAA_RULE_VISIBLE, samples);
        const Streamed printed = stream(fragments, limit, AGAA_RULE_NONE, samples);
        ASSERT_LE(merged.kept.agaa_keptCount, limit);
        ASSERT_EQ(merged.lost, 0u);
        lost += printed.lost;
        for (uint32_t i = 0; i < samples; ++i) {
            double nearest = 1e30;
            for (const Fragment& s : fragments)
                nearest = covers(s, i) ? std::min(nearest, depthAt(s, i, samples)) : nearest;
            const bool isCovered = nearest < 1e30;
            ASSERT_EQ(countOf(merged.kept, i), isCovered ? 1u : 0u) << i;
            ASSERT_LE(countOf(printed.kept, i), isCovered ? 1u : 0u) << i;
            if (isCovered) {
                ASSERT_NEAR(double(merged.kept.nearest[i]), nearest, 1e-6);
                ASSERT_EQ(printed.kept.nearest[i], merged.kept.nearest[i]);
                shown += countOf(printed.kept, i);
            }
        }
    }
    EXPECT_GT(lost, 1000u);
    EXPECT_GT(shown, 1000u);
}

// Fragments that cannot merge keep the samples where they are nearest, and those without any leave their place.
TEST(SurfaceStream, UnlikeFragmentsKeepWhatTheyShow) {
    FragmentRandom random{std::mt19937(11)};
    uint32_t hidden = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        constexpr uint32_t samples = 64, limit = 4;
        std::vector<Fragment> fragments(limit);
        for (size_t k = 0; k < fragments.size(); ++k) // the cosine of 0.7 is below that of the rules
            fragments[k] = randomFacet(random, samples, 0.7f * float(k));
        const Kept kept = stream(fragments, limit, AGAA_RULE_VISIBLE, samples).kept;
        for (const Fragment& s : fragments) {
            glm::uvec4 expected(0u);
            for (uint32_t i = 0; i < samples; ++i)
                if (covers(s, i) && std::fabs(double(kept.nearest[i]) - depthAt(s, i, samples)) < 1e-6)
                    expected[int(i / 32)] |= 1u << (i % 32);
            const auto isOf = [&](uint32_t k) { return kept.agaa_kept[k].normal == s.normal; };
            uint32_t place = 0;
            while (place < kept.agaa_keptCount && !isOf(place))
                ++place;
            uint32_t apart = 0;
            for (int w = 0; w < 2; ++w)
                apart += uint32_t(
                    std::popcount(place < kept.agaa_keptCount ? kept.agaa_kept[place].mask[w] & ~expected[w] : 0u));
            hidden += place == kept.agaa_keptCount || kept.agaa_kept[place].mask == glm::uvec4(0u);
            EXPECT_EQ(apart, 0u);
        }
    }
    EXPECT_GT(hidden, 100u);
}
