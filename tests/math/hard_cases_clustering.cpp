// Hard cases 17 to 24, 30 and 42 of docs/numerics.md: the aggregate definition.
#include <cfloat>

#include "clustering_support.h"
#include "hard_case_figures.h"

using namespace test_math;

namespace {

const double kK = 0.1, kT = 0.02;

} // namespace

TEST(HardCase17_GeometryAtTheFarPlane, CountsByItsCoverageBit) {
    Random random(317);
    HardCaseFigures figures(17, "covered samples of a pixel that are lost", 0.0);
    for (int i = 0; i < 100000; ++i) {
        // Distant geometry of a forward projection, whose depth rounds to the value that was cleared, behind near
        // geometry.
        const float p22 = i % 2 ? -1.0f : -10000.0f / 9999.9f;
        std::vector<Sample> pixel;
        std::vector<bool> isFar;
        unsigned lostByDepth = 0, lost = 0;
        for (unsigned s = 0; s < 8; ++s) {
            isFar.push_back(random.below(2));
            const float depth = isFar[s] ? 1.0f : random.rangeF(0.5, 0.99);
            const float z = math_f::agaa_viewZFromDepth(depth, p22, 0.1f * p22, 0);
            pixel.push_back(makeSample({0, 0, double(z)}, {0, 0, 1}, s));
            pixel.back().covered = random.below(4) != 0;
            lostByDepth += pixel.back().covered && depth == 1.0f;
        }
        const auto r = runF(pixel, 4, kK, kT);
        // A far sample is kept if it has an aggregate, without near samples.
        for (unsigned s = 0; s < 8; ++s) {
            bool isKept = r.ids[s] < r.count;
            for (unsigned other = 0; other < 8; ++other)
                isKept = isKept && (!pixel[other].covered || isFar[other] == isFar[s] || r.ids[other] != r.ids[s]);
            lost += pixel[s].covered && isFar[s] && !isKept;
        }
        figures.add(lostByDepth, lost);
    }
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
    HardCaseFigures figures(20, "share of a wall's pixels that are split", 0.0);
    Share split, splitWithout;
    for (double distance : {10.0, 100.0, 410.0, 1000.0, 5000.0, 10000.0}) {
        Random random(320);
        for (int i = 0; i < 17000; ++i) {
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
            split.add(runF(pixel, 4, kK, kT).count > 1);
            splitWithout.add(runF(unaware, 4, kK, kT).count > 1);
        }
    }
    figures.naive(splitWithout.value());
    figures.ours(split.value(), split.inputs());
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
    // The step does not widen the tolerance of one surface: the rails alone are two.
    EXPECT_FALSE(r.state->agaa_areAllOneSurface(8, 0xFC, 0.9f, 0.01f));
}

TEST(HardCase21_CharacteristicLength, DistancesAreFinite) {
    Random random(1321);
    HardCaseFigures figures(21, "relative error of Equation 1, which ends at 1e6", 2e-6);
    const float listed[] = {0.0f, -1.0f, FLT_TRUE_MIN, 1e-30f, 1e30f, infinityF(), nanF()};
    for (int i = 0; i < 100000; ++i) {
        const float k = i % 4 == 0 ? listed[i / 4 % 7] : float(random.decades(1e-12, 1e12));
        const glm::vec3 a(random.direction() * random.decades(1e-6, 1e12)), na(random.direction());
        const glm::vec3 b = i % 5 == 0 ? a : a + glm::vec3(random.direction() * random.decades(1e-6, 1e6));
        const glm::vec3 nb(random.direction());
        math_f::Clustering f;
        math_d::Clustering d;
        const double reference = d.agaa_sampleDistance(glm::dvec3(a), glm::dvec3(b), glm::dvec3(na), glm::dvec3(nb),
                                                       d.agaa_inverseK2(double(k)));
        const glm::vec3 q = (a - b) / k;
        figures.relative(double(glm::dot(q, q) + (1.0f - glm::dot(na, nb)) * 0.5f),
                         double(f.agaa_sampleDistance(a, b, na, nb, f.agaa_inverseK2(k))), reference);
    }
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

// Algorithm 1 with sums and comparisons of floats as they come, and the lower index where values are equal.
static std::vector<unsigned> definedByFloats(const std::vector<Sample>& pixel, unsigned c) {
    const auto distance = [](const glm::vec3& p, const glm::vec3& n, const Sample& b) {
        const glm::vec3 q = (p - b.position) / float(kK);
        return glm::dot(q, q) + (1.0f - glm::dot(n, b.normal)) * 0.5f;
    };
    glm::vec3 meanP(0), meanN(0);
    for (const Sample& s : pixel) {
        meanP += s.position / float(pixel.size());
        meanN += s.normal / float(pixel.size());
    }
    std::vector<unsigned> ids(pixel.size(), 0);
    std::vector<float> nearest(pixel.size());
    for (std::size_t i = 0; i < pixel.size(); ++i)
        nearest[i] = distance(meanP, meanN, pixel[i]);
    for (unsigned id = 0; id < c; ++id) {
        const auto seed = std::size_t(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
        if (id > 0 && nearest[seed] <= float(kT))
            break;
        for (std::size_t i = 0; i < pixel.size(); ++i) {
            const float d = distance(pixel[seed].position, pixel[seed].normal, pixel[i]);
            if (id == 0 || d < nearest[i]) {
                nearest[i] = d;
                ids[i] = id;
            }
        }
    }
    return ids;
}

// The sizes of the aggregates, which do not depend on their numbers.
static std::multiset<std::vector<std::pair<unsigned, unsigned>>> groupsOf(const std::vector<Sample>& pixel,
                                                                          const std::vector<unsigned>& ids) {
    std::vector<std::vector<std::pair<unsigned, unsigned>>> groups(8);
    for (std::size_t i = 0; i < pixel.size(); ++i)
        groups[ids[i]].push_back(pixel[i].content());
    for (auto& group : groups)
        std::sort(group.begin(), group.end());
    return {groups.begin(), groups.end()};
}

TEST(HardCase23_Ties, PermutationsLeaveThePartitionUnchanged) {
    Random random(323);
    HardCaseFigures figures(23, "share of orders of samples that change the aggregates", 0.0);
    Share changed, changedByFloats;
    for (unsigned n : {2u, 4u, 8u, 16u, 32u}) {
        for (unsigned c = 1; c <= 4; ++c) {
            for (int i = 0; i < 1250; ++i) {
                auto pixel = randomPixel(random, n, 1 + random.below(5), random.decades(0.01, 5), i % 2 ? 0.0 : 0.3);
                if (i % 4 == 0) {
                    // Coarse positions: many exactly equal distances, decided by content.
                    for (Sample& s : pixel) {
                        s.position = glm::round(s.position * 4.0f) / 4.0f;
                        s.keyA = std::bit_cast<unsigned>(s.position.z);
                    }
                }
                if (i % 4 == 1) {
                    // Mirrored pairs, both of which are equally far from the average.
                    for (std::size_t s = 0; s + 1 < pixel.size(); s += 2) {
                        const glm::dvec3 m(-1, 1, 1), p(pixel[s].position), normal(pixel[s].normal);
                        pixel[s + 1] = makeSample(p * m, normal * m, unsigned(s + 1));
                    }
                }
                for (std::size_t s = 0; s < pixel.size(); s += 2) { // both of a pair
                    pixel[s].covered = i % 3 == 0 || random.unit() < 0.7;
                    if (s + 1 < pixel.size())
                        pixel[s + 1].covered = pixel[s].covered;
                }
                const auto first = runF(pixel, c, kK, kT);
                const auto expected = partition(pixel, first.ids);
                const auto byFloats = groupsOf(pixel, definedByFloats(pixel, c));
                for (int p = 0; p < 4; ++p) {
                    shuffle(pixel, random);
                    const auto again = runF(pixel, c, kK, kT);
                    changed.add(again.count != first.count || partition(pixel, again.ids) != expected);
                    changedByFloats.add(groupsOf(pixel, definedByFloats(pixel, c)) != byFloats);
                }
            }
        }
    }
    figures.naive(changedByFloats.value());
    figures.ours(changed.value(), changed.inputs());
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

TEST(HardCase24_ThresholdHysteresis, FloatsNearTheThresholdFlip) {
    // Two surfaces that turn away from each other, slowly enough that the angle's cosine in floats goes back and forth.
    Random random(1324);
    HardCaseFigures figures(24, "changes of the number of aggregates in one sweep", 1.0);
    for (int sweep = 0; sweep < 100; ++sweep) {
        const glm::dvec3 n = random.direction(), axis = glm::normalize(glm::cross(n, random.direction()));
        const double t = random.decades(5e-4, 0.05);
        const auto turned = [&](double distance, int i) { // near the angle whose distance is this one
            const double angle = std::acos(1 - 2 * distance) * (1 - 1e-3 + 2e-6 * i);
            return glm::vec3(n * std::cos(angle) + axis * std::sin(angle));
        };
        // Quantised distances exceed the threshold from half a step on.
        const double quantised = (std::floor(t * 4096 + 0.5) + 0.5) / 4096;
        unsigned flips = 0, flipsOfCosine = 0, previous = 1;
        bool wasApart = false;
        for (int i = 0; i < 1000; ++i) {
            math_f::Clustering c{};
            for (unsigned s = 0; s < 2; ++s)
                c.agaa_setSample(s, {0, 0, -5}, s == 0 ? glm::vec3(n) : turned(quantised, i), 0, 7, s);
            const unsigned count = c.agaa_defineAggregates(2, 3, 2, float(kK), float(t), 0);
            flips += count != previous;
            previous = count;
            const bool isApart = (1.0f - glm::dot(glm::vec3(n), turned(t, i))) * 0.5f > float(t);
            flipsOfCosine += isApart != wasApart;
            wasApart = isApart;
        }
        EXPECT_EQ(flips, 1u) << t;
        figures.naive(flipsOfCosine);
        figures.ours(flips, 1000);
    }
}

// The jump of the colour at the threshold is what aggregation costs there; the default threshold bounds it.
TEST(HardCase24_ThresholdHysteresis, JumpOfTheColour) {
    Random random(2324);
    Worst jump("colour of one aggregate against two at the threshold, in units of the brightest", 0.04);
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 n = random.direction(), axis = glm::normalize(glm::cross(n, random.direction()));
        const double angle = std::acos(1 - 2 * kT);
        const glm::vec3 l(random.direction());
        math_f::agaa_Surface s{};
        s.diffuse = glm::vec3(1);
        s.alpha2 = s.alpha2Along = 1;
        glm::vec3 apart(0);
        const glm::vec3 normals[] = {glm::vec3(n), glm::vec3(n * std::cos(angle) + axis * std::sin(angle))};
        s.meanLength = 1;
        for (const glm::vec3& m : normals) {
            s.normal = m;
            apart += 0.5f * math_f::agaa_shade(s, l, l, 1, 1, 0);
        }
        math_f::agaa_meanDirection((normals[0] + normals[1]) * 0.5f, normals[0], s.normal, s.meanLength);
        jump.add(std::abs(double(math_f::agaa_shade(s, l, l, 1, 1, 0).x - apart.x)) * 3.14159265);
    }
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

TEST(HardCase42_CorrelatedLightAndMaterial, TwoAggregatesHaveNoError) {
    // A lit green surface beside a shadowed red one: the mean of the products is not the product of the means.
    Random random(342);
    HardCaseFigures figures(42, "error of the reflected light, in units of the brightest", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 2u << random.below(5);
        std::vector<Sample> pixel;
        std::vector<unsigned> surface;
        const glm::dvec3 normals[] = {random.hemisphere(0.2), random.hemisphere(0.2)};
        for (unsigned s = 0; s < n; ++s) {
            surface.push_back(s < 2 ? s : random.below(2));
            pixel.push_back(makeSample({0, 0, surface[s] ? -9.0 : -3.0}, normals[surface[s]], s));
        }
        const glm::vec2 albedo[] = {{1, 0}, {0, 1}}; // green, red
        const float lit[] = {1, 0};
        glm::vec2 error[2];
        for (const unsigned c : {1u, 2u}) {
            const auto r = runF(pixel, c, kK, kT);
            glm::vec2 sum(0), truth(0);
            for (unsigned a = 0; a < r.count; ++a) {
                glm::vec2 meanAlbedo(0);
                float meanLight = 0, count = 0;
                for (unsigned s = 0; s < n; ++s)
                    if (r.ids[s] == a) {
                        meanAlbedo += albedo[surface[s]];
                        meanLight += lit[surface[s]];
                        count += 1;
                    }
                sum += meanAlbedo / count * (meanLight / count) * (count / float(n));
            }
            for (unsigned s = 0; s < n; ++s)
                truth += albedo[surface[s]] * lit[surface[s]] / float(n);
            error[c - 1] = glm::abs(sum - truth);
        }
        figures.add(double(std::max(error[0].x, error[0].y)), double(std::max(error[1].x, error[1].y)));
    }
}
