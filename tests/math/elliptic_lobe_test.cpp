// Elliptic lobes: what normals' moments say of them, float against double, and that they are GGX where the moments are
// round.
#include <algorithm>

#include "test_support.h"

using namespace test_math;

namespace {

template <class Moments, class Vector> void add(Moments& moments, double weight, const Vector& n) {
    if constexpr (std::is_same_v<Vector, glm::vec3>)
        math_f::agaa_addSecondMoments(moments, float(weight), n);
    else
        math_d::agaa_addSecondMoments(moments, weight, n);
}

struct Spread {
    glm::dvec3 axis;
    double along = 0, across = 0;
};

struct Normals {
    std::vector<glm::vec3> each;
    glm::vec3 mean{0};
    float length = 0; // of the mean

    explicit Normals(std::vector<glm::vec3> normals) : each(std::move(normals)) {
        glm::dvec3 sum(0);
        for (const glm::vec3& n : each)
            sum += glm::dvec3(n);
        mean = glm::vec3(glm::normalize(sum));
        length = float(glm::length(sum) / double(each.size()));
    }

    Spread inFloat(float alpha2, unsigned sggx, float bound) const {
        math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
        for (const glm::vec3& n : each)
            add(m, 1.0 / double(each.size()), n);
        glm::vec3 axis;
        float along = 0, across = 0;
        math_f::agaa_spreadAlpha2(m, mean, length, alpha2, sggx, bound, axis, along, across);
        return {glm::dvec3(axis), double(along), double(across)};
    }

    Spread inDouble(double alpha2, unsigned sggx, double bound) const {
        math_d::agaa_SecondMoments m{glm::dvec3(0), glm::dvec3(0)};
        for (const glm::vec3& n : each)
            add(m, 1.0 / double(each.size()), glm::dvec3(n));
        Spread s;
        math_d::agaa_spreadAlpha2(m, glm::normalize(glm::dvec3(mean)), double(length), alpha2, sggx, bound, s.axis,
                                  s.along, s.across);
        return s;
    }
};

// Around `middle`, up to `wide` along a random tangent and `narrow` across it.
Normals scattered(Random& random, double wide, double narrow, glm::dvec3* acrossSpread = nullptr) {
    const glm::dvec3 middle = random.direction();
    const glm::dvec3 t = glm::normalize(glm::cross(middle, random.direction()));
    const glm::dvec3 b = glm::cross(middle, t);
    if (acrossSpread)
        *acrossSpread = b;
    std::vector<glm::vec3> normals;
    const unsigned count = 2 + random.below(31);
    for (unsigned i = 0; i < count; ++i)
        normals.emplace_back(
            glm::normalize(middle + random.range(-wide, wide) * t + random.range(-narrow, narrow) * b));
    return Normals(std::move(normals));
}

template <class Surface, class Vector>
Surface surface(const Vector& normal, double alpha2, double along, const Vector& axis) {
    using Real = decltype(Surface::alpha2);
    Surface s{};
    s.specular = Vector(1);
    s.normal = normal;
    s.meanLength = Real(1);
    s.alpha2 = Real(alpha2);
    s.alpha2Along = Real(along);
    s.axis = axis;
    return s;
}

} // namespace

TEST(EllipticLobe, SpreadFloatAgainstDouble) {
    Random random(201);
    Worst along("spreadAlpha2, along: absolute by max(.001, value)", 1e-3);
    Worst across("spreadAlpha2, across: absolute by max(.001, value)", 1e-3);
    for (int i = 0; i < 100000; ++i) {
        const double wide = random.decades(1e-4, 3);
        const Normals normals = scattered(random, wide, wide * random.unit());
        const float alpha2 = float(random.decades(4.2e-6, 1));
        const unsigned sggx = i % 2;
        const Spread f = normals.inFloat(alpha2, sggx, 1e-6f);
        const Spread d = normals.inDouble(double(alpha2), sggx, double(1e-6f));
        along.relative(f.along, d.along, 1e-3);
        across.relative(f.across, d.across, 1e-3);
        ASSERT_GE(f.across, double(alpha2));
        ASSERT_GE(f.along, f.across);
        ASSERT_LE(f.along, 1.0);
        ASSERT_NEAR(glm::length(f.axis), 1.0, 1e-5);
        ASSERT_NEAR(glm::dot(f.axis, glm::dvec3(normals.mean)), 0.0, 1e-5);
    }
}

TEST(EllipticLobe, WidensWhereNormalsSpreadAndNotAcross) {
    Random random(202);
    Worst angle("axis off the plane of the spread, degrees", 0.5);
    Worst across("widening across the spread: relative", 1e-9);
    for (int i = 0; i < 20000; ++i) {
        glm::dvec3 acrossSpread;
        const Normals normals = scattered(random, random.range(0.05, 1), 0, &acrossSpread);
        const Spread s = normals.inFloat(0.01f, 0, 1e-6f);
        if (s.along < 0.0101)
            continue; // all fell on one place
        angle.absolute(degreesBetween(s.axis, acrossSpread), 90);
        across.relative(s.across, double(0.01f));
    }
}

TEST(EllipticLobe, IsThatOfItsSource) {
    // Two normals at +-slope have the variance slope^2 of n_t / n_n. SGGX: the mean of the matrices
    // n n^T + alpha2 (1 - n n^T), along the axis by along the normal.
    Worst lean("LEAN: alpha2 + 2 * variance, relative", 1e-6);
    Worst sggx("SGGX: of the mean matrix, relative", 1e-6);
    for (double slope : {0.01, 0.1, 0.3, 0.5})
        for (double alpha2 : {1e-4, 1e-2, 0.3}) {
            const glm::dvec3 a = glm::normalize(glm::dvec3(slope, 0, 1)), b(-a.x, 0, a.z);
            const Normals normals({glm::vec3(a), glm::vec3(b)});
            const auto matrix = [&](const glm::dvec3& n) {
                return glm::outerProduct(n, n) + alpha2 * (glm::dmat3(1) - glm::outerProduct(n, n));
            };
            const glm::dmat3 mean = 0.5 * (matrix(a) + matrix(b));
            lean.relative(normals.inDouble(alpha2, 0, 0).along, std::min(alpha2 + 2 * slope * slope, 1.0));
            sggx.relative(normals.inDouble(alpha2, 1, 0).along, mean[0][0] / mean[2][2]);
            sggx.relative(normals.inDouble(alpha2, 1, 0).across, mean[1][1] / mean[2][2]);
        }
}

// Second moments alone would take normals that face away for equal ones (hard case 4).
TEST(EllipticLobe, OppositeNormalsMakeTheWidest) {
    Random random(208);
    for (unsigned sggx : {0u, 1u})
        for (int i = 0; i < 1000; ++i) {
            const glm::vec3 n(random.direction());
            const Spread most = Normals({n, n, n, n, n, -n, -n, -n}).inFloat(0.001f, sggx, 1e-6f);
            EXPECT_GT(most.across, 0.7);
            const Spread few = Normals({n, n, n, n, n, n, n, -n}).inFloat(0.001f, sggx, 1e-6f);
            EXPECT_LT(few.along, 0.01);
            glm::vec3 axis;
            float along = 0, across = 0;
            math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
            add(m, 0.5, n);
            add(m, 0.5, -n);
            math_f::agaa_spreadAlpha2(m, n, 0.0f, 0.001f, sggx, 1e-6f, axis, along, across);
            EXPECT_EQ(along, 1.0f);
            EXPECT_EQ(across, 1.0f);
        }
}

TEST(EllipticLobe, EqualNormalsKeepTheirLobe) {
    Random random(203);
    Worst widened("equal normals: alpha2 widened by rounding, relative", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 n(random.direction());
        const Normals normals(std::vector<glm::vec3>(1 + random.below(32), n));
        const float alpha2 = float(random.decades(4.2e-6, 1));
        const Spread s = normals.inFloat(alpha2, 0, 1e-6f);
        widened.relative(s.along, double(alpha2));
        widened.relative(s.across, double(alpha2));
    }
}

TEST(EllipticLobe, RoundOneIsGgxAndBlinnPhong) {
    Random random(204);
    for (unsigned brdf : {0u, 1u}) {
        Worst same(brdf ? "GGX: elliptic against round, relative" : "Blinn-Phong: elliptic against round, relative",
                   1e-8);
        for (int i = 0; i < 100000; ++i) {
            const glm::dvec3 n = random.direction();
            glm::dvec3 v = random.direction();
            v = glm::dot(n, v) < 0 ? -v : v;
            const glm::dvec3 l = random.direction();
            const glm::dvec3 axis = glm::normalize(glm::cross(n, random.direction()));
            const double alpha2 = random.decades(4.2e-6, 1);
            const auto round = surface<math_d::agaa_Surface>(n, alpha2, 0, axis);
            const auto ellipse = surface<math_d::agaa_Surface>(n, alpha2, alpha2, axis);
            same.relative(math_d::agaa_shade(ellipse, v, l, brdf, 0, 1).x,
                          math_d::agaa_shade(round, v, l, brdf, 0, 0).x, 1e-6);
        }
    }
}

TEST(EllipticLobe, IsWideAlongItsAxis) {
    const double along = 0.3, across = 0.01, tilt = 0.3;
    const glm::dvec3 h(std::sin(tilt), 0, std::cos(tilt)), turned(0, h.x, h.z);
    EXPECT_GT(math_d::agaa_ggxEllipseD(along, across, h), 20 * math_d::agaa_ggxEllipseD(along, across, turned));
    EXPECT_GT(math_d::agaa_blinnPhongEllipse(along, across, h),
              20 * math_d::agaa_blinnPhongEllipse(along, across, turned));
    // Smith's terms by hand: 1 / (2 (z_l sqrt(a x_v^2 + b y_v^2 + z_v^2) + z_v sqrt(a x_l^2 + b y_l^2 + z_l^2))).
    const glm::dvec3 v(0.6, 0, 0.8), l(0, 0.8, 0.6);
    const double byHand = 0.5 / (0.6 * std::sqrt(0.3 * 0.36 + 0.64) + 0.8 * std::sqrt(0.01 * 0.64 + 0.36));
    EXPECT_NEAR(math_d::agaa_ggxEllipseV(along, across, v, l), byHand, 1e-12);
}

TEST(EllipticLobe, IntegratesToOne) {
    // Of the microsurface: the mean of D times the cosine over the hemisphere.
    for (double along : {0.1, 0.5, 1.0})
        for (double across : {0.02, 0.1, 1.0}) {
            double ggx = 0, blinnPhong = 0;
            const int rings = 4000, turns = 64;
            for (int i = 0; i < rings; ++i)
                for (int k = 0; k < turns; ++k) {
                    // Rings are closer near the pole, where lobes are high: cos = 1 - u^3.
                    const double u = (i + 0.5) / rings, z = 1 - u * u * u, r = std::sqrt(1 - z * z);
                    const double phi = (k + 0.5) / turns * 6.283185307179586;
                    const glm::dvec3 h(r * std::cos(phi), r * std::sin(phi), z);
                    const double weight = z * 3 * u * u * 6.283185307179586 / (rings * turns);
                    ggx += weight * math_d::agaa_ggxEllipseD(along, across, h);
                    blinnPhong += weight * math_d::agaa_blinnPhongEllipse(along, across, h);
                }
            EXPECT_NEAR(ggx, 1.0, 0.01) << along << " " << across;
            EXPECT_NEAR(blinnPhong, 1.0, 0.01) << along << " " << across;
        }
}

TEST(EllipticLobe, ShadeFloatAgainstDouble) {
    Random random(205);
    for (unsigned brdf : {0u, 1u}) {
        Worst worst(brdf ? "elliptic GGX: relative, floor 1e-3" : "elliptic Blinn-Phong: relative, floor 1e-3", 2e-2);
        for (int i = 0; i < 100000; ++i) {
            const glm::vec3 n(random.direction());
            const glm::vec3 axis(glm::normalize(glm::cross(glm::dvec3(n), random.direction())));
            glm::dvec3 v = random.direction();
            v = glm::dot(glm::dvec3(n), v) < 0 ? -v : v;
            const float along = float(random.decades(4.2e-6, 1));
            const float across = float(double(along) * random.decades(1e-3, 1));
            const glm::dvec3 h = glm::normalize(glm::dvec3(n) + std::sqrt(double(along)) * random.direction());
            const glm::vec3 l(glm::normalize(2.0 * glm::dot(h, v) * h - v));
            const glm::vec3 toEye(v);
            const auto f = surface<math_f::agaa_Surface>(n, double(across), double(along), axis);
            const auto d =
                surface<math_d::agaa_Surface>(glm::dvec3(n), double(across), double(along), glm::dvec3(axis));
            worst.relative(double(math_f::agaa_shade(f, toEye, l, brdf, 0, 1).x),
                           math_d::agaa_shade(d, glm::dvec3(toEye), glm::dvec3(l), brdf, 0, 1).x, 1e-3);
        }
    }
}

TEST(EllipticLobe, ConservesEnergy) {
    Random random(206);
    for (unsigned brdf : {0u, 1u})
        for (double along : {0.2, 1.0})
            for (double turn : {0.0, 0.8, 1.57}) {
                const glm::dvec3 axis(std::cos(turn), std::sin(turn), 0);
                const glm::dvec3 v(0.8, 0, 0.6);
                const auto s = surface<math_d::agaa_Surface>(glm::dvec3(0, 0, 1), 0.05, along, axis);
                double sum = 0;
                const int count = 40000;
                for (int i = 0; i < count; ++i)
                    sum += math_d::agaa_shade(s, v, random.hemisphere(), brdf, 0, 1).x;
                EXPECT_LE(sum / count * 6.283185307179586, 1.06) << brdf << " " << along << " " << turn;
            }
}

TEST(EllipticLobe, FiniteForAnyFiniteInput) {
    Random random(207);
    const std::vector<float> x = extremeFloats();
    auto pick = [&] { return x[random.below(unsigned(x.size()))]; };
    auto pick3 = [&] { return glm::vec3(pick(), pick(), pick()); };
    for (int i = 0; i < 300000; ++i) {
        auto s = surface<math_f::agaa_Surface>(pick3(), 0, 0, pick3());
        s.alpha2 = pick();
        s.alpha2Along = pick();
        const glm::vec3 c = math_f::agaa_shade(s, pick3(), pick3(), i & 1, 0, 1);
        ASSERT_TRUE(allFinite(c)) << i;
        ASSERT_GE(c.x, 0.0f);
        glm::vec3 axis;
        float along = 0, across = 0;
        const glm::vec3 n(random.direction());
        math_f::agaa_SecondMoments m{glm::vec3(random.unit(), random.unit(), random.unit()),
                                     glm::vec3(random.unit(), random.unit(), random.unit())};
        math_f::agaa_spreadAlpha2(m, n, pick(), pick(), i >> 1 & 1, 1e-6f, axis, along, across);
        ASSERT_TRUE(allFinite(axis) && across > 0 && across <= along && along <= 1) << i;
    }
}
