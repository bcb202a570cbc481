// Classes of samples in the aggregate definition (AGAA_FILTER_CLASS).
#include "clustering_support.h"

#include <map>
#include <numeric>

#include <gtest/gtest.h>

namespace test_math {
namespace {

unsigned classOf(const Sample& s) { return s.keyB >> 24; }
unsigned weightOf(const Sample& s) { return s.keyB >> 16 & 255; }
void setClass(Sample& s, unsigned number, unsigned weight = 1) {
    s.keyB = (s.keyB & 0x0000FFFFu) | weight << 16 | number << 24;
}

// Gives each sample one of `classes` classes, of unlike frequency.
void setClasses(Random& random, std::vector<Sample>& pixel, unsigned classes) {
    for (Sample& s : pixel) {
        const unsigned number = std::min(random.below(classes), random.below(classes));
        setClass(s, 37 * number % 251 + 1, 1 + (number % 2) * random.below(128));
    }
}

template <class Clustering>
RunResult<Clustering> runWithClasses(const std::vector<Sample>& pixel, unsigned c, double k, double t, bool literal) {
    return runClustering<Clustering>(pixel, c, k, t, literal, true);
}

// Returns the ranks of the classes that get aggregates of their own: number of samples, then the class.
std::set<unsigned> keptClasses(const std::vector<Sample>& pixel, unsigned c) {
    std::map<unsigned, unsigned> counts;
    for (const Sample& s : pixel)
        if (s.covered)
            counts[classOf(s)] += weightOf(s);
    std::vector<std::pair<unsigned, unsigned>> ranks;
    for (const auto& [number, count] : counts)
        ranks.push_back({count, number});
    std::sort(ranks.rbegin(), ranks.rend());
    std::set<unsigned> kept;
    for (size_t i = 0; i < std::min<size_t>(c, ranks.size()); ++i)
        kept.insert(ranks[i].second);
    return kept;
}

template <class Clustering>
void expectClassesApart(const std::vector<Sample>& pixel, unsigned c, double k, double t, bool literal) {
    const auto result = runWithClasses<Clustering>(pixel, c, k, t, literal);
    const std::set<unsigned> kept = keptClasses(pixel, c);
    std::map<unsigned, std::set<unsigned>> ofAggregate;
    std::set<unsigned> founded;
    unsigned joining = 0;
    for (size_t i = 0; i < pixel.size(); ++i) {
        if (!pixel[i].covered)
            continue;
        if (!kept.contains(classOf(pixel[i]))) {
            joining |= 1u << i;
            continue;
        }
        ofAggregate[result.ids[i]].insert(classOf(pixel[i]));
        founded.insert(classOf(pixel[i]));
    }
    EXPECT_EQ(result.state->agaa_joiningSamples, joining);
    EXPECT_EQ(founded, kept);
    EXPECT_LE(result.count, c);
    for (const auto& [aggregate, classes] : ofAggregate)
        EXPECT_EQ(classes.size(), 1u) << "aggregate " << aggregate;
    for (size_t i = 0; i < pixel.size(); ++i)
        if (pixel[i].covered) {
            EXPECT_LT(result.ids[i], std::max(result.count, 1u));
        }
}

TEST(ClusteringClasses, AreNeverInOneAggregateWhileThereIsRoom) {
    Random random(20);
    for (unsigned run = 0; run < 4000; ++run) {
        const unsigned n = 1 + random.below(32), c = 1 + random.below(8);
        auto pixel = randomPixel(random, n, 1 + random.below(4), random.decades(1e-3, 1e3), 0.1, 0.9);
        setClasses(random, pixel, 1 + random.below(run % 3 ? 4 : 12));
        const double k = random.decades(1e-6, 1e3), t = run % 5 ? random.decades(1e-3, 1.0) : 1e6;
        SCOPED_TRACE(testing::Message() << "run " << run << " n=" << n << " c=" << c);
        expectClassesApart<math_f::Clustering>(pixel, c, k, t, run % 2);
        expectClassesApart<math_d::Clustering>(pixel, c, k, t, run % 2);
        if (testing::Test::HasFailure())
            return;
    }
}

// A plane that several classes share is divided, too, although its samples do not differ in anything else.
TEST(ClusteringClasses, DivideOnePoint) {
    Random random(21);
    std::vector<Sample> pixel(8, makeSample({0, 0, -3}, {0, 0, 1}, 0));
    for (size_t i = 0; i < pixel.size(); ++i)
        setClass(pixel[i], i < 3 ? 5 : 9);
    const auto result = runWithClasses<math_f::Clustering>(pixel, 2, 0.1, 0.02, false);
    ASSERT_EQ(result.count, 2u);
    for (size_t i = 0; i < pixel.size(); ++i)
        EXPECT_EQ(result.ids[i] == result.ids[0], i < 3) << i;
}

TEST(ClusteringClasses, TheSmallestJoinsTheMostSimilar) {
    std::vector<Sample> pixel;
    const auto add = [&](unsigned count, double depth, unsigned number) {
        for (unsigned i = 0; i < count; ++i) {
            pixel.push_back(makeSample({0, 0, -depth}, {0, 0, 1}, i));
            setClass(pixel.back(), number);
        }
    };
    add(4, 2.0, 1);
    add(3, 5.0, 2);
    add(1, 4.9, 3); // near the second
    const auto result = runWithClasses<math_f::Clustering>(pixel, 2, 0.5, 0.02, false);
    ASSERT_EQ(result.count, 2u);
    EXPECT_NE(result.ids[0], result.ids[4]);
    EXPECT_EQ(result.ids[7], result.ids[4]);
    EXPECT_EQ(result.state->agaa_joiningSamples, 1u << 7);
}

// With one class, results are those without classes.
TEST(ClusteringClasses, OneClassChangesNothing) {
    Random random(22);
    for (unsigned run = 0; run < 1000; ++run) {
        const unsigned n = 1 + random.below(32), c = 1 + random.below(8);
        auto pixel = randomPixel(random, n, 1 + random.below(4), random.decades(1e-3, 1e1), 0.1, 0.9);
        for (Sample& s : pixel)
            setClass(s, 200);
        const double k = random.decades(1e-1, 1e2), t = random.decades(1e-3, 1.0);
        const auto with = runWithClasses<math_f::Clustering>(pixel, c, k, t, run % 2);
        const auto without = runF(pixel, c, k, t, run % 2);
        EXPECT_EQ(with.count, without.count);
        EXPECT_EQ(with.ids, without.ids);
        EXPECT_EQ(with.state->agaa_joiningSamples, 0u);
    }
}

// Numbers, not the order of samples, decide.
TEST(ClusteringClasses, OrderDoesNotMatter) {
    Random random(23);
    for (unsigned run = 0; run < 500; ++run) {
        const unsigned n = 2 + random.below(31), c = 2 + random.below(3);
        auto pixel = randomPixel(random, n, 3, 10.0, 0.1);
        setClasses(random, pixel, 6);
        for (unsigned i = 0; i < n; ++i)
            pixel[i].keyB = (pixel[i].keyB & 0xFFFF0000u) | i; // content differs
        const auto first = runWithClasses<math_f::Clustering>(pixel, c, 0.1, 0.02, false);
        std::vector<unsigned> order(n);
        std::iota(order.begin(), order.end(), 0u);
        std::reverse(order.begin(), order.end());
        std::vector<Sample> reversed;
        for (const unsigned i : order)
            reversed.push_back(pixel[i]);
        const auto second = runWithClasses<math_f::Clustering>(reversed, c, 0.1, 0.02, false);
        ASSERT_EQ(first.count, second.count);
        for (unsigned i = 0; i < n; ++i)
            EXPECT_EQ(first.ids[i], second.ids[n - 1 - i]);
    }
}

} // namespace
} // namespace test_math
