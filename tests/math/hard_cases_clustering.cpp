// Hard cases of the aggregate definition; the numbers are those of the list of numerically hard
// cases.
#include <cfloat>

#include "clustering_support.h"

using namespace test_math;

namespace {

const double kK = 0.1, kT = 0.02;

} // namespace

TEST(HardCase17_GeometryAtTheFarPlane, CountsByItsCoverageBit) {
    // Depth exactly at the far value, finite and infinite far plane: covered is covered.
    for (float p22 : {-1.0f, -10.0f / 9.9f}) {
        std::vector<Sample> pixel;
        for (unsigned i = 0; i < 4; ++i) {
            const float z = math_f::agaa_viewZFromDepth(i == 0 ? 1.0f : 0.5f, p22, 0.1f * p22, 0);
            pixel.push_back(makeSample({0, 0, double(z)}, {0, 0, 1}, i));
        }
        const auto r = runF(pixel, 2, kK, kT);
        EXPECT_EQ(r.count, 2u);
        EXPECT_NE(r.ids[0], r.ids[1]);
        EXPECT_EQ(r.ids[1], r.ids[3]);
    }
}

TEST(HardCase18_ZeroCoverage, NoAggregate) {
    Random random(318);
    for (unsigned n : {1u, 8u, 32u}) {
        auto pixel = randomPixel(random, n, 2, 1.0, 0.1, -1.0);
        const auto r = runF(pixel, 4, kK, kT);
        EXPECT_EQ(r.count, 0u);
        for (unsigned id : r.ids)
            EXPECT_EQ(id, 0u);
    }
}

TEST(HardCase19_OneSample, OneAggregate) {
    Random random(319);
    for (unsigned s = 0; s < 32; ++s) {
        auto pixel = randomPixel(random, 32, 3, 1.0, 0.1, -1.0);
        pixel[s].covered = true;
        for (unsigned c = 1; c <= 8; ++c) {
            const auto r = runF(pixel, c, kK, kT);
            EXPECT_EQ(r.count, 1u);
            EXPECT_EQ(r.ids[s], 0u);
        }
    }
}

TEST(HardCase20_DepthQuantum, CoplanarWallStaysOneAggregate) {
    // A wall facing the camera through a telephoto lens, seen by a forward 24-bit depth buffer:
    // only the rounding of the depth separates the samples.
    const double n = 0.1, f = 20000.0, steps = 16777215.0;
    const double p22 = f / (n - f), p32 = n * p22;
    int splitWithout = 0;
    for (double distance : {10.0, 100.0, 410.0, 1000.0, 5000.0, 10000.0}) {
        Random random(320);
        for (int i = 0; i < 300; ++i) {
            std::vector<Sample> pixel;
            std::vector<Sample> unaware;
            for (unsigned s = 0; s < 8; ++s) {
                const double z = -distance * (1.0 + 1e-8 * random.range(-1, 1));
                const double d = (p22 * z + p32) / -z;
                // Up or down to the next code, as a rasteriser's plane equation may.
                const double stored = std::floor(d * steps + random.unit()) / steps;
                const double seen = math_d::agaa_viewZFromDepth(stored, p22, p32, 0);
                const double step = math_d::agaa_depthQuantum(seen, stored, p22, p32, 0, 1 / steps);
                pixel.push_back(makeSample({0, 0, seen}, {0, 0, 1}, s));
                unaware.push_back(pixel.back());
                pixel.back().depthStep = float(step);
            }
            ASSERT_EQ(runF(pixel, 4, kK, kT).count, 1u) << distance;
            splitWithout += runF(unaware, 4, kK, kT).count > 1;
        }
    }
    EXPECT_GT(splitWithout, 500);
    // Near the camera, and for k scaled by distance, the step changes nothing that matters.
    math_f::Clustering c;
    const auto lengths = c.agaa_lengthsFor(0.1f, 0.02f);
    EXPECT_NEAR(1 / std::sqrt(c.agaa_pairInverseK2(lengths, 6e-7f, 6e-7f)), 0.1f, 1e-5f);
    EXPECT_EQ(math_f::agaa_characteristicLength(0.1f, 0.0f, 1.0f), 0.1f);
    EXPECT_NEAR(math_f::agaa_characteristicLength(0.1f, 0.01f, 100.0f), 1.0f, 1e-5f);
}

TEST(HardCase20_DepthQuantum, AFarSampleLeavesNearOnesApart) {
    // A backdrop at 1 km, whose step of depth is 0.6 m, behind rails at 5 m and 6 m, whose steps are microns.
    const double near = 0.1, f = 2000.0, steps = 16777216.0;
    const double p22 = f / (near - f), p32 = near * p22;
    std::vector<Sample> pixel;
    for (const double distance : {1000.0, 1000.0, 5.0, 5.0, 5.0, 6.0, 6.0, 6.0}) {
        const double stored = (-p22 * distance + p32) / distance;
        pixel.push_back(makeSample({0, 0, -distance}, {0, 0, 1}, unsigned(pixel.size())));
        pixel.back().depthStep = float(math_d::agaa_depthQuantum(-distance, stored, p22, p32, 0, 1 / steps));
    }
    EXPECT_GT(pixel[0].depthStep, 0.5f);
    const double k = math_d::agaa_characteristicLength(0.0, 0.03, 5.0);
    const auto r = runF(pixel, 4, k, kT);
    EXPECT_EQ(r.count, 3u);
    for (unsigned a = 0; a < pixel.size(); ++a)
        for (unsigned b = 0; b < a; ++b)
            EXPECT_EQ(r.ids[a] == r.ids[b], pixel[a].position.z == pixel[b].position.z) << a << ' ' << b;
    // Nor does it widen what counts as one surface: the rails alone are two.
    EXPECT_FALSE(r.state->agaa_areAllOneSurface(8, 0xFC, 0.9f, 0.01f));
}

TEST(HardCase21_CharacteristicLength, AnyValueOfK) {
    Random random(321);
    for (double k : {0.0, -1.0, double(FLT_TRUE_MIN), 1e-30, 1e-3, 1e30, double(infinityF()), double(nanF())}) {
        for (int i = 0; i < 300; ++i) {
            const auto pixel = randomPixel(random, 16, 4, i % 2 ? 1e6 : 3.0, 0.2);
            const auto r = runF(pixel, 4, k, kT);
            ASSERT_GE(r.count, 1u);
            ASSERT_LE(r.count, 4u);
            for (unsigned id : r.ids)
                ASSERT_LT(id, r.count);
        }
    }
    // Infinite k: normals only.
    std::vector<Sample> pixel;
    for (unsigned s = 0; s < 8; ++s) {
        pixel.push_back(makeSample({0, 0, -1.0 - s * 1e5}, s % 2 ? glm::dvec3(0.8, 0, 0.6) : glm::dvec3(0, 0, 1), s));
    }
    const auto r = runF(pixel, 4, double(infinityF()), kT);
    EXPECT_EQ(r.count, 2u);
    for (unsigned s = 0; s < 8; ++s)
        EXPECT_EQ(r.ids[s], r.ids[s % 2]);
    // Distances far beyond what a square fits into a float.
    math_f::Clustering c;
    const float d = c.agaa_sampleDistance({1e30f, 0, 0}, {-1e30f, 0, 0}, {0, 0, 1}, {0, 0, 1}, c.agaa_inverseK2(0.0f));
    EXPECT_EQ(d, 1e6f);
    EXPECT_LE(c.agaa_quantiseDistance(infinityF()), 4096004096u);
}

TEST(HardCase22_LargeCoordinates, TranslationChangesNothing) {
    Random random(322);
    int different = 0;
    for (int i = 0; i < 3000; ++i) {
        auto pixel = randomPixel(random, 16, 1 + random.below(4), 4.0, 0.2);
        // On a grid that the translation does not round: what remains is the algorithm's own.
        for (Sample& s : pixel) {
            s.position = glm::round(s.position * 4096.0f) / 4096.0f;
        }
        const auto before = runF(pixel, 3, kK, kT);
        for (Sample& s : pixel)
            s.position += glm::vec3(512.0f, -1024.0f, 256.0f);
        const auto after = runF(pixel, 3, kK, kT);
        different += before.ids != after.ids;
        ASSERT_EQ(before.count, after.count);
    }
    EXPECT_EQ(different, 0);
}

TEST(HardCase23_Ties, PermutationsLeaveThePartitionUnchanged) {
    Random random(323);
    for (unsigned n : {2u, 4u, 8u, 16u, 32u}) {
        for (unsigned c = 1; c <= 4; ++c) {
            for (int i = 0; i < 300; ++i) {
                auto pixel = randomPixel(random, n, 1 + random.below(5), random.decades(0.01, 5), i % 2 ? 0.0 : 0.3,
                                         i % 3 ? 1.0 : 0.7);
                if (i % 4 == 0) {
                    // Coarse positions: many exactly equal distances, decided by content.
                    for (Sample& s : pixel) {
                        s.position = glm::round(s.position * 4.0f) / 4.0f;
                        s.keyA = std::bit_cast<unsigned>(s.position.z);
                    }
                }
                const auto first = runF(pixel, c, kK, kT);
                const auto expected = partition(pixel, first.ids);
                for (int p = 0; p < 4; ++p) {
                    shuffle(pixel, random);
                    const auto again = runF(pixel, c, kK, kT);
                    ASSERT_EQ(again.count, first.count);
                    ASSERT_EQ(partition(pixel, again.ids), expected) << n << " " << c << " " << i;
                }
            }
        }
    }
}

TEST(HardCase23_Ties, MirroredPairs) {
    // Samples come in pairs that mirror each other, all equally far from the average.
    for (unsigned pairs : {1u, 2u, 4u, 8u, 16u}) {
        std::vector<Sample> pixel;
        for (unsigned p = 0; p < pairs; ++p) {
            const double y = 0.001 * p;
            for (double side : {-1.0, 1.0}) {
                pixel.push_back(makeSample({side * 0.5, y, -4.0}, glm::normalize(glm::dvec3(side * 0.5, 0, 1)),
                                           unsigned(pixel.size())));
            }
        }
        const auto r = runF(pixel, 2, kK, kT);
        ASSERT_EQ(r.count, 2u);
        for (unsigned s = 0; s < pixel.size(); ++s) {
            EXPECT_EQ(r.ids[s], r.ids[s % 2]) << pairs;
        }
        EXPECT_NE(r.ids[0], r.ids[1]);
        // Mirrored as a whole the sets are the mirrored sets, whatever their numbers.
        auto mirrored = pixel;
        for (Sample& s : mirrored) {
            s.position.x = -s.position.x;
            s.normal.x = -s.normal.x;
        }
        const auto m = runF(mirrored, 2, kK, kT);
        for (unsigned a = 0; a < pixel.size(); ++a) {
            for (unsigned b = 0; b < a; ++b) {
                EXPECT_EQ(r.ids[a] == r.ids[b], m.ids[a] == m.ids[b]);
            }
        }
    }
}

TEST(HardCase23_Ties, EqualContentStaysTogether) {
    Random random(324);
    for (int i = 0; i < 2000; ++i) {
        auto pixel = randomPixel(random, 8, 3, 2.0, 0.2);
        const auto copies = pixel;
        pixel.insert(pixel.end(), copies.begin(), copies.end());
        const auto r = runF(pixel, 4, kK, kT);
        for (unsigned s = 0; s < 8; ++s)
            ASSERT_EQ(r.ids[s], r.ids[s + 8]);
    }
}

TEST(HardCase24_ThresholdHysteresis, OneJumpAtTheThreshold) {
    // A step of growing height: one aggregate below t, two above, one change at the place that
    // Equation 1 gives. The colour jumps there by the error of aggregating, once and not back.
    int changes = 0;
    unsigned previous = 1;
    double at = 0.0;
    for (int i = 0; i <= 4000; ++i) {
        const double height = i * 1e-5;
        std::vector<Sample> pixel;
        for (unsigned s = 0; s < 8; ++s) {
            pixel.push_back(makeSample({0, 0, -1.0 - (s % 2 ? height : 0.0)}, {0, 0, 1}, s));
        }
        const auto r = runF(pixel, 4, kK, kT);
        ASSERT_LE(r.count, 2u);
        if (r.count != previous) {
            ++changes;
            at = height;
        }
        previous = r.count;
    }
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(previous, 2u);
    EXPECT_NEAR(at, kK * std::sqrt(kT), 1e-4);
}

TEST(HardCase30_ThirtyTwoSamplesFourAggregates, IdsSurviveThePacking) {
    Random random(330);
    for (int i = 0; i < 2000; ++i) {
        const auto pixel = randomPixel(random, 32, 4, 5.0, 0.1);
        const auto r = runF(pixel, 4, kK, kT);
        glm::uvec2 planes(0u);
        for (unsigned s = 0; s < 32; ++s)
            math_f::agaa_putAggregateId(planes, s, r.ids[s]);
        const glm::uvec2 stored = math_f::agaa_storedPlanes(planes, 32, 4);
        const glm::uvec2 loaded = math_f::agaa_loadedPlanes(stored, 32, 4);
        for (unsigned s = 0; s < 32; ++s) {
            ASSERT_EQ(math_f::agaa_samplesOfAggregate(loaded, r.ids[s]) >> s & 1u, 1u);
        }
    }
}
