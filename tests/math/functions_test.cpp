// Distributions, lobes, depth, statistics and lights: float against double with measured bounds,
// and properties that hold for every finite input.
#include <cfloat>

#include "test_support.h"

using namespace test_math;

TEST(MathNdf, FloatAgainstDouble) {
    Random random(11);
    Worst exponent("exponentFromAlpha2: relative, alpha2 in [4.1e-6, .9]", 2e-6);
    Worst toksvig("toksvigAlpha2: relative, lengths as given", 5e-7);
    Worst folded("foldedLength: absolute", 2e-7);
    Worst unfolded("alpha2FromFoldedLength: relative", 3e-7);
    Worst floor("varianceFloor: absolute", 2e-7);
    for (int i = 0; i < 200000; ++i) {
        const float a = static_cast<float>(random.decades(4.2e-6, 0.9));
        const float len = i % 2 ? random.rangeF(0, 1) : 1.0f - float(random.decades(1e-7, 0.5));
        const float bound = random.rangeF(0, 0.01);
        exponent.relative(math_f::agaa_exponentFromAlpha2(a), math_d::agaa_exponentFromAlpha2(a));
        toksvig.relative(math_f::agaa_toksvigAlpha2(a, len), math_d::agaa_toksvigAlpha2(a, len));
        folded.absolute(math_f::agaa_foldedLength(a), math_d::agaa_foldedLength(a));
        unfolded.relative(math_f::agaa_alpha2FromFoldedLength(len), math_d::agaa_alpha2FromFoldedLength(len));
        floor.absolute(math_f::agaa_varianceFloor(len, bound), math_d::agaa_varianceFloor(len, bound));
    }
}

TEST(MathNdf, FoldedLengthInvertsAndNeverLosesTheDirection) {
    Worst trip("folded length round trip: absolute in alpha2", 0.002);
    Worst tripSmooth("folded length round trip: absolute, alpha2 <= .99", 3e-7);
    for (int i = 0; i <= 10000; ++i) {
        const float a = std::max(static_cast<float>(i) / 10000.0f, 4.2e-6f);
        const float len = math_f::agaa_foldedLength(a);
        ASSERT_GT(len, 0.0f);
        ASSERT_LE(len, 1.0f);
        trip.absolute(math_f::agaa_alpha2FromFoldedLength(len), a);
        if (a <= 0.99f)
            tripSmooth.absolute(math_f::agaa_alpha2FromFoldedLength(len), a);
    }
    for (float x : extremeFloats()) {
        const float len = math_f::agaa_foldedLength(x);
        ASSERT_TRUE(len > 0.0f && len <= 1.0f) << x;
        const float a = math_f::agaa_alpha2FromFoldedLength(x);
        ASSERT_TRUE(a >= math_f::agaa_minAlpha2() && a <= 1.0f) << x;
    }
}

TEST(MathNdf, MeanDirection) {
    Random random(12);
    Worst angle("meanDirection: float against double, radians", 3e-7);
    Worst length("meanDirection: length, relative", 3e-7);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 m(random.direction() * random.decades(1e-5, 0.99));
        glm::vec3 n;
        float len;
        math_f::agaa_meanDirection(m, {0, 0, 1}, n, len);
        glm::dvec3 nd;
        double lenD;
        math_d::agaa_meanDirection(glm::dvec3(m), {0, 0, 1}, nd, lenD);
        angle.add(glm::length(glm::dvec3(n) - nd));
        length.relative(len, lenD);
    }
    for (float a : extremeFloats()) {
        for (float b : extremeFloats()) {
            glm::vec3 n;
            float len;
            math_f::agaa_meanDirection({a, b, a}, {b, a, b}, n, len);
            ASSERT_NEAR(glm::length(n), 1.0f, 1e-6f) << a << " " << b;
            ASSERT_TRUE(len >= 0.0f && len <= 1.0f) << a << " " << b;
        }
    }
}

TEST(MathBrdf, FloatAgainstDouble) {
    Random random(13);
    Worst d("ggxD given its arguments: relative", 1e-6);
    Worst v("ggxV: relative", 1e-6);
    Worst f("fresnelSchlick: relative", 1e-6);
    Worst log1p("log1p: relative, against the C library in double", 4e-7);
    Worst log1pd("log1p in double: relative, against the C library", 5e-10);
    Worst diffuse("rectifiedDiffuse: relative, floor 1e-3", 1e-6);
    for (int i = 0; i < 200000; ++i) {
        const float a = static_cast<float>(random.decades(4.2e-6, 1));
        const double angle = i % 2 ? random.range(0, 1.57) : random.decades(1e-6, 0.1);
        const float c = static_cast<float>(std::cos(angle));
        const float s2 = static_cast<float>(std::sin(angle) * std::sin(angle));
        d.relative(math_f::agaa_ggxD(a, c, s2), math_d::agaa_ggxD(a, c, s2));
        const float x = random.rangeF(1e-4, 1), y = random.rangeF(0, 1);
        v.relative(math_f::agaa_ggxV(a, x, y), math_d::agaa_ggxV(a, x, y));
        const glm::vec3 f0(random.rangeF(0, 1));
        f.relative(math_f::agaa_fresnelSchlick(f0, x).x, math_d::agaa_fresnelSchlick(glm::dvec3(f0), x).x);
        const float l = (i % 2 ? 1.0f : -1.0f) * static_cast<float>(random.decades(1e-12, 0.999));
        log1p.relative(math_f::agaa_log1p(l), std::log1p(double(l)));
        log1pd.relative(math_d::agaa_log1p(l), std::log1p(double(l)));
        const float len = random.rangeF(0, 1), u = random.rangeF(-1, 1);
        diffuse.relative(math_f::agaa_rectifiedDiffuse(len * u, u, len), math_d::agaa_rectifiedDiffuse(len * u, u, len),
                         1e-3);
    }
}

TEST(MathBrdf, LobesIntegrateToOne) {
    for (double a2 : {1e-4, 1e-2, 0.3, 1.0}) {
        // Midpoints in a variable that spends its steps inside the peak of both lobes.
        double ggx = 0.0, blinn = 0.0;
        const int steps = 200000;
        const double alpha = std::sqrt(a2);
        double previous = 0.0;
        for (int i = 1; i <= steps; ++i) {
            const double q = static_cast<double>(i) / steps;
            const double theta = std::atan(alpha * std::tan(q * 1.5707963));
            const double mid = 0.5 * (previous + theta), w = theta - previous;
            previous = theta;
            const double c = std::cos(mid), s = std::sin(mid);
            const double weight = 6.283185307179586 * s * c * w;
            ggx += math_d::agaa_ggxD(a2, c, s * s) * weight;
            blinn += math_d::agaa_blinnPhong(math_d::agaa_exponentFromAlpha2(a2), s * s, c) * weight;
        }
        EXPECT_NEAR(ggx, 1.0, 1e-3) << a2;
        EXPECT_NEAR(blinn, 1.0, 1e-3) << a2;
    }
}

TEST(MathBrdf, RectifiedDiffuseIsExactForOneNormal) {
    Random random(14);
    for (int i = 0; i < 100000; ++i) {
        const float u = random.rangeF(-1, 1);
        ASSERT_EQ(math_f::agaa_rectifiedDiffuse(u, u, 1.0f), std::max(u, 0.0f));
        ASSERT_EQ(math_f::agaa_rectifiedDiffuse(u, u, 1.0002f), std::max(u, 0.0f));
    }
    Worst jump("rectifiedDiffuse: step at length 1 - 1e-6", 6e-4);
    for (int i = -1000; i <= 1000; ++i) {
        const float u = static_cast<float>(i) / 1000.0f;
        jump.absolute(math_f::agaa_rectifiedDiffuse(u * (1.0f - 1e-6f), u, 1.0f - 1e-6f), std::max(u, 0.0f));
    }
    // Monotone in the cosine, never negative, at most 1.
    for (int l = 0; l <= 20; ++l) {
        const float len = static_cast<float>(l) / 20.0f;
        float previous = 0.0f;
        for (int i = -200; i <= 200; ++i) {
            const float u = static_cast<float>(i) / 200.0f;
            const float d = math_f::agaa_rectifiedDiffuse(u * len, u, len);
            ASSERT_GE(d, 0.0f);
            ASSERT_LE(d, 1.0f);
            ASSERT_GE(d, previous - 1e-5f) << len << " " << u; // in double it falls by 3.5e-6 at most
            previous = d;
        }
    }
}

TEST(MathBrdf, RectifiedDiffuseNearTheMeanOfRectifiedCosines) {
    // 32 unit normals scattered around an axis, of which the exact mean of max(n.l, 0) is known.
    Random random(15);
    double filtered = 0.0, plain = 0.0;
    const int count = 20000;
    for (int i = 0; i < count; ++i) {
        glm::dvec3 mean(0);
        double exact = 0.0;
        const glm::dvec3 axis = random.direction(), l = random.direction();
        const double spread = random.range(0, 1.2);
        for (int s = 0; s < 32; ++s) {
            const glm::dvec3 n = glm::normalize(axis + spread * random.direction());
            mean += n / 32.0;
            exact += std::max(glm::dot(n, l), 0.0) / 32.0;
        }
        const double len = glm::length(mean), u = glm::dot(mean, l) / len;
        const double d = math_d::agaa_rectifiedDiffuse(glm::dot(mean, l), u, len);
        filtered += (d - exact) * (d - exact);
        plain += (std::max(u, 0.0) - exact) * (std::max(u, 0.0) - exact);
    }
    std::printf("[ measured ] rms error of the diffuse term: rectified %.4f, max(n.l,0) %.4f\n",
                std::sqrt(filtered / count), std::sqrt(plain / count));
    EXPECT_LT(filtered, 0.1 * plain);
}

struct Projection {
    const char* name;
    double p22, p32;
};

TEST(MathDepth, InvertsEveryProjection) {
    const double n = 0.1, f = 1000.0;
    const Projection all[] = {{"forward", f / (n - f), n * f / (n - f)},
                              {"forward infinite", -1.0, -n},
                              {"reversed", n / (f - n), n * f / (f - n)},
                              {"reversed infinite", 0.0, n}};
    Random random(16);
    for (const Projection& p : all) {
        Worst inverse(std::string(p.name) + ": view z in double, relative", 1e-11);
        Worst toDouble(std::string(p.name) + ": float against double, relative", 2e-7);
        Worst step(std::string(p.name) + ": depth quantum against a difference, relative", 1e-6);
        for (int i = 0; i < 50000; ++i) {
            const double z = -random.decades(n, f);
            const double d = (p.p22 * z + p.p32) / -z;
            inverse.relative(math_d::agaa_viewZFromDepth(d, p.p22, p.p32, 0), z);
            const float df = static_cast<float>(d), a = float(p.p22), b = float(p.p32);
            toDouble.relative(math_f::agaa_viewZFromDepth(df, a, b, 0), math_d::agaa_viewZFromDepth(df, a, b, 0), 1e-6);
            const double q = std::ldexp(1.0, -24);
            const double dz = std::abs(math_d::agaa_viewZFromDepth(d + 0.5 * q, p.p22, p.p32, 0) -
                                       math_d::agaa_viewZFromDepth(d - 0.5 * q, p.p22, p.p32, 0));
            if (z > -300.0) {
                step.relative(math_d::agaa_depthQuantum(z, d, p.p22, p.p32, 0, q), dz);
            }
        }
    }
    for (double sign : {-1.0, 1.0}) {
        const double p22 = sign / (f - n), p32 = sign > 0 ? f / (f - n) : -n / (f - n);
        Worst ortho("orthographic: view z, relative", 1e-12);
        for (int i = 0; i < 1000; ++i) {
            const double z = -random.range(n, f);
            ortho.relative(math_d::agaa_viewZFromDepth(p22 * z + p32, p22, p32, 1), z);
        }
        EXPECT_NEAR(math_d::agaa_depthQuantum(-5, 0.5, p22, p32, 1, 1e-3), 1e-3 * (f - n), 1e-6);
    }
}

TEST(MathDepth, ViewPositionInvertsTheProjection) {
    Random random(17);
    Worst perspective("viewPosition: float, relative to the distance", 5e-7);
    Worst ortho("viewPosition orthographic: relative", 5e-7);
    for (int i = 0; i < 100000; ++i) {
        const double p00 = random.range(0.5, 3), p11 = -random.range(0.5, 3);
        const double p20 = random.range(-0.1, 0.1), p21 = random.range(-0.1, 0.1);
        const float a = float(p00), b = float(p11), c = float(p20), d = float(p21);
        const glm::vec2 ndc(random.rangeF(-1, 1), random.rangeF(-1, 1));
        const float z = -float(random.decades(0.1, 1e5));
        const glm::dvec3 p(math_f::agaa_viewPosition(ndc, z, a, b, c, d, 0));
        const glm::dvec2 back((double(a) * p.x + double(c) * p.z) / -p.z, (double(b) * p.y + double(d) * p.z) / -p.z);
        perspective.add(glm::length(back - glm::dvec2(ndc)));
        const glm::dvec3 o(math_f::agaa_viewPosition(ndc, z, a, b, c, d, 1));
        ortho.add(glm::length(glm::dvec2(o.x * double(a) + double(c), o.y * double(b) + double(d)) - glm::dvec2(ndc)));
        EXPECT_EQ(o.z, z);
    }
}

TEST(MathDepth, FiniteForAnyProjection) {
    for (float d : {0.0f, 1e-45f, 1e-38f, 0.5f, 1.0f}) {
        for (float a : extremeFloats()) {
            for (float b : extremeFloats()) {
                for (unsigned o : {0u, 1u}) {
                    ASSERT_TRUE(std::isfinite(math_f::agaa_viewZFromDepth(d, a, b, o)))
                        << d << " " << a << " " << b << " " << o;
                    ASSERT_TRUE(std::isfinite(math_f::agaa_depthQuantum(b, d, a, b, o, 1e-7f)))
                        << d << " " << a << " " << b << " " << o;
                }
            }
        }
    }
}

TEST(MathLight, FloatAgainstDouble) {
    Random random(18);
    Worst attenuation("pointAttenuation: relative, d <= .9 range", 2e-6);
    Worst cone("spotCone: absolute, cones >= 1e-2 apart in cosine", 3e-7);
    Worst direction("lightDirection: length error beyond 1 mm", 3e-7);
    for (int i = 0; i < 100000; ++i) {
        const float range = i % 3 ? random.rangeF(1, 100) : 0.0f;
        const float d = range > 0 ? range * random.rangeF(0.01, 0.9) : float(random.decades(.01, 1e4));
        attenuation.relative(math_f::agaa_pointAttenuation(d * d, range, 1e-4f),
                             math_d::agaa_pointAttenuation(d * d, range, 1e-4f));
        const float outer = random.rangeF(0, 0.9), inner = outer + random.rangeF(0.01, 0.1);
        const float x = random.rangeF(outer, inner);
        cone.absolute(math_f::agaa_spotCone(x, inner, outer), math_d::agaa_spotCone(x, inner, outer));
        const glm::vec3 l(random.direction() * random.decades(1.1e-3, 1e5));
        direction.absolute(glm::length(glm::dvec3(math_f::agaa_lightDirection(l, 1e-2f))), 1.0);
    }
    EXPECT_EQ(math_f::agaa_pointAttenuation(101.0f * 101.0f, 100.0f, 1e-4f), 0.0f);
    EXPECT_EQ(math_f::agaa_pointAttenuation(4.0f, 0.0f, 1e-4f), 0.25f);
}

template <class S, class V> S makeSurface(const V& diffuse, const V& specular, const V& normal, double len, double a2) {
    S s;
    s.diffuse = diffuse;
    s.specular = specular;
    s.emissive = V(0);
    s.normal = normal;
    s.meanLength = static_cast<decltype(s.meanLength)>(len);
    s.alpha2 = static_cast<decltype(s.alpha2)>(a2);
    s.alpha2Along = 0;
    s.axis = V(0);
    return s;
}

TEST(MathLight, ShadeFloatAgainstDouble) {
    Random random(19);
    Worst rough("shade, alpha >= .1: relative, floor 1e-3", 1e-5);
    Worst glossy("shade, alpha in [.002, .1]: relative, floor 1e-3", 5e-3);
    for (int i = 0; i < 200000; ++i) {
        const glm::vec3 n(random.direction());
        glm::vec3 v(random.direction());
        if (glm::dot(n, v) < 0)
            v = -v;
        glm::vec3 l(random.direction());
        const double alpha = i % 2 ? random.decades(0.1, 1) : random.decades(0.0021, 0.1);
        if (i % 4 == 0) {
            // Half vector within the lobe: where the digits are lost.
            const glm::dvec3 h = glm::normalize(glm::dvec3(n) + alpha * random.direction());
            l = glm::vec3(glm::normalize(2.0 * glm::dot(h, glm::dvec3(v)) * h - glm::dvec3(v)));
        }
        const glm::vec3 kd(random.unit(), random.unit(), random.unit());
        const glm::vec3 ks(static_cast<float>(random.unit()));
        const float len = random.rangeF(0.2, 1), a2 = float(alpha * alpha);
        const auto sf = makeSurface<math_f::agaa_Surface>(kd, ks, n, len, a2);
        const auto sd = makeSurface<math_d::agaa_Surface>(glm::dvec3(kd), glm::dvec3(ks), glm::dvec3(n), len, a2);
        for (unsigned brdf : {0u, 1u}) {
            const glm::vec3 f = math_f::agaa_shade(sf, v, l, brdf, 1u, 0u);
            const glm::dvec3 d = math_d::agaa_shade(sd, glm::dvec3(v), glm::dvec3(l), brdf, 1u, 0u);
            (alpha >= 0.1 ? rough : glossy).relative(f.x, d.x, 1e-3);
        }
    }
}

TEST(MathLight, ShadeIsFiniteForAnyFiniteInput) {
    Random random(20);
    const std::vector<float> x = extremeFloats();
    auto pick = [&] { return x[random.below(unsigned(x.size()))]; };
    for (int i = 0; i < 300000; ++i) {
        math_f::agaa_Surface s{};
        s.diffuse = {pick(), pick(), pick()};
        s.specular = {pick(), pick(), pick()};
        s.emissive = {pick(), pick(), pick()};
        s.normal = {pick(), pick(), pick()};
        s.meanLength = pick();
        s.alpha2 = pick();
        const glm::vec3 c =
            math_f::agaa_shade(s, {pick(), pick(), pick()}, {pick(), pick(), pick()}, i & 1, (i >> 1) & 1, 0u);
        ASSERT_TRUE(allFinite(c));
        ASSERT_GE(std::min(c.x, std::min(c.y, c.z)), 0.0f);
    }
}

TEST(MathLight, ShadeConservesEnergy) {
    // Reflected energy for light from v, of the specular lobe alone with f0 = 1.
    Random random(21);
    for (unsigned brdf : {0u, 1u}) {
        for (double alpha : {0.2, 0.5, 1.0}) {
            for (double cosV : {0.2, 0.6, 1.0}) {
                const glm::dvec3 v(std::sqrt(1 - cosV * cosV), 0, cosV);
                const auto s = makeSurface<math_d::agaa_Surface>(glm::dvec3(0), glm::dvec3(1), glm::dvec3(0, 0, 1), 1.0,
                                                                 alpha * alpha);
                double sum = 0.0;
                const int count = 20000;
                for (int i = 0; i < count; ++i) {
                    sum += math_d::agaa_shade(s, v, random.hemisphere(), brdf, 0, 0).x;
                }
                EXPECT_LE(sum / count * 6.283185307179586, 1.05) << brdf << " " << alpha << " " << cosV;
            }
        }
    }
}
