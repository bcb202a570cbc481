// Aggregate definition: invariants over random pixels, and agreement with a second implementation.
#include "clustering_support.h"

using namespace test_math;

namespace {

const unsigned kSampleCounts[] = {1, 2, 4, 8, 16, 32};
const double kK = 0.1, kT = 0.02;

} // namespace

TEST(MathClustering, InvariantsForAllCounts) {
    Random random(301);
    for (unsigned n : kSampleCounts) {
        for (unsigned c = 1; c <= 4; ++c) {
            std::array<unsigned, 9> histogram{};
            for (int i = 0; i < 1500; ++i) {
                const auto pixel = randomPixel(random, n, 1 + random.below(5), random.decades(0.01, 10),
                                               i % 4 ? random.range(0, 0.5) : 0.0, i % 3 ? 1.0 : 0.6);
                unsigned covered = 0;
                for (const Sample& s : pixel)
                    covered += s.covered;
                const auto r = runF(pixel, c, kK, kT);
                ASSERT_LE(r.count, c);
                ASSERT_EQ(r.count == 0, covered == 0);
                if (covered == 1 || c == 1) {
                    ASSERT_EQ(r.count, covered ? 1u : 0u);
                }
                std::vector<unsigned> sizes(8, 0);
                for (unsigned s = 0; s < n; ++s) {
                    if (!pixel[s].covered) {
                        ASSERT_EQ(r.ids[s], 0u);
                    } else {
                        ASSERT_LT(r.ids[s], r.count);
                        ++sizes[r.ids[s]];
                    }
                }
                for (unsigned a = 0; a < r.count; ++a) {
                    ASSERT_GT(sizes[a], 0u) << "empty aggregate " << a;
                }
                for (unsigned a = 0; r.count > 1 && a < r.count; ++a) {
                    // Founders are members, and farther than t from each other.
                    const unsigned seed = r.state->agaa_seedSample[a];
                    ASSERT_TRUE(pixel[seed].covered);
                    ASSERT_EQ(r.ids[seed], a);
                    for (unsigned b = 0; b < a; ++b) {
                        ASSERT_GT(equation1(pixel[seed], pixel[r.state->agaa_seedSample[b]], kK), kT - 1.0 / 4096);
                    }
                }
                if (r.count > 1) {
                    // Each sample is at its nearest founder, up to a step of the quantisation.
                    for (unsigned s = 0; s < n; ++s) {
                        if (!pixel[s].covered)
                            continue;
                        const double own = equation1(pixel[s], pixel[r.state->agaa_seedSample[r.ids[s]]], kK);
                        for (unsigned a = 0; a < r.count; ++a) {
                            ASSERT_LE(own, equation1(pixel[s], pixel[r.state->agaa_seedSample[a]], kK) * (1 + 1.3e-4) +
                                               1.0 / 4096);
                        }
                    }
                }
                if (r.count > 0 && r.count < c) {
                    // Fewer than allowed only if nobody is farther than t from all founders.
                    if (r.count > 1) {
                        ASSERT_LE(radius(pixel, r, kK), kT + 1.0 / 4096);
                    }
                }
                ++histogram[r.count];
            }
            if (n >= 8) {
                for (unsigned a = 1; a <= c; ++a)
                    EXPECT_GT(histogram[a], 0u) << n << " " << c;
            }
        }
    }
}

TEST(MathClustering, EqualsTheOracleInDouble) {
    Random random(302);
    int several = 0, ties = 0, total = 0;
    for (unsigned n : kSampleCounts) {
        for (unsigned c : {1u, 2u, 3u, 4u, 8u}) {
            for (int i = 0; i < 600; ++i) {
                auto pixel = randomPixel(random, n, 1 + random.below(5), random.decades(0.01, 50), random.range(0, 0.4),
                                         i % 3 ? 1.0 : 0.5);
                for (Sample& s : pixel)
                    s.depthStep = i % 2 ? float(random.decades(1e-4, 1)) : 0.0f;
                const double k = random.decades(0.02, 1), t = random.decades(4e-4, 0.25);
                unsigned count = 0;
                std::vector<unsigned> seeds;
                const auto expected = oracle(pixel, c, k, t, count, seeds);
                const auto r = runD(pixel, c, k, t);
                ++total;
                several += count > 1;
                if (r.ids == expected) {
                    ASSERT_EQ(r.count, count) << n << " " << c << " " << i;
                    continue;
                }
                // The average in integers of 2^-20 of the pixel's extent may break an exact tie of
                // the first seed (of two samples it always is one); nothing else may differ.
                ++ties;
                ASSERT_NE(r.state->agaa_seedSample[0], seeds[0]) << n << " " << c << " " << i;
                double step = 0;
                for (const Sample& s : pixel)
                    step = std::max(step, s.covered ? double(s.depthStep) : 0.0);
                const double coarsest = pairLength(k, t, step, step);
                const double own = distanceToAverage(pixel, r.state->agaa_seedSample[0], coarsest);
                const double best = distanceToAverage(pixel, seeds[0], coarsest);
                ASSERT_NEAR(own, best, 1.0 / 4096 + 2e-4 * best) << n << " " << c << " " << i;
            }
        }
    }
    std::printf("[ measured ] first seed differs by a tie in %d of %d pixels\n", ties, total);
    EXPECT_LE(ties, total / 200);
    EXPECT_GT(several, 5000);
}

TEST(MathClustering, FloatAgainstDouble) {
    Random random(303);
    int different = 0, counts = 0;
    double worst = 0.0;
    const int total = 30000;
    for (int i = 0; i < total; ++i) {
        const auto pixel = randomPixel(random, 8u << random.below(3), 1 + random.below(5), random.decades(0.01, 10),
                                       random.range(0, 0.4));
        const unsigned c = 2 + random.below(3);
        const auto f = runF(pixel, c, kK, kT);
        const auto d = runD(pixel, c, kK, kT);
        different += f.ids != d.ids;
        counts += f.count != d.count;
        if (f.ids != d.ids && f.count > 1 && d.count > 1) {
            // Where rounding decides otherwise, the aggregates must be equally tight.
            worst = std::max(worst, radius(pixel, f, kK) / std::max(radius(pixel, d, kK), 1e-3));
        }
    }
    std::printf("[ measured ] float and double partitions differ in %d of %d pixels, counts in %d, "
                "radius grows at most %.3f times\n",
                different, total, counts, worst);
    EXPECT_LE(different, total / 200);
    EXPECT_LE(counts, total / 1000);
}

TEST(MathClustering, OneSurfaceIsOneAggregateAndTheShortWayIsExact) {
    // Spreads around the threshold: both ways are taken, with the result of the full algorithm.
    Random random(304);
    int shortWay = 0, full = 0;
    for (int i = 0; i < 40000; ++i) {
        const unsigned n = kSampleCounts[random.below(6)];
        const auto pixel = randomPixel(random, n, 1, 0.0, random.decades(1e-3, 0.4), 0.9);
        const double t = random.decades(1e-3, 0.1), k = random.decades(0.05, 1);
        const auto r = runF(pixel, 4, k, t);
        // What the full algorithm compares, from its own functions.
        unsigned largest = 0;
        glm::vec3 lo(1e30f), hi(-1e30f), loN(2), hiN(-2);
        const auto lengths = r.state->agaa_lengthsFor(static_cast<float>(k), static_cast<float>(t));
        const float inverse = r.state->agaa_inverseK2(static_cast<float>(k));
        for (unsigned a = 0; a < n; ++a) {
            if (!pixel[a].covered)
                continue;
            lo = glm::min(lo, pixel[a].position);
            hi = glm::max(hi, pixel[a].position);
            loN = glm::min(loN, pixel[a].normal);
            hiN = glm::max(hiN, pixel[a].normal);
            for (unsigned b = 0; b < n; ++b) {
                if (!pixel[b].covered)
                    continue;
                largest = std::max(largest, r.state->agaa_quantiseDistance(r.state->agaa_pairDistance(a, b, lengths)));
            }
        }
        if (r.count == 0)
            continue;
        const unsigned threshold = r.state->agaa_quantiseDistance(static_cast<float>(t));
        const unsigned bound =
            r.state->agaa_quantiseDistance(r.state->agaa_sampleDistance(lo, hi, loN, hiN, inverse) * 1.00001f);
        ASSERT_GE(bound, largest);
        if (bound <= threshold) {
            ++shortWay;
            ASSERT_EQ(r.count, 1u);
            ASSERT_LE(largest, threshold);
        } else {
            ++full;
        }
        // In every case one aggregate follows if no pair is farther apart than t.
        if (largest <= threshold) {
            ASSERT_EQ(r.count, 1u);
        }
    }
    std::printf("[ measured ] short way in %d pixels, full in %d\n", shortWay, full);
    EXPECT_GT(shortWay, 3000);
    EXPECT_GT(full, 3000);
}

TEST(MathClustering, FindsSeparatedClustersExactly) {
    Random random(305);
    for (unsigned clusters = 2; clusters <= 4; ++clusters) {
        for (unsigned n : {8u, 16u, 32u}) {
            for (int i = 0; i < 500; ++i) {
                std::vector<Sample> pixel;
                std::vector<unsigned> truth;
                for (unsigned s = 0; s < n; ++s) {
                    const unsigned k = s < clusters ? s : random.below(clusters);
                    const glm::dvec3 p(random.range(-0.01, 0.01), random.range(-0.01, 0.01),
                                       -5.0 - k * (0.5 + 0.3 * k));
                    pixel.push_back(makeSample(p, random.hemisphere(0.95), s));
                    truth.push_back(k);
                }
                const auto r = runF(pixel, clusters, kK, 0.3);
                ASSERT_EQ(r.count, clusters);
                for (unsigned a = 0; a < n; ++a) {
                    for (unsigned b = 0; b < a; ++b) {
                        ASSERT_EQ(truth[a] == truth[b], r.ids[a] == r.ids[b]);
                    }
                }
            }
        }
    }
}

TEST(MathClustering, SeparatesNormalsAtOnePlace) {
    std::vector<Sample> pixel;
    for (unsigned s = 0; s < 8; ++s) {
        const glm::dvec3 n = s % 2 ? glm::dvec3(0.7, 0, 0.714) : glm::dvec3(-0.7, 0, 0.714);
        pixel.push_back(makeSample({0.0, 0.0, -3.0}, n, s));
    }
    const auto r = runF(pixel, 4, kK, kT);
    EXPECT_EQ(r.count, 2u);
    for (unsigned s = 0; s < 8; ++s)
        EXPECT_EQ(r.ids[s], r.ids[s % 2]);
}

TEST(MathClustering, MaximinBeatsTheLiteralRule) {
    Random random(306);
    for (unsigned c : {3u, 4u}) {
        double maximinCount = 0, literalCount = 0, maximinSum = 0, literalSum = 0;
        const int total = 5000;
        for (int i = 0; i < total; ++i) {
            const auto pixel = randomPixel(random, 16, 3 + random.below(3), 3.0, 0.1);
            const auto m = runF(pixel, c, kK, kT);
            const auto l = runF(pixel, c, kK, kT, true);
            maximinCount += m.count;
            literalCount += l.count;
            for (const auto* r : {&m, &l}) {
                double sum = 0;
                for (unsigned s = 0; s < 16; ++s) {
                    sum += std::sqrt(equation1(pixel[s], pixel[r->state->agaa_seedSample[r->ids[s]]], kK));
                }
                (r == &m ? maximinSum : literalSum) += sum / 16;
            }
        }
        std::printf("[ measured ] c=%u: aggregates %.2f (maximin) %.2f (literal), mean distance to the "
                    "founder %.3f and %.3f\n",
                    c, maximinCount / total, literalCount / total, maximinSum / total, literalSum / total);
        EXPECT_GT(maximinCount, 1.2 * literalCount);
        EXPECT_LT(maximinSum, 0.7 * literalSum);
    }
    // Two seeds or fewer: there is no rule (e) to differ by.
    for (int i = 0; i < 500; ++i) {
        const auto pixel = randomPixel(random, 16, 4, 3.0, 0.2);
        ASSERT_EQ(runF(pixel, 2, kK, kT).ids, runF(pixel, 2, kK, kT, true).ids);
    }
}

TEST(MathClustering, UncoveredSamplesHaveNoInfluence) {
    Random random(307);
    for (int i = 0; i < 2000; ++i) {
        auto pixel = randomPixel(random, 16, 3, 2.0, 0.2, 0.6);
        const auto before = runF(pixel, 3, kK, kT);
        for (Sample& s : pixel) {
            if (!s.covered) {
                s.position = {nanF(), infinityF(), -1e30f};
                s.normal = {nanF(), 0, 0};
                s.keyA = s.keyB = 0;
            }
        }
        const auto after = runF(pixel, 3, kK, kT);
        ASSERT_EQ(before.ids, after.ids);
        ASSERT_EQ(before.count, after.count);
    }
}

TEST(MathClustering, BitsAboveTheSampleCountAreIgnored) {
    auto state = std::make_unique<math_f::Clustering>();
    for (unsigned i = 0; i < 32; ++i) {
        state->agaa_samplePosition[i] = {0, 0, -1.0f - static_cast<float>(i)};
        state->agaa_sampleNormal[i] = {0, 0, 1};
        state->agaa_sampleKeyA[i] = state->agaa_sampleKeyB[i] = i;
    }
    EXPECT_EQ(state->agaa_defineAggregates(1, 0xFFFFFFFFu, 4, 0.1f, 0.02f, 0), 1u);
    EXPECT_EQ(state->agaa_defineAggregates(2, 0xFFFFFFFCu, 4, 0.1f, 0.02f, 0), 0u);
    EXPECT_EQ(state->agaa_defineAggregates(0, 0xFFFFFFFFu, 4, 0.1f, 0.02f, 0), 0u);
    EXPECT_EQ(state->agaa_defineAggregates(32, 0xFFFFFFFFu, 8, 0.1f, 0.02f, 0), 8u);
    // Counts outside the limits are clamped, not followed out of the arrays.
    EXPECT_EQ(state->agaa_defineAggregates(99, 0xFFFFFFFFu, 99, 0.1f, 0.02f, 0), 8u);
    EXPECT_EQ(state->agaa_defineAggregates(32, 0xFFFFFFFFu, 0, 0.1f, 0.02f, 0), 1u);
}
