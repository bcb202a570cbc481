// Spreads of normals that merge: as if all normals were known, float against double, and what merging may lose.
#include <algorithm>

#include "test_support.h"

using namespace test_math;

namespace {

struct Float {
    using Vector = glm::vec3;
    using Spread = math_f::agaa_NormalSpread;
    using Moments = math_f::agaa_SecondMoments;
    static Spread none(const Vector& n) { return math_f::agaa_noSpread(n); }
    static Spread mix(const Spread& a, const Spread& b, double share, const Vector& n) {
        return math_f::agaa_mixSpreads(a, b, float(share), n);
    }
};

struct Double {
    using Vector = glm::dvec3;
    using Spread = math_d::agaa_NormalSpread;
    using Moments = math_d::agaa_SecondMoments;
    static Spread none(const Vector& n) { return math_d::agaa_noSpread(n); }
    static Spread mix(const Spread& a, const Spread& b, double share, const Vector& n) {
        return math_d::agaa_mixSpreads(a, b, share, n);
    }
};

// Normals of one weight each, merged one after the other about their mean direction.
template <class Real> typename Real::Spread merged(const std::vector<glm::dvec3>& normals) {
    using Vector = typename Real::Vector;
    typename Real::Spread s = Real::none(Vector(normals[0]));
    glm::dvec3 sum = normals[0];
    for (size_t i = 1; i < normals.size(); ++i) {
        sum += normals[i];
        const Vector direction = glm::length(sum) > 1e-9 ? Vector(glm::normalize(sum)) : s.normal;
        s = Real::mix(s, Real::none(Vector(normals[i])), 1.0 / double(i + 1), direction);
    }
    return s;
}

std::vector<glm::dvec3> cap(Random& random, double radius) {
    const glm::dvec3 middle = random.direction();
    std::vector<glm::dvec3> normals(2 + random.below(15));
    for (glm::dvec3& n : normals)
        n = glm::normalize(middle + radius * random.unit() * random.direction());
    return normals;
}

// Variances of all normals along and across their widest direction, and the length of their mean.
glm::dvec3 directly(const std::vector<glm::dvec3>& normals) {
    glm::dvec3 sum(0);
    math_d::agaa_SecondMoments m{glm::dvec3(0), glm::dvec3(0)};
    for (const glm::dvec3& n : normals) {
        sum += n;
        math_d::agaa_addSecondMoments(m, 1.0 / double(normals.size()), n);
    }
    glm::dvec3 axis;
    double along = 0, across = 0;
    math_d::agaa_spreadAlpha2(m, glm::normalize(sum), 1.0, 0.0, 0, 0.0, axis, along, across);
    return {along, across, glm::length(sum) / double(normals.size())};
}

} // namespace

TEST(NormalSpread, TwoNormalsMergeAsTheirMoments) {
    Random random(311);
    Worst length("length of the mean of two normals", 1e-12);
    Worst along("alpha2 along, absolute", 1e-12);
    for (int i = 0; i < 20000; ++i) {
        std::vector<glm::dvec3> normals = {random.direction(), random.direction()};
        if (glm::length(normals[0] + normals[1]) < 1.0) // lobes of normals that point all ways go over into the widest
            continue;
        const auto s = merged<Double>(normals);
        const glm::dvec3 expected = directly(normals);
        glm::dvec3 axis;
        double widest = 0, narrowest = 0;
        math_d::agaa_widenBySpread(s, 0.0, 0, axis, widest, narrowest);
        length.absolute(s.meanLength, expected.z);
        along.absolute(widest, expected.x);
    }
}

// Each merge forgets how normals lean to one side, which is of the third order.
TEST(NormalSpread, ManyNormalsMergeNearlyAsTheirMoments) {
    Random random(312);
    Worst length("length of the mean of a cap's normals", 1e-12);
    Worst narrow("alpha2 along, caps of radius .1, by itself", 0.0015);
    Worst wide("alpha2 along, caps of radius .5, by itself", 0.045);
    for (int i = 0; i < 20000; ++i) {
        const bool isWide = i % 2;
        const std::vector<glm::dvec3> normals = cap(random, isWide ? 0.5 : 0.1);
        const auto s = merged<Double>(normals);
        const glm::dvec3 expected = directly(normals);
        glm::dvec3 axis;
        double along = 0, across = 0;
        math_d::agaa_widenBySpread(s, 0.0, 0, axis, along, across);
        length.absolute(s.meanLength, expected.z);
        (isWide ? wide : narrow).relative(along, expected.x, 1e-5);
        ASSERT_GE(along, across);
    }
}

TEST(NormalSpread, FloatAgainstDouble) {
    Random random(313);
    Worst moments("moments, absolute", 5e-7);
    Worst length("length of the mean", 8e-7);
    for (int i = 0; i < 20000; ++i) {
        const std::vector<glm::dvec3> normals = cap(random, random.decades(1e-4, 1.5));
        std::vector<glm::dvec3> rounded; // as both take them
        for (const glm::dvec3& n : normals)
            rounded.push_back(glm::dvec3(glm::vec3(n)));
        const auto f = merged<Float>(rounded);
        const auto d = merged<Double>(rounded);
        // Axes of nearby normals are nearby, but for those where the basis turns.
        if (std::abs(d.normal.z) < 0.01)
            continue;
        for (int c = 0; c < 3; ++c)
            moments.absolute(double(f.moments[c]), d.moments[c]);
        length.absolute(double(f.meanLength), d.meanLength);
    }
}

// Opposite normals have the mean that one of them is given, and the widest lobe.
TEST(NormalSpread, OppositeNormalsHaveTheWidestLobe) {
    Random random(314);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n(random.direction());
        const auto s = math_f::agaa_mixSpreads(math_f::agaa_noSpread(n), math_f::agaa_noSpread(-n), 0.5f, n);
        EXPECT_LT(s.meanLength, 1e-6f);
        glm::vec3 axis;
        float along = 0, across = 0;
        math_f::agaa_widenBySpread(s, 1e-3f, 0, axis, along, across);
        EXPECT_GT(across, 0.999f);
        EXPECT_GT(along, 0.999f);
    }
}

// Against normals that are taken at the places themselves.
TEST(NormalSpread, ChangeOverThePixelIsThatOfItsNormals) {
    Random random(315);
    Worst along("alpha2 along of a curved primitive, by itself", 0.04);
    Worst length("length of the mean normal of a curved primitive", 2e-4);
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 n = random.direction();
        const double steep = random.range(0.01, 0.3);
        const glm::dvec3 dx = steep * random.unit() * glm::normalize(glm::cross(n, random.direction()));
        const glm::dvec3 dy = steep * glm::normalize(glm::cross(n, random.direction()));
        std::vector<glm::dvec2> places(2 + random.below(30));
        glm::dvec2 middle(0);
        for (glm::dvec2& p : places) {
            p = {random.range(-0.5, 0.5), random.range(-0.5, 0.5)};
            middle += p / double(places.size());
        }
        glm::dvec3 products(0);
        std::vector<glm::dvec3> normals;
        for (const glm::dvec2& p : places) {
            const glm::dvec2 at = p - middle;
            products += glm::dvec3(at.x * at.x, at.y * at.y, at.x * at.y) / double(places.size());
            normals.push_back(glm::normalize(n + at.x * dx + at.y * dy));
        }
        const auto s = math_d::agaa_spreadOfChange(n, dx, dy, products);
        glm::dvec3 axis;
        double widest = 0, narrowest = 0;
        math_d::agaa_widenBySpread(s, 0.0, 0, axis, widest, narrowest);
        const glm::dvec3 expected = directly(normals);
        along.relative(widest, expected.x, 1e-4);
        length.absolute(s.meanLength, expected.z);
    }
}

TEST(NormalSpread, StaysFiniteOnExtremes) {
    Random random(316);
    for (const float v : extremeFloats())
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 n(random.direction()), change = v * glm::vec3(random.direction());
            // Normals change by a unit a pixel at most (common/curvature.glsl).
            const glm::vec3 bounded = glm::length(change) <= 1.0f ? change : glm::vec3(random.direction());
            const auto s =
                math_f::agaa_spreadOfChange(n, bounded, -bounded, glm::vec3(0.25f, 0.25f, random.rangeF(-0.25, 0.25)));
            const auto m = math_f::agaa_mixSpreads(s, math_f::agaa_noSpread(n), random.rangeF(0, 1), n);
            glm::vec3 axis;
            float along = 0, across = 0;
            math_f::agaa_widenBySpread(m, v, i % 2, axis, along, across);
            ASSERT_TRUE(allFinite(m.moments) && std::isfinite(m.meanLength) && allFinite(axis)) << v;
            ASSERT_TRUE(along >= across && across > 0.0f && along <= 1.0f) << v << ": " << along << ", " << across;
        }
}
