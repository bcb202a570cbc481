// Hard cases 25, 27 to 30 and 33 of docs/numerics.md: masks of samples, and the ids of their aggregates.
#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

unsigned bitsOf(unsigned mask) { return unsigned(glm::bitCount(mask)); }

unsigned allSamples(unsigned n) { return n == 32 ? ~0u : (1u << n) - 1; }

// Random ids of n samples, as they come back from storage.
glm::uvec2 storedIds(Random& random, unsigned n, unsigned c, std::vector<unsigned>& ids) {
    glm::uvec2 planes(0u);
    ids.resize(n);
    for (unsigned s = 0; s < n; ++s) {
        ids[s] = random.below(c);
        math_f::agaa_putAggregateId(planes, s, ids[s]);
    }
    return math_f::agaa_loadedPlanes(math_f::agaa_storedPlanes(planes, n, c), n, c);
}

} // namespace

TEST(HardCase25_CoplanarDuplicates, EachSampleCountsOnce) {
    Random random(425);
    HardCaseFigures figures(25, "samples of a pixel that are counted more than once", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 1u << random.below(6);
        // Fragments of equal depth, which all pass the test EQUAL.
        const unsigned fragments = 1 + random.below(5);
        unsigned claimed = 0, counted = 0, sum = 0;
        for (unsigned f = 0; f < fragments; ++f) {
            const unsigned mask = (random.below(2) ? ~0u : random.below(~0u)) & allSamples(n);
            counted += bitsOf(math_f::agaa_freshSamples(mask, claimed));
            claimed |= mask;
            sum += bitsOf(mask);
        }
        ASSERT_LE(counted, n);
        figures.add(sum - bitsOf(claimed), std::abs(double(counted) - bitsOf(claimed)));
    }
}

TEST(HardCase27_FragmentsAcrossAggregates, WeightsAreTheSamples) {
    Random random(427);
    HardCaseFigures figures(27, "samples by which an aggregate's weight is wrong", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 2u << random.below(5), c = 2 + random.below(3);
        std::vector<unsigned> ids;
        const glm::uvec2 planes = storedIds(random, n, c, ids);
        unsigned expected[4] = {}, routed[4] = {}, split[4] = {};
        for (unsigned left = allSamples(n); left != 0;) { // fragments that share out the samples
            const unsigned mask = random.below(3) ? left & random.below(~0u) : left;
            left &= ~mask;
            if (mask == 0)
                continue;
            // The paper's way gives all samples to the aggregate of the first one.
            routed[ids[std::size_t(glm::findLSB(mask))]] += bitsOf(mask);
            for (unsigned a = 0; a < c; ++a)
                split[a] += bitsOf(mask & math_f::agaa_samplesOfAggregate(planes, a));
        }
        for (unsigned s = 0; s < n; ++s)
            ++expected[ids[s]];
        for (unsigned a = 0; a < c; ++a)
            figures.add(std::abs(double(routed[a]) - expected[a]), std::abs(double(split[a]) - expected[a]));
    }
}

TEST(HardCase28_EmptyMasks, NoSampleIsTaken) {
    Random random(428);
    HardCaseFigures figures(28, "samples outside the mask that are taken", 0.0);
    for (int i = 0; i < 100000; ++i) {
        // Helper invocations, and fragments that alpha discards, have empty masks.
        glm::uvec4 mask(0u);
        for (int w = 0; w < 4; ++w)
            mask[w] = random.below(3) ? 0u : random.below(~0u) & random.below(~0u);
        unsigned naive = 0, ours = 0;
        for (int w = 0; w < 4; ++w) {
            // A loop that tests the mask at its end takes sample -1 of an empty word, by a shift of 31 on most devices.
            const unsigned first = unsigned(glm::findLSB(mask[w]));
            naive += !(mask[w] >> (first & 31u) & 1u);
        }
        const unsigned count = math_f::agaa_coverageCount(mask);
        for (unsigned k = 0; k < count; ++k)
            ours += !math_f::agaa_isCovered(mask, math_f::agaa_coveredSample(mask, k));
        const glm::vec2 middle = math_f::agaa_coverageMiddle(mask, 128);
        ours += !(std::abs(middle.x) <= 0.5f && std::abs(middle.y) <= 0.5f);
        figures.add(naive, ours);
    }
    EXPECT_EQ(math_f::agaa_translucentMask(0.0f, 32, 0, 4, 0), 0u);
    EXPECT_EQ(math_f::agaa_translucentMask(nanF(), 32, 0, 4, 0), 0u);
    math_f::Clustering c{};
    EXPECT_EQ(c.agaa_defineAggregates(8, 0, 4, 0.1f, 0.02f, 0), 0u);
}

TEST(HardCase29_IdsOfThreeAggregates, AllCountsRoundTrip) {
    Random random(429);
    HardCaseFigures figures(29, "share of a pixel's samples with a wrong id", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const unsigned c = 1 + random.below(4), n = 1u << random.below(6);
        std::vector<unsigned> ids;
        const glm::uvec2 planes = storedIds(random, n, c, ids);
        unsigned naive = 0, ours = 0;
        for (unsigned s = 0; s < n; ++s) {
            naive += (ids[s] & (c - 1)) != ids[s]; // Algorithm 2 as printed
            for (unsigned a = 0; a < c; ++a)
                ours += (math_f::agaa_samplesOfAggregate(planes, a) >> s & 1u) != unsigned(ids[s] == a);
        }
        figures.add(naive / double(n), ours / double(n));
    }
    // The printed mask is right for powers of two only.
    for (unsigned c = 1; c <= 8; ++c)
        for (unsigned id = 0; id < c; ++id)
            if ((c & (c - 1)) == 0) {
                EXPECT_EQ(id & (c - 1), id);
            }
}

TEST(HardCase30_SixtyFourBitsOfMetadata, NoShiftReachesThirtyTwo) {
    Random random(430);
    HardCaseFigures figures(30, "share of a pixel's samples with a wrong id", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 32, c = 4;
        std::vector<unsigned> ids;
        const glm::uvec2 planes = storedIds(random, n, c, ids);
        // Ids side by side in one word, with the shifts that GPUs do: modulo 32.
        unsigned word = 0, naive = 0, ours = 0;
        for (unsigned s = 0; s < n; ++s)
            word |= ids[s] << (2 * s & 31u);
        for (unsigned s = 0; s < n; ++s) {
            naive += (word >> (2 * s & 31u) & 3u) != ids[s];
            ours += (math_f::agaa_samplesOfAggregate(planes, ids[s]) >> s & 1u) == 0;
        }
        figures.add(naive / double(n), ours / double(n));
    }
}

TEST(HardCase30_SixtyFourBitsOfMetadata, LastSampleLastAggregate) {
    glm::uvec2 planes(0u);
    math_f::agaa_putAggregateId(planes, 31, 3);
    EXPECT_EQ(planes, glm::uvec2(0x80000000u, 0x80000000u));
    EXPECT_EQ(math_f::agaa_storedPlanes(planes, 32, 4), planes);
    EXPECT_EQ(math_f::agaa_samplesOfAggregate(planes, 3), 0x80000000u);
    EXPECT_EQ(math_f::agaa_samplesOfAggregate(planes, 0), 0x7FFFFFFFu);
}

TEST(HardCase33_Saturation, DuplicatesKeepTheHue) {
    Random random(433);
    HardCaseFigures figures(33, "error of the ratio of two channels, the brighter of which is white", 1e-3);
    for (int i = 0; i < 100000; ++i) {
        // The surface is drawn once or twice; its samples are single fragments.
        const unsigned n = 1u << random.below(6), bits = i % 2 ? 10 : 16, top = math_f::agaa_maxCode(bits);
        const unsigned draws = 1 + random.below(2);
        const float dim = random.rangeF(0.1, 1);
        // Blending rounds each sample's share and clamps the sum.
        unsigned naiveWhite = 0, naiveDim = 0;
        unsigned claimed = 0, white = 0, dimSum = 0;
        for (unsigned f = 0; f < n * draws; ++f) {
            naiveWhite = std::min(naiveWhite + unsigned(double(top) / n + 0.5), top);
            naiveDim = std::min(naiveDim + unsigned(double(dim) * top / n + 0.5), top);
            const unsigned fresh = bitsOf(math_f::agaa_freshSamples(1u << f % n, claimed));
            claimed |= 1u << f % n;
            white += fresh * math_f::agaa_quantise(1.0f, bits);
            dimSum += fresh * math_f::agaa_quantise(dim, bits);
        }
        const unsigned count = bitsOf(claimed);
        const float whiteMean = math_f::agaa_meanOfSum(white, count, bits);
        ASSERT_EQ(whiteMean, 1.0f);
        figures.add(std::abs(double(naiveDim) / naiveWhite - double(dim)),
                    std::abs(double(math_f::agaa_meanOfSum(dimSum, count, bits) / whiteMean) - double(dim)));
    }
}

TEST(HardCase33_Saturation, WhiteStaysExactlyWhite) {
    for (unsigned bits = 1; bits <= 16; ++bits)
        for (unsigned n = 1; n <= 32; ++n)
            EXPECT_EQ(math_f::agaa_meanOfSum(n * math_f::agaa_quantise(1.0f, bits), n, bits), 1.0f);
    // Rounded shares of white exceed the largest code: 32 times 32 in 10 bits are 1024.
    EXPECT_GT(32 * unsigned(1023.0 / 32 + 0.5), 1023u);
}
