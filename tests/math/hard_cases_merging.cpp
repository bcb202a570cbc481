// Hard cases 44 and 51 of docs/numerics.md: means of means, and the order in which surfaces merge.
#include <algorithm>
#include <numeric>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

using Spread = math_f::agaa_NormalSpread;

Spread mixed(const Spread& a, const Spread& b, float share) {
    const glm::vec3 mean = a.normal * (a.meanLength * (1 - share)) + b.normal * (b.meanLength * share);
    return math_f::agaa_mixSpreads(a, b, share, glm::normalize(mean));
}

// The spread of these normals, merged one by one, each by its share of those so far.
Spread merged(const glm::vec3* first, std::size_t count) {
    Spread s = math_f::agaa_noSpread(first[0]);
    for (std::size_t i = 1; i < count; ++i)
        s = mixed(s, math_f::agaa_noSpread(first[i]), 1.0f / float(i + 1));
    return s;
}

} // namespace

TEST(HardCase44_MeansOfUnequalCounts, MergedByCounts) {
    Random random(744);
    HardCaseFigures figures(44, "error of the mean of 32 normals, merged from two means", 1e-6);
    // Moments are kept in the plane across the mean only, so that merging loses a little of them.
    Worst moments("second moments of merged normals", 2e-3);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 middle = random.direction();
        glm::vec3 normals[32];
        glm::dvec3 sum(0);
        for (glm::vec3& n : normals) {
            n = glm::vec3(glm::normalize(middle + 0.5 * random.unit() * random.direction()));
            sum += glm::dvec3(n) / 32.0;
        }
        const std::size_t first = 1 + random.below(31);
        const Spread a = merged(normals, first), b = merged(normals + first, 32 - first);
        // All samples in one pass, in double.
        const auto error = [&](const Spread& s) {
            return glm::length(glm::dvec3(s.normal) * double(s.meanLength) - sum);
        };
        const Spread both = mixed(a, b, float(32 - first) / 32.0f);
        figures.add(error(mixed(a, b, 0.5f)), error(both));
        glm::vec3 t, u;
        math_f::agaa_spreadBasis(both.normal, t, u);
        glm::dvec3 truth(0);
        for (const glm::vec3& n : normals) {
            const double x = glm::dot(glm::dvec3(n), glm::dvec3(t)), y = glm::dot(glm::dvec3(n), glm::dvec3(u));
            truth += glm::dvec3(x * x, y * y, x * y) / 32.0;
        }
        for (int k = 0; k < 3; ++k)
            moments.absolute(double(both.moments[k]), truth[k]);
    }
}

TEST(HardCase51_OrderOfMerging, SortedFragmentsRepeat) {
    Random random(751);
    HardCaseFigures figures(51, "share of orders of arrival that change the surfaces of a pixel", 0.0);
    Share changedByArrival, changed;
    using Kept = math_f::KeptSurfaces;
    for (int pixel = 0; pixel < 20000; ++pixel) {
        std::vector<Kept::agaa_CoveredSurface> fragments(5 + random.below(5));
        for (auto& s : fragments) {
            s.mask = glm::uvec4(random.below(~0u) & random.below(~0u), random.below(~0u), 0u, 0u);
            s.mask.x |= 1u;
            const float depth = random.rangeF(0, 1);
            s.plane = {depth, random.rangeF(-0.1, 0.1), random.rangeF(-0.1, 0.1)};
            s.depths = {depth, 0.1f, 0.1f};
            s.normal = glm::vec3(random.hemisphere(0.3));
        }
        std::vector<std::size_t> order(fragments.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        const math_f::agaa_FacetFrame facets = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0.2f}};
        const auto inserted = [&](const std::vector<std::size_t>& ids) {
            Kept kept;
            for (std::size_t id : ids)
                kept.agaa_insertSurface(fragments[id],
                                        {4, 0.9f, 1e-6f, pixel % 2 ? AGAA_RULE_VISIBLE : AGAA_RULE_PAPER, facets});
            std::vector<std::array<unsigned, 2>> masks;
            for (unsigned i = 0; i < kept.agaa_keptCount; ++i)
                masks.push_back({kept.agaa_kept[i].mask.x, kept.agaa_kept[i].mask.y});
            return masks;
        };
        const auto sorted = [&](std::vector<std::size_t> ids) { // as src/shaders/coverage/list_order.glsl does
            const auto depthOf = [&](std::size_t id) {
                const glm::vec2 middle = math_f::agaa_coverageMiddle(fragments[id].mask, 64);
                return math_f::agaa_planeDepth(fragments[id].plane, middle);
            };
            std::sort(ids.begin(), ids.end(), [&](std::size_t a, std::size_t b) {
                return std::pair(depthOf(a), a) < std::pair(depthOf(b), b);
            });
            return ids;
        };
        const auto asSet = [](std::vector<std::array<unsigned, 2>> masks) {
            std::sort(masks.begin(), masks.end());
            return masks;
        };
        const auto first = inserted(order);
        const auto firstSorted = inserted(sorted(order));
        for (int again = 0; again < 5; ++again) {
            for (std::size_t k = order.size(); k > 1; --k)
                std::swap(order[k - 1], order[random.below(unsigned(k))]);
            changedByArrival.add(asSet(inserted(order)) != asSet(first));
            changed.add(inserted(sorted(order)) != firstSorted);
        }
    }
    figures.naive(changedByArrival.value());
    figures.ours(changed.value(), changed.inputs());
}
