// Selection of surfaces: invariants over random pixels, float against double, and pixels whose surfaces are known.
#include "clustering_support.h"

using namespace test_math;

namespace {

constexpr double cosine = 0.9, width = 0.01, k = 0.1, t = 0.02;

template <class State> unsigned select(State& state, const std::vector<Sample>& pixel, unsigned limit) {
    using real = std::remove_reference_t<decltype(state.agaa_samplePosition[0].x)>;
    using vec = std::remove_reference_t<decltype(state.agaa_samplePosition[0])>;
    unsigned covered = 0;
    for (unsigned i = 0; i < pixel.size(); ++i) {
        if (!pixel[i].covered)
            continue;
        covered |= 1u << i;
        state.agaa_setSample(i, vec(pixel[i].position), vec(pixel[i].normal), real(pixel[i].depthStep), 0, 0);
    }
    return state.agaa_selectSurfaces(unsigned(pixel.size()), covered, limit, real(cosine), real(width),
                                     state.agaa_lengthsFor(real(k), real(t)));
}

unsigned coveredBy(const std::vector<Sample>& pixel) {
    unsigned covered = 0;
    for (unsigned i = 0; i < pixel.size(); ++i)
        covered |= unsigned(pixel[i].covered) << i;
    return covered;
}

} // namespace

TEST(MathSurfaces, EverySampleGoesToOneKeptSurface) {
    Random random(17);
    for (unsigned n : {1u, 4u, 8u, 16u, 32u})
        for (unsigned limit = 1; limit <= 6; ++limit)
            for (int round = 0; round < 400; ++round) {
                const auto pixel = randomPixel(random, n, 1 + random.below(8), random.decades(0.01, 10),
                                               round % 3 ? 0.0 : 0.3, round % 2 ? 1.0 : 0.6);
                math_f::Clustering state{};
                const unsigned kept = select(state, pixel, limit);
                ASSERT_LE(kept, limit);
                unsigned all = 0;
                for (unsigned s = 0; s < kept; ++s) {
                    const unsigned mask = state.agaa_surfaceSamples[s];
                    ASSERT_NE(mask, 0u);
                    ASSERT_EQ(all & mask, 0u);
                    ASSERT_TRUE(mask >> state.agaa_surfaceShaded[s] & 1u);
                    all |= mask;
                }
                ASSERT_EQ(all, coveredBy(pixel));
            }
}

// Two planes apart by ten tolerances, the larger first; a third of one sample is dropped at S = 2 and joins
// the nearer.
TEST(MathSurfaces, KnownPlanes) {
    std::vector<Sample> pixel;
    const glm::dvec3 up(0, 0, 1);
    for (unsigned i = 0; i < 8; ++i) {
        const double depth = i < 5 ? -2.0 : i < 7 ? -2.1 : -2.2;
        pixel.push_back(makeSample({0.001 * i, 0.0, depth}, up, i));
    }
    math_f::Clustering state{};
    ASSERT_EQ(select(state, pixel, 6), 3u);
    EXPECT_EQ(state.agaa_surfaceSamples[0], 0x1Fu);
    EXPECT_EQ(state.agaa_surfaceSamples[1], 0x60u);
    EXPECT_EQ(state.agaa_surfaceSamples[2], 0x80u);
    EXPECT_EQ(state.agaa_surfaceShaded[0], 2u); // the middle one
    ASSERT_EQ(select(state, pixel, 2), 2u);
    EXPECT_EQ(state.agaa_surfaceSamples[0], 0x1Fu);
    EXPECT_EQ(state.agaa_surfaceSamples[1], 0xE0u);
    EXPECT_NE(state.agaa_surfaceShaded[1], 7u) << "a sample that joined does not stand for the surface";
    ASSERT_EQ(select(state, pixel, 1), 1u);
    EXPECT_EQ(state.agaa_surfaceSamples[0], 0xFFu);
}

// A slanted wall is one surface at any slope; a step of more than the tolerance or a crease is not, whichever
// sample is first; one sample and none are.
TEST(MathSurfaces, AllSamplesOfOnePlane) {
    for (const double slope : {0.0, 1.0, 20.0}) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(slope, 0, 1));
        for (unsigned odd = 0; odd < 8; ++odd)
            for (const bool isStep : {true, false}) {
                math_f::Clustering flat{}, other{};
                for (unsigned i = 0; i < 8; ++i) {
                    const glm::dvec3 p(0.003 * i, 0.001 * (i % 3), -0.003 * i * slope);
                    const bool stands = i == odd;
                    const glm::dvec3 off = stands && isStep ? 1.5 * width * normal : glm::dvec3(0);
                    const glm::dvec3 crease = glm::dvec3(0.6, 0, 0.8) * (slope > 0.5 ? -1.0 : 1.0);
                    const glm::dvec3 n = stands && !isStep ? crease : normal;
                    flat.agaa_setSample(i, glm::vec3(p), glm::vec3(normal), 0, 0, 0);
                    other.agaa_setSample(i, glm::vec3(p + off), glm::vec3(n), 0, 0, 0);
                }
                EXPECT_TRUE(flat.agaa_areAllOneSurface(8, 0xFF, float(cosine), float(width)));
                EXPECT_FALSE(other.agaa_areAllOneSurface(8, 0xFF, float(cosine), float(width))) << odd;
                EXPECT_TRUE(other.agaa_areAllOneSurface(8, 0xFF & ~(1u << odd), float(cosine), float(width)));
                EXPECT_TRUE(other.agaa_areAllOneSurface(8, 1u << odd, float(cosine), float(width)));
                EXPECT_TRUE(other.agaa_areAllOneSurface(8, 0, float(cosine), float(width)));
            }
    }
}

// The largest surfaces are kept, whatever the order that they come in.
TEST(MathSurfaces, KeepsTheLargest) {
    const unsigned sizes[] = {1, 4, 2, 6, 3, 5, 2, 9};
    std::vector<Sample> pixel;
    for (unsigned s = 0; s < 8; ++s)
        for (unsigned i = 0; i < sizes[s]; ++i)
            pixel.push_back(makeSample({0.0001 * i, 0, -2.0 - s}, {0, 0, 1}, i));
    ASSERT_EQ(pixel.size(), 32u);
    math_f::Clustering state{};
    ASSERT_EQ(select(state, pixel, 3), 3u);
    const double expected[] = {-9.0, -5.0, -7.0}; // of nine, six and five samples
    for (unsigned s = 0; s < 3; ++s)
        EXPECT_NEAR(double(pixel[state.agaa_surfaceShaded[s]].position.z), expected[s], 1e-6);
}

TEST(MathSurfaces, FloatAgreesWithDouble) {
    Random random(23);
    int pixels = 0, different = 0;
    for (int round = 0; round < 4000; ++round) {
        const auto pixel =
            randomPixel(random, 8u << random.below(3), 1 + random.below(6), random.decades(0.01, 10), 0.0);
        math_f::Clustering f{};
        math_d::Clustering d{};
        const unsigned keptF = select(f, pixel, 4), keptD = select(d, pixel, 4);
        bool same = keptF == keptD;
        for (unsigned s = 0; same && s < keptF; ++s)
            same = f.agaa_surfaceSamples[s] == d.agaa_surfaceSamples[s];
        ++pixels;
        different += !same;
    }
    std::printf("  %d of %d pixels select other surfaces in float than in double\n", different, pixels);
    EXPECT_LE(different, pixels / 500); // samples at the very tolerance
}

// Positions far away, normals that are no numbers: any answer, but one.
TEST(MathSurfaces, ExtremeInputEnds) {
    Random random(29);
    for (int round = 0; round < 2000; ++round) {
        auto pixel = randomPixel(random, 32, 4, 1.0, 0.5);
        for (Sample& s : pixel) {
            s.position *= float(random.decades(1e-20, 1e18));
            if (random.below(8) == 0)
                s.normal = glm::vec3(std::nanf(""));
            if (random.below(8) == 0)
                s.position.z = -INFINITY;
        }
        math_f::Clustering state{};
        const unsigned kept = select(state, pixel, 6);
        ASSERT_GE(kept, 1u);
        unsigned all = 0;
        for (unsigned s = 0; s < kept; ++s) {
            ASSERT_LT(state.agaa_surfaceShaded[s], 32u);
            all |= state.agaa_surfaceSamples[s];
        }
        ASSERT_EQ(all, ~0u);
    }
}

TEST(MathSurfaces, RecordsComeBack) {
    Random random(31);
    for (unsigned n : {1u, 2u, 4u, 8u, 16u, 32u})
        for (int round = 0; round < 200; ++round) {
            const unsigned samples = n < 32 ? random.below(1u << n) : random.below(0xFFFFFFFFu);
            const unsigned shaded = random.below(n);
            const auto record = math_f::agaa_storedSurface(samples, shaded, n);
            EXPECT_EQ(math_f::agaa_recordSamples(record, n), samples);
            EXPECT_EQ(math_f::agaa_recordShaded(record, n), shaded);
            if (n <= 16) {
                EXPECT_EQ(record.y, 0u) << "one word is kept";
            }
        }
}
