// Filters of the diffuse term against means over many normals, and in float against double.
#include "test_support.h"

using namespace test_math;

namespace {

// The mean of max(n.l, 0) over a von Mises-Fisher distribution of this sharpness, at an angle to the light.
double meanCosine(double sharpness, double cosine) {
    const double sine = std::sqrt(1 - cosine * cosine);
    constexpr int rings = 300, turns = 96;
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        const double share = (i + 0.5) / rings;
        const double z = 1 + std::log(share + (1 - share) * std::exp(-2 * sharpness)) / sharpness;
        const double r = std::sqrt(std::max(1 - z * z, 0.0));
        for (int j = 0; j < turns; ++j)
            sum += std::max(z * cosine + r * std::cos(6.283185307179586 * (j + 0.5) / turns) * sine, 0.0);
    }
    return sum / (rings * turns);
}

TEST(DiffuseFilter, MisesFisherIsTheMeanOverItsNormals) {
    Worst error("mean cosine over a von Mises-Fisher distribution", 0.017);
    for (double sharpness = 0.05; sharpness < 600; sharpness *= 1.5) {
        const double length = 1 / std::tanh(sharpness) - 1 / sharpness;
        for (int i = -20; i <= 20; ++i)
            error.absolute(math_d::agaa_misesFisherDiffuse(i / 20.0, length), meanCosine(sharpness, i / 20.0));
    }
    Worst same("of equal normals", 1e-15);
    for (int i = -20; i <= 20; ++i)
        same.absolute(math_d::agaa_misesFisherDiffuse(i / 20.0, 1), std::max(i / 20.0, 0.0));
}

TEST(DiffuseFilter, MisesFisherInFloatIsThatInDouble) {
    Random random(821);
    Worst error("von Mises-Fisher in float", 2e-6);
    for (int i = 0; i < 100'000; ++i) {
        const float cosine = random.rangeF(-1, 1), length = float(1 - random.decades(1e-9, 1));
        const float value = math_f::agaa_misesFisherDiffuse(cosine, length);
        EXPECT_GE(value, 0);
        error.absolute(double(value), math_d::agaa_misesFisherDiffuse(double(cosine), double(length)));
    }
    for (const float bad : {-1e30f, -1.0f, 2.0f, 1e30f})
        for (const float length : {-1.0f, 0.0f, 1e-30f, 0.5f, 1.0f, 1e30f})
            EXPECT_TRUE(std::isfinite(math_f::agaa_misesFisherDiffuse(bad, length)));
}

template <class Moments, class V> Moments momentsOf(const std::vector<glm::dvec3>& normals) {
    using Real = typename V::value_type;
    Moments m{V(0), V(0)};
    for (const glm::dvec3& n : normals) {
        const V v(n);
        const Real weight = Real(1.0 / double(normals.size()));
        m.squares += weight * v * v;
        m.mixed += weight * V(v.y * v.z, v.z * v.x, v.x * v.y);
    }
    return m;
}

// Of the matrix of a sphere: Heitz et al. 2015 give 2 / (3 pi) times Lambert's phase for all normals.
TEST(DiffuseFilter, SggxOfASphereIsThatOfItsVisibleHalf) {
    const math_d::agaa_SecondMoments sphere{glm::dvec3(1.0 / 3), glm::dvec3(0)};
    Worst error("SGGX of a sphere with 8 normals", 0.05);
    for (int i = 0; i <= 30; ++i) {
        const double angle = 3.14159265358979 * i / 30;
        const double expected =
            2 / (3 * 3.14159265358979) * (std::sin(angle) + (3.14159265358979 - angle) * std::cos(angle));
        error.absolute(math_d::agaa_sggxCosine(sphere, {0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}), expected);
    }
}

TEST(DiffuseFilter, SggxOfEqualNormalsIsTheirCosine) {
    Random random(822);
    Worst error("SGGX of equal normals", 1e-2);
    for (int i = 0; i < 5'000; ++i) {
        const glm::dvec3 n = random.direction(), l = random.direction();
        glm::dvec3 v = random.direction();
        if (glm::dot(n, v) < 0)
            v = -v;
        if (glm::dot(n, v) < 0.1) // of which the eye sees little more than the least spread
            continue;
        const auto m = momentsOf<math_d::agaa_SecondMoments, glm::dvec3>({n});
        error.absolute(math_d::agaa_sggxCosine(m, v, l), std::max(glm::dot(n, l), 0.0));
    }
}

TEST(DiffuseFilter, SggxInFloatIsThatInDouble) {
    Random random(823);
    Worst error("SGGX in float", 1e-3);
    for (int i = 0; i < 20'000; ++i) {
        std::vector<glm::dvec3> normals;
        const glm::dvec3 middle = random.direction();
        const double width = random.decades(1e-3, 2);
        for (unsigned k = 1 + random.below(16); k > 0; --k)
            normals.push_back(glm::normalize(middle + width * random.direction()));
        const glm::dvec3 v = random.direction(), l = random.direction();
        const auto f = momentsOf<math_f::agaa_SecondMoments, glm::vec3>(normals);
        const math_d::agaa_SecondMoments d{glm::dvec3(f.squares), glm::dvec3(f.mixed)};
        const float value = math_f::agaa_sggxCosine(f, glm::vec3(v), glm::vec3(l));
        EXPECT_TRUE(value >= 0 && value <= 1);
        error.absolute(double(value), math_d::agaa_sggxCosine(d, glm::dvec3(glm::vec3(v)), glm::dvec3(glm::vec3(l))));
    }
    const math_f::agaa_SecondMoments none{glm::vec3(0), glm::vec3(0)};
    EXPECT_TRUE(std::isfinite(math_f::agaa_sggxCosine(none, {0, 0, 1}, {0, 0, 1})));
}

} // namespace
