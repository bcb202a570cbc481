// Pixels for the tests of the aggregate definition, and a straightforward second implementation of
// it in double precision.
#ifndef AGAA_TESTS_MATH_CLUSTERING_SUPPORT_H
#define AGAA_TESTS_MATH_CLUSTERING_SUPPORT_H

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <set>
#include <tuple>

#include "test_support.h"

namespace test_math {

// The values are floats, so that both precisions see the same pixel.
struct Sample {
    glm::vec3 position;
    glm::vec3 normal;
    unsigned keyA = 0, keyB = 0;
    float depthStep = 0;
    bool covered = true;

    std::pair<unsigned, unsigned> content() const { return {keyA, keyB}; }
};

inline Sample makeSample(const glm::dvec3& p, const glm::dvec3& n, unsigned subPixel) {
    Sample s;
    s.position = glm::vec3(p);
    // As in the prepass, normals have gone through a code and are unit vectors of it.
    const glm::uvec2 code = math_f::agaa_encodeHemiOct8(glm::vec3(n));
    s.normal = math_f::agaa_decodeHemiOct8(code);
    s.keyA = std::bit_cast<unsigned>(s.position.z);
    s.keyB = (code.x << 16) | (code.y << 8) | subPixel;
    return s;
}

// A pixel with some surfaces: planes at their own depths and orientations, of noisy normals.
inline std::vector<Sample> randomPixel(Random& random, unsigned n, unsigned surfaces, double depth, double noise,
                                       double coverage = 1.0) {
    std::vector<glm::dvec3> normals;
    std::vector<double> depths;
    for (unsigned i = 0; i < surfaces; ++i) {
        normals.push_back(random.hemisphere(0.1));
        depths.push_back(-2.0 - random.range(0, depth));
    }
    const double footprint = random.decades(2e-4, 1e-2);
    std::vector<Sample> pixel;
    for (unsigned i = 0; i < n; ++i) {
        const unsigned k = random.below(surfaces);
        const double x = footprint * random.range(-1, 1), y = footprint * random.range(-1, 1);
        const glm::dvec3& m = normals[k];
        const glm::dvec3 p(x, y, depths[k] - (m.x * x + m.y * y) / m.z);
        pixel.push_back(makeSample(p, glm::normalize(m + noise * random.direction()), i));
        pixel.back().covered = random.unit() < coverage;
    }
    return pixel;
}

template <class Clustering> struct RunResult {
    unsigned count = 0;
    std::vector<unsigned> ids;
    std::unique_ptr<Clustering> state;
};

template <class Clustering>
RunResult<Clustering> runClustering(const std::vector<Sample>& pixel, unsigned c, double k, double t,
                                    bool literal = false, bool hasClasses = false, bool hasPlanes = false) {
    using vec3 = std::decay_t<decltype(Clustering::agaa_samplePosition[0])>;
    using real = std::decay_t<decltype(vec3::x)>;
    RunResult<Clustering> r;
    r.state = std::make_unique<Clustering>();
    r.state->hasClasses = hasClasses;
    r.state->hasPlanes = hasPlanes;
    unsigned covered = 0;
    for (unsigned i = 0; i < pixel.size(); ++i) {
        r.state->agaa_setSample(i, vec3(pixel[i].position), vec3(pixel[i].normal), real(pixel[i].depthStep),
                                pixel[i].keyA, pixel[i].keyB);
        r.state->agaa_sampleAggregate[i] = 77;
        covered |= (pixel[i].covered ? 1u : 0u) << i;
    }
    r.count = r.state->agaa_defineAggregates(unsigned(pixel.size()), covered, c, static_cast<real>(k),
                                             static_cast<real>(t), literal ? 1u : 0u);
    r.ids.assign(r.state->agaa_sampleAggregate, r.state->agaa_sampleAggregate + pixel.size());
    return r;
}

inline auto runF(const std::vector<Sample>& pixel, unsigned c, double k, double t, bool literal = false) {
    return runClustering<math_f::Clustering>(pixel, c, k, t, literal);
}
inline auto runD(const std::vector<Sample>& pixel, unsigned c, double k, double t, bool literal = false) {
    return runClustering<math_d::Clustering>(pixel, c, k, t, literal);
}

// Equation 1 as printed, with the two limits of the SDK's version.
inline double equation1(const glm::dvec3& pa, const glm::dvec3& na, const glm::dvec3& pb, const glm::dvec3& nb,
                        double k) {
    const double q = std::min(glm::length(pa - pb) / k, 1000.0);
    return q * q + (1.0 - std::clamp(glm::dot(na, nb), -1.0, 1.0)) / 2.0;
}

inline double equation1(const Sample& a, const Sample& b, double k) {
    return equation1(glm::dvec3(a.position), glm::normalize(glm::dvec3(a.normal)), glm::dvec3(b.position),
                     glm::normalize(glm::dvec3(b.normal)), k);
}

// k of two samples, which may be a step of their depth off.
inline double pairLength(double k, double t, double stepA, double stepB) {
    return k + 2 * std::max(stepA, stepB) / std::sqrt(std::max(t, 1e-4));
}

inline double equation1(const Sample& a, const Sample& b, double k, double t) {
    return equation1(a, b, pairLength(k, t, double(a.depthStep), double(b.depthStep)));
}

// Steps of 1/4096, and at most 14 significant bits.
inline double quantisedDistance(double d) {
    const double q = std::floor(d * 4096.0 + 0.5);
    const double step = q < 16384.0 ? 1.0 : std::exp2(std::floor(std::log2(q)) - 13.0);
    return std::floor(q / step + 0.5) * step;
}

// Distance of sample i to the plain average of the covered samples; the mean normal is not
// normalised.
inline double distanceToAverage(const std::vector<Sample>& pixel, unsigned i, double k) {
    glm::dvec3 meanP(0), meanN(0);
    double count = 0.0;
    for (const Sample& s : pixel) {
        if (s.covered) {
            meanP += glm::dvec3(s.position);
            meanN += glm::normalize(glm::dvec3(s.normal));
            count += 1.0;
        }
    }
    meanP /= count;
    meanN /= count;
    const double q = std::min(glm::length(glm::dvec3(pixel[i].position) - meanP) / k, 1000.0);
    const glm::dvec3 dn = glm::normalize(glm::dvec3(pixel[i].normal)) - meanN;
    return q * q + glm::dot(dn, dn) / 4.0;
}

// Algorithm 1 with maximin seeds, written for clarity: whole passes over all pairs, no short way,
// no incremental distances, plain averages.
inline std::vector<unsigned> oracle(const std::vector<Sample>& pixel, unsigned c, double k, double t, unsigned& count,
                                    std::vector<unsigned>& seeds) {
    std::vector<unsigned> members;
    for (unsigned i = 0; i < pixel.size(); ++i) {
        if (pixel[i].covered)
            members.push_back(i);
    }
    std::vector<unsigned> ids(pixel.size(), 0);
    seeds.clear();
    count = 0;
    if (members.empty())
        return ids;
    double step = 0;
    for (unsigned i : members)
        step = std::max(step, double(pixel[i].depthStep));
    const double coarsest = pairLength(k, t, step, step);
    // The largest value wins, among equals the lowest content, then the lowest index.
    auto farthest = [&](auto&& value) {
        return *std::min_element(members.begin(), members.end(), [&](unsigned a, unsigned b) {
            return std::make_tuple(-value(a), pixel[a].content(), a) <
                   std::make_tuple(-value(b), pixel[b].content(), b);
        });
    };
    seeds = {farthest([&](unsigned i) { return quantisedDistance(distanceToAverage(pixel, i, coarsest)); })};
    auto nearest = [&](unsigned i) {
        double d = 1e300;
        for (unsigned s : seeds)
            d = std::min(d, quantisedDistance(equation1(pixel[i], pixel[s], k, t)));
        return d;
    };
    while (seeds.size() < c) {
        const unsigned next = farthest(nearest);
        if (nearest(next) <= quantisedDistance(t))
            break;
        seeds.push_back(next);
    }
    for (unsigned i : members) {
        std::vector<std::tuple<double, std::pair<unsigned, unsigned>, unsigned>> options;
        for (unsigned s = 0; s < seeds.size(); ++s) {
            options.emplace_back(quantisedDistance(equation1(pixel[i], pixel[seeds[s]], k, t)),
                                 pixel[seeds[s]].content(), s);
        }
        ids[i] = std::get<2>(*std::min_element(options.begin(), options.end()));
    }
    count = static_cast<unsigned>(seeds.size());
    return ids;
}

// Contents and ids, independent of the order of the samples.
inline std::multiset<std::tuple<unsigned, unsigned, unsigned>> partition(const std::vector<Sample>& pixel,
                                                                         const std::vector<unsigned>& ids) {
    std::multiset<std::tuple<unsigned, unsigned, unsigned>> set;
    for (unsigned i = 0; i < pixel.size(); ++i) {
        if (pixel[i].covered)
            set.emplace(pixel[i].keyA, pixel[i].keyB, ids[i]);
    }
    return set;
}

template <class T> void shuffle(std::vector<T>& v, Random& random) {
    for (std::size_t i = v.size(); i > 1; --i) {
        std::swap(v[i - 1], v[random.below(static_cast<unsigned>(i))]);
    }
}

// Largest squared distance (Equation 1) of a sample to the founder of its aggregate.
template <class Result> double radius(const std::vector<Sample>& pixel, const Result& r, double k) {
    double worst = 0.0;
    for (unsigned i = 0; i < pixel.size(); ++i) {
        if (pixel[i].covered) {
            worst = std::max(worst, equation1(pixel[i], pixel[r.state->agaa_seedSample[r.ids[i]]], k));
        }
    }
    return worst;
}

} // namespace test_math

#endif
