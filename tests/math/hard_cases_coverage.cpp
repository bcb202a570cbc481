// Hard cases 47 to 50, 53 and 59 of docs/numerics.md: coverage of triangles and attributes inside them.
#include <algorithm>

#include "coverage_oracle.h"
#include "hard_case_figures.h"

using namespace test_math;

namespace {

// Samples at or left of the edge from a to b, by coordinates in the image.
glm::uvec4 leftOfEdge(const glm::vec2& a, const glm::vec2& b, const glm::vec2& centre, unsigned samples) {
    glm::uvec4 mask(0u);
    for (unsigned i = 0; i < samples; ++i) {
        const glm::vec2 p = centre + math_f::agaa_coveragePosition(i, samples), d = b - a, e = p - a;
        if (d.x * e.y - d.y * e.x >= 0.0f)
            mask[int(i >> 5)] |= 1u << (i & 31);
    }
    return mask;
}

// Weights of the vertices at a point of the image, by the quotients of areas.
template <class T, class V> glm::vec<3, T> weightsByAreas(const V& a, const V& b, const V& c, const V& p) {
    const auto twice = [](const V& u, const V& v, const V& w) {
        return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
    };
    const T inverse = T(1) / twice(a, b, c);
    return {twice(p, b, c) * inverse, twice(a, p, c) * inverse, twice(a, b, p) * inverse};
}

// How far a value leaves the range of those at the vertices, which is 1 wide.
template <class V> double overshoot(const V& weights) {
    double worst = 0;
    for (int k = 0; k < 3; ++k) {
        const double w = double(weights[k]);
        worst = std::isnan(w) ? w : std::max({worst, -w, w - 1});
        if (std::isnan(worst))
            break;
    }
    return worst;
}

// The image is 2 pixels per unit of ndc in each direction, so that pixels and ndc differ by the factor of the size.
constexpr float halfSize = 960;

math_f::agaa_Barycentrics weightsAt(const Vertices& t, const glm::vec2& point) {
    const auto clip = [](const glm::vec3& v) { return glm::vec3(v.x / halfSize - v.z, v.y / halfSize - v.z, v.z); };
    return math_f::agaa_barycentrics(clip(t[0]), clip(t[1]), clip(t[2]), point / halfSize - 1.0f, glm::vec2(halfSize));
}

} // namespace

TEST(HardCase47_SharedEdges, EachSampleIsOfOneTriangle) {
    Random random(547);
    HardCaseFigures figures(47, "samples of a shared edge that both triangles or none cover", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        // The edge passes through a sample, exactly in half of the cases.
        const glm::vec2 p = centre + math_f::agaa_coveragePosition(random.below(64), 64);
        glm::vec2 along(random.rangeF(-8, 8), random.rangeF(-8, 8));
        if (i % 2)
            along = {float(int(random.below(17)) - 8), float(int(random.below(17)) - 8)};
        if (std::abs(along.x) + std::abs(along.y) < 1)
            along = {1, 0};
        const glm::vec2 across(-along.y, along.x);
        const float reach = 4 + float(random.below(16));
        const glm::vec2 a = p - along * reach, b = p + along * (reach + 3), c = p + across * 64.0f,
                        d = p - across * 64.0f;
        const auto inPixels = [](const glm::vec2& v) { return glm::vec3(v, 1); };
        const glm::uvec4 first = mask({inPixels(a), inPixels(b), inPixels(c)}, centre, 64);
        const glm::uvec4 second = mask({inPixels(b), inPixels(a), inPixels(d)}, centre, 64);
        const glm::uvec4 all = math_f::agaa_allCoverage(64);
        // Each triangle tests its own edge, from its own first vertex.
        const glm::uvec4 left = leftOfEdge(a, b, centre, 64), right = leftOfEdge(b, a, centre, 64);
        const auto wrong = [&](const glm::uvec4& x, const glm::uvec4& y) {
            return math_f::agaa_coverageCount(x & y) + math_f::agaa_coverageCount((x | y) ^ all);
        };
        figures.add(wrong(left, right), wrong(first, second));
    }
}

TEST(HardCase48_TrianglesWithoutArea, AttributesAreThoseOfTheVertices) {
    Random random(1548);
    HardCaseFigures figures(48, "distance of an attribute from the vertices' values, in their range", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const auto dyadic = [&] { return double(int(random.below(2048)) - 1024) / 512; };
        const glm::dvec2 p(200.5 + dyadic(), 100.5 + dyadic()), d(dyadic() / 4, dyadic() / 4);
        Vertices t = {vertex(p.x, p.y), vertex(p.x + d.x, p.y + d.y), vertex(p.x + 4 * d.x, p.y + 4 * d.y)};
        if (i % 2) // a sliver of a sub-pixel of the rasteriser
            t[2] += glm::vec3(-d.y, d.x, 0) * (1.0f / 256);
        const glm::vec2 at = glm::vec2(200.5f, 100.5f) + glm::vec2(random.rangeF(-0.5, 0.5), random.rangeF(-0.5, 0.5));
        const auto flat = [](const glm::vec3& v) { return glm::vec2(v.x, v.y); };
        figures.add(overshoot(weightsByAreas<float>(flat(t[0]), flat(t[1]), flat(t[2]), at)),
                    overshoot(weightsAt(t, at).at));
    }
}

TEST(HardCase48_TrianglesWithoutArea, CoverNothing) {
    Random random(48);
    const glm::vec2 centre(200.5f, 100.5f);
    std::size_t bits = 0;
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 32u << random.below(3);
        // Multiples of 1/512: differences and products of these are exact.
        const auto dyadic = [&] { return double(int(random.below(2048)) - 1024) / 512; };
        const glm::dvec2 p(200.5 + dyadic(), 100.5 + dyadic()), d(dyadic() / 4, dyadic() / 4);
        const glm::vec3 a = vertex(p.x, p.y), b = vertex(p.x + d.x, p.y + d.y);
        const glm::vec3 c = vertex(p.x + 4 * d.x, p.y + 4 * d.y);
        for (const Vertices& t : {Vertices{a, b, c}, {b, a, c}, {c, b, a}, {a, a, b}, {a, b, a}, {b, a, a}, {a, a, a}})
            bits += math_f::agaa_coverageCount(mask(t, centre, n));
    }
    EXPECT_EQ(bits, 0u);
    for (const float bad : {infinityF(), -infinityF(), nanF()})
        for (int k = 0; k < 9; ++k) {
            Vertices t = {vertex(190, 90), vertex(220, 90), vertex(200, 120)};
            t[static_cast<std::size_t>(k / 3)][k % 3] = bad;
            EXPECT_EQ(mask(t, centre, 64), glm::uvec4(0)) << k;
        }
}

TEST(HardCase49_AttributesOutsideATriangle, WeightsAreClamped) {
    Random random(549);
    HardCaseFigures figures(49, "distance of an attribute from the vertices' values, in their range", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        // A conservative rasteriser evaluates attributes at the centre of every pixel that the triangle touches.
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        const double size = random.decades(0.01, 10);
        const glm::dvec2 corner = glm::dvec2(centre) + glm::dvec2(random.range(-0.5, 0.5), random.range(-0.5, 0.5));
        Vertices t;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 to = k == 0 ? glm::dvec2(0) : size * glm::dvec2(random.range(-1, 1), random.range(-1, 1));
            t[k] = vertex(corner.x + to.x, corner.y + to.y, random.decades(0.5, 2));
        }
        const auto divided = [](const glm::vec3& v) { return glm::vec2(v.x / v.z, v.y / v.z); };
        figures.add(overshoot(weightsByAreas<float>(divided(t[0]), divided(t[1]), divided(t[2]), centre)),
                    overshoot(weightsAt(t, centre).at));
    }
}

TEST(HardCase50_VerticesBehindTheEye, AgreesWithTheClippedTriangle) {
    Random random(50);
    HardCaseFigures figures(50, "wrong samples of a pixel, of 64", 1.0);
    std::size_t covered = 0, behind = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        Vertices t;
        for (glm::vec3& v : t) {
            const double w = random.range(-1, 1), size = random.decades(1, 1000);
            v = glm::vec3(glm::dvec3(double(centre.x) * w + random.range(-1, 1) * size,
                                     double(centre.y) * w + random.range(-1, 1) * size, w));
        }
        // Clipped to w > 0, as polygon in the plane of the image, tested by sides.
        Polygon polygon;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a(t[k]), b(t[(k + 1) % 3]);
            const double lowest = 1e-7;
            if (a.z >= lowest)
                polygon.push_back({a.x / a.z - double(centre.x), a.y / a.z - double(centre.y)});
            if ((a.z >= lowest) != (b.z >= lowest)) {
                const glm::dvec3 p = glm::mix(a, b, (lowest - a.z) / (b.z - a.z));
                polygon.push_back({p.x / p.z - double(centre.x), p.y / p.z - double(centre.y)});
            }
        }
        if (areaOf(polygon) < 0)
            std::reverse(polygon.begin(), polygon.end());
        glm::uvec4 expected(0);
        for (unsigned s = 0; s < 64 && polygon.size() > 2; ++s) {
            bool inside = true;
            const glm::dvec2 p = math_d::agaa_coveragePosition(s, 64);
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const glm::dvec2 d = polygon[(k + 1) % polygon.size()] - polygon[k], e = p - polygon[k];
                inside = inside && d.x * e.y - d.y * e.x > 0;
            }
            if (inside)
                expected[static_cast<int>(s >> 5)] |= 1u << (s & 31);
        }
        const glm::uvec4 found = mask(t, centre, 64);
        // Vertices that are divided by w come back mirrored.
        const auto divided = [](const glm::vec3& v) { return glm::vec2(v.x / v.z, v.y / v.z); };
        const glm::vec2 a = divided(t[0]), b = divided(t[1]), c = divided(t[2]);
        const glm::uvec4 left =
            leftOfEdge(a, b, centre, 64) & leftOfEdge(b, c, centre, 64) & leftOfEdge(c, a, centre, 64);
        const glm::uvec4 right =
            leftOfEdge(b, a, centre, 64) & leftOfEdge(c, b, centre, 64) & leftOfEdge(a, c, centre, 64);
        figures.add(differingBits(expected, left | right), differingBits(expected, found));
        const unsigned count = math_f::agaa_coverageCount(expected);
        covered += count != 0 && count != 64;
        behind += polygon.empty();
        if (polygon.empty()) {
            EXPECT_EQ(found, glm::uvec4(0));
        }
    }
    EXPECT_GT(covered, 1500u);
    EXPECT_GT(behind, 5000u);
}

TEST(HardCase53_CorrelatedAlphaMasks, TwoLayersOfEqualAlpha) {
    HardCaseFigures figures(53, "error of the mean coverage of two layers of equal alpha", 0.015);
    for (unsigned samples : {1u, 4u, 8u, 32u})
        for (float alpha : {0.1f, 0.25f, 0.5f, 0.75f, 0.9f}) {
            const unsigned groups = samples == 32 ? 4 : 1; // of a target with several texels per pixel
            double nested = 0, ours = 0, single = 0;
            const unsigned pixels = 5000;
            for (unsigned i = 0; i < pixels; ++i)
                for (unsigned group = 0; group < groups; ++group) {
                    const unsigned each = samples / groups;
                    unsigned masks[2];
                    for (unsigned layer = 0; layer < 2; ++layer) {
                        const unsigned hash = math_f::agaa_translucencyHash(i % 71, i / 71, 17 + layer, 0);
                        masks[layer] = math_f::agaa_translucentMask(alpha, each, group, groups, hash);
                        // Both geometry passes must take the same samples.
                        ASSERT_EQ(masks[layer], math_f::agaa_translucentMask(alpha, each, group, groups, hash));
                    }
                    single += glm::bitCount(masks[0]);
                    ours += glm::bitCount(masks[0] | masks[1]);
                    // Alpha-to-coverage takes the first samples of both.
                    nested += std::floor(double(alpha) * each + 0.5);
                }
            const double all = double(pixels) * samples, truth = 1 - (1 - double(alpha)) * (1 - double(alpha));
            EXPECT_NEAR(single / all, double(alpha), 0.02) << samples;
            figures.naive(std::abs(nested / all - truth));
            figures.ours(std::abs(ours / all - truth), pixels);
        }
}

TEST(HardCase59_ThinPrimitives, AttributesAtTheirSamples) {
    Random random(559);
    HardCaseFigures figures(59, "distance of an attribute from the vertices' values, in their range", 1e-5);
    for (int i = 0; i < 200000; ++i) {
        // A hair of an eighth of a pixel in width, up to 20 pixels long, that need not contain the centre.
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        const double angle = random.range(0, 6.283185307179586), length = random.decades(1, 20);
        const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
        const glm::dvec2 through = glm::dvec2(centre) + across * random.range(-0.5, 0.5);
        const glm::dvec2 first = through - along * length * random.unit(), last = first + along * length;
        const Vertices t = {vertex(first.x, first.y), vertex(first.x + across.x / 8, first.y + across.y / 8),
                            vertex(last.x, last.y)};
        const glm::uvec4 covered = mask(t, centre, 64);
        if (covered == glm::uvec4(0u))
            continue;
        const auto flat = [](const glm::vec3& v) { return glm::dvec2(v.x, v.y); };
        const auto weights = [&](const glm::dvec2& p) {
            return weightsByAreas<double>(flat(t[0]), flat(t[1]), flat(t[2]), p);
        };
        // The place alone keeps attributes inside, before weights are clamped.
        const glm::vec2 middle = math_f::agaa_coverageMiddle(covered, 64);
        figures.add(overshoot(weights(glm::dvec2(centre))),
                    overshoot(weights(glm::dvec2(centre) + glm::dvec2(middle))));
        ASSERT_LE(overshoot(weightsAt(t, centre + middle).at), 1e-6);
    }
}
