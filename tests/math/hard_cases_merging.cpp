// Hard cases 44, 51 and 67 of docs/numerics.md: means of means, and the order in which surfaces merge.
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

using Kept = math_f::KeptSurfaces;
using Fragments = std::vector<Kept::agaa_CoveredSurface>;
using Order = std::vector<std::size_t>;

Kept::agaa_CoveredSurface randomFragment(Random& random) {
    Kept::agaa_CoveredSurface s;
    s.mask = glm::uvec4(random.below(~0u) & random.below(~0u), random.below(~0u), 0u, 0u);
    s.mask.x |= 1u;
    const float depth = random.rangeF(0, 1);
    s.plane = {depth, random.rangeF(-0.1, 0.1), random.rangeF(-0.1, 0.1)};
    s.depths = {depth, 0.1f, 0.1f};
    s.normal = glm::vec3(random.hemisphere(0.3));
    return s;
}

Order firstOrder(std::size_t count) {
    Order order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    return order;
}

void shuffle(Order& order, Random& random) {
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[random.below(unsigned(k))]);
}

Kept inserted(const Fragments& fragments, const Order& order, unsigned rule) {
    const math_f::agaa_FacetFrame facets = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0.2f}};
    Kept kept;
    for (const std::size_t i : order)
        kept.agaa_insertSurface(fragments[i], {4, 0.9f, 1e-6f, rule, facets, false});
    return kept;
}

// Returns the fragments, in their order of arrival, as the list of a pixel is sorted.
// ids       Of the fragments, which increase with the draws.
// byDepth   Fragments have depths. Otherwise the draws decide the order (AGAA_COVERAGE_DRAW_ORDER).
Order sorted(const Fragments& fragments, Order arrival, const Order& ids, bool byDepth) {
    constexpr unsigned wordsPerFragment = AGAA_FRAGMENT_MASK_AT + 2;
    math_f::FragmentLists lists;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Kept::agaa_CoveredSurface& s = fragments[i];
        const math_f::agaa_DepthPlane plane = {s.plane.x, {s.plane.y, s.plane.z}, Kept().agaa_rangeOf(s)};
        const float depth = math_f::agaa_depthAt(plane, math_f::agaa_coverageMiddle(s.mask, 64));
        // As coverage/depth_order.glsl; depths grow with the distance here.
        const unsigned key = byDepth ? math_f::agaa_orderedBits(depth) : 0;
        lists.words.insert(lists.words.end(), {unsigned(ids[i]), 0, key, s.mask.x, s.mask.y});
    }
    std::sort(arrival.begin(), arrival.end(), [&](std::size_t a, std::size_t b) {
        const unsigned record = unsigned(a) * wordsPerFragment, other = unsigned(b) * wordsPerFragment;
        const unsigned word = lists.agaa_orderingWord(record, other, wordsPerFragment);
        return lists.words[record + word] < lists.words[other + word];
    });
    return arrival;
}

// Returns the mean normal of the pixel's samples.
glm::dvec3 meanNormal(Kept kept) {
    glm::dvec3 sum(0);
    double samples = 0;
    for (unsigned i = 0; i < kept.agaa_keptCount; ++i) {
        const double count = math_f::agaa_coverageCount(kept.agaa_visibleOf(i, kept.agaa_keptCount));
        sum += count * glm::dvec3(kept.agaa_keptAt(i).normal);
        samples += count;
    }
    return sum / samples;
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
    for (int pixel = 0; pixel < 20000; ++pixel) {
        Fragments fragments(5 + random.below(5));
        for (auto& s : fragments)
            s = randomFragment(random);
        const unsigned rule = pixel % 2 ? AGAA_RULE_VISIBLE : AGAA_RULE_PAPER;
        const auto masksOf = [&](const Order& order) {
            const Kept kept = inserted(fragments, order, rule);
            std::vector<std::array<unsigned, 2>> masks;
            for (unsigned i = 0; i < kept.agaa_keptCount; ++i)
                masks.push_back({kept.agaa_kept[i].mask.x, kept.agaa_kept[i].mask.y});
            return masks;
        };
        const auto asSet = [](std::vector<std::array<unsigned, 2>> masks) {
            std::sort(masks.begin(), masks.end());
            return masks;
        };
        const Order ids = firstOrder(fragments.size());
        Order arrival = ids;
        const auto first = masksOf(arrival), firstSorted = masksOf(sorted(fragments, arrival, ids, true));
        for (int again = 0; again < 5; ++again) {
            shuffle(arrival, random);
            changedByArrival.add(asSet(masksOf(arrival)) != asSet(first));
            changed.add(masksOf(sorted(fragments, arrival, ids, true)) != firstSorted);
        }
    }
    figures.naive(changedByArrival.value());
    figures.ours(changed.value(), changed.inputs());
}

TEST(HardCase67_OrderOfDraws, ChangesNoPixel) {
    Random random(67);
    HardCaseFigures figures(67, "change of a pixel's mean normal by another order of the draws", 0.0);
    for (int pixel = 0; pixel < 20000; ++pixel) {
        Fragments fragments(2 + random.below(8));
        const unsigned samples = pixel % 3 == 0 ? 1 : 1 + random.below(32);
        for (std::size_t f = 0; f < fragments.size(); ++f) {
            auto& s = fragments[f];
            s = randomFragment(random);
            do { // masks of equal depths must differ
                s.mask = glm::uvec4(0u);
                for (unsigned i = 0; i < samples; ++i)
                    s.mask[int(random.below(2))] |= 1u << random.below(32);
            } while (std::any_of(fragments.begin(), fragments.begin() + std::ptrdiff_t(f),
                                 [&](const auto& other) { return other.mask == s.mask; }));
            if (pixel % 4 < 2) { // a surface that faces the eye, so that only the coverage differs
                s.plane = {0.5f, 0, 0};
                s.depths = {0.5f, 0, 0};
            }
        }
        const unsigned rule = pixel % 2 ? AGAA_RULE_VISIBLE : AGAA_RULE_PAPER;
        const auto mean = [&](const Order& draws, bool byDepth) {
            Order ids(draws.size());
            for (std::size_t i = 0; i < draws.size(); ++i)
                ids[draws[i]] = i;
            return meanNormal(inserted(fragments, sorted(fragments, draws, ids, byDepth), rule));
        };
        Order draws = firstOrder(fragments.size());
        const glm::dvec3 byDraws = mean(draws, false), byDepth = mean(draws, true);
        for (int again = 0; again < 5; ++again) {
            shuffle(draws, random);
            figures.add(glm::length(mean(draws, false) - byDraws), glm::length(mean(draws, true) - byDepth));
        }
    }
}
