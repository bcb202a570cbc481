// Planes that are clustered in place of samples (AGAA section 4.1).
#include "clustering_support.h"

using namespace test_math;

namespace {

struct Pixel {
    std::vector<Sample> samples;
    std::vector<unsigned> plane; // of each sample
};

// Planes that are further apart than the samples on each of them.
Pixel pixelOfPlanes(Random& random, unsigned n, unsigned planes) {
    std::vector<glm::vec3> normals;
    for (unsigned k = 0; k < planes; ++k)
        normals.push_back(makeSample({}, random.hemisphere(0.95), 0).normal);
    Pixel pixel;
    for (unsigned i = 0; i < n; ++i) {
        const unsigned k = i < planes ? i : random.below(planes);
        const glm::dvec3 m(normals[k]);
        const double x = random.range(-0.001, 0.001), y = random.range(-0.001, 0.001);
        const glm::dvec3 p(x, y, -5.0 - k * (0.5 + 0.3 * k) - (m.x * x + m.y * y) / m.z);
        Sample s = makeSample(p, m, i);
        s.normal = normals[k];
        s.keyB = (k + 1) << 16 | i;
        s.depthStep = 1e-6f;
        pixel.samples.push_back(s);
        pixel.plane.push_back(k);
    }
    return pixel;
}

RunResult<math_f::Clustering> run(const std::vector<Sample>& pixel, unsigned c, bool planes, bool classes = false) {
    return runClustering<math_f::Clustering>(pixel, c, 0.1, 0.3, false, classes, planes);
}

TEST(PlaneClustering, PlanesHaveTheAggregatesOfTheirSamples) {
    Random random(501);
    for (const unsigned n : {4u, 8u, 16u, 32u})
        for (const unsigned c : {2u, 3u, 4u})
            for (int i = 0; i < 500; ++i) {
                const Pixel pixel = pixelOfPlanes(random, n, 1 + random.below(c));
                const auto samples = run(pixel.samples, c, false), planes = run(pixel.samples, c, true);
                ASSERT_EQ(planes.count, samples.count);
                for (unsigned a = 0; a < n; ++a)
                    for (unsigned b = 0; b < a; ++b) {
                        ASSERT_EQ(planes.ids[a] == planes.ids[b], samples.ids[a] == samples.ids[b]);
                        ASSERT_EQ(planes.ids[a] == planes.ids[b], pixel.plane[a] == pixel.plane[b]);
                    }
            }
}

TEST(PlaneClustering, MorePlanesThanAggregatesAreGroupedAsSamples) {
    Random random(502);
    for (int i = 0; i < 2000; ++i) {
        const Pixel pixel = pixelOfPlanes(random, 16, 5);
        const auto samples = run(pixel.samples, 4, false), planes = run(pixel.samples, 4, true);
        ASSERT_EQ(planes.count, samples.count);
        ASSERT_EQ(planes.ids, samples.ids);
    }
}

TEST(PlaneClustering, ClassesOfOnePlaneStayApart) {
    Random random(503);
    for (int i = 0; i < 2000; ++i) {
        Pixel pixel = pixelOfPlanes(random, 8, 1);
        for (unsigned s = 0; s < 8; ++s)
            pixel.samples[s].keyB = (1 + s % 3) << 24 | 1u << 16 | s;
        const auto two = run(pixel.samples, 2, true, true), three = run(pixel.samples, 3, true, true);
        ASSERT_EQ(three.count, 3u);
        ASSERT_EQ(two.count, 2u);
        for (unsigned a = 0; a < 8; ++a)
            for (unsigned b = 0; b < a; ++b)
                ASSERT_EQ(three.ids[a] == three.ids[b], a % 3 == b % 3);
        // Two samples have the third class; they join.
        ASSERT_EQ(two.state->agaa_joiningSamples, run(pixel.samples, 2, false, true).state->agaa_joiningSamples);
        ASSERT_EQ(std::popcount(two.state->agaa_joiningSamples), 2);
        ASSERT_EQ(three.state->agaa_joiningSamples, 0u);
    }
}

// A slanted plane that is wider than aggregates may be is divided like its samples.
TEST(PlaneClustering, WidePlanesAreDividedAsSamples) {
    Random random(505);
    size_t divided = 0;
    for (int i = 0; i < 2000; ++i) {
        Pixel pixel = pixelOfPlanes(random, 16, 1);
        const glm::vec3 normal = pixel.samples[0].normal, along = glm::normalize(glm::vec3(normal.z, 0, -normal.x));
        for (Sample& s : pixel.samples) {
            s.position = glm::vec3(0, 0, -5) + along * float(random.range(-0.2, 0.2));
            s.keyA = std::bit_cast<unsigned>(s.position.z);
        }
        const auto samples = run(pixel.samples, 4, false), planes = run(pixel.samples, 4, true);
        ASSERT_EQ(planes.count > 1, samples.count > 1);
        divided += samples.count > 1;
    }
    EXPECT_GT(divided, 1500u);
}

// Also where samples are on one plane with the next, but not with the one after it.
TEST(PlaneClustering, TheOrderOfSamplesChangesNothing) {
    Random random(504);
    for (int i = 0; i < 4000; ++i) {
        Pixel pixel = pixelOfPlanes(random, 16, 3);
        if (i % 2)
            for (Sample& s : pixel.samples) {
                s.position.z += float(random.range(0, 0.02));
                s.depthStep = 0.002f;
                s.keyA = std::bit_cast<unsigned>(s.position.z);
            }
        std::vector<unsigned> order(16);
        for (unsigned s = 0; s < 16; ++s)
            order[s] = s;
        for (unsigned s = 15; s > 0; --s)
            std::swap(order[s], order[random.below(s + 1)]);
        std::vector<Sample> shuffled;
        for (const unsigned s : order)
            shuffled.push_back(pixel.samples[s]);
        const auto first = run(pixel.samples, 3, true), second = run(shuffled, 3, true);
        ASSERT_EQ(first.count, second.count);
        for (unsigned s = 0; s < 16; ++s)
            ASSERT_EQ(second.ids[s], first.ids[order[s]]);
    }
}

} // namespace
