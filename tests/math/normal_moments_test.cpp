// Sums of coded moments against the moments of all normals, float against double.
#include <algorithm>

#include "test_support.h"

using namespace test_math;

namespace {

struct Sums {
    std::array<unsigned, 5> words{};
    unsigned count = 0;

    template <class Code> void add(const Code& code) {
        for (unsigned m = 0; m < 5; ++m)
            words[m] += code(m);
        ++count;
    }
};

Sums inFloat(const std::vector<glm::dvec3>& normals) {
    Sums sums;
    for (const glm::dvec3& n : normals)
        sums.add([&](unsigned m) { return math_f::agaa_momentCode(m, glm::vec3(n)); });
    return sums;
}

Sums inDouble(const std::vector<glm::dvec3>& normals) {
    Sums sums;
    for (const glm::dvec3& n : normals)
        sums.add([&](unsigned m) { return math_d::agaa_momentCode(m, n); });
    return sums;
}

math_f::agaa_SecondMoments floatMoments(const Sums& s) {
    return math_f::agaa_momentsOfSums(s.words[0], s.words[1], s.words[2], s.words[3], s.words[4], s.count);
}

math_d::agaa_SecondMoments doubleMoments(const Sums& s) {
    return math_d::agaa_momentsOfSums(s.words[0], s.words[1], s.words[2], s.words[3], s.words[4], s.count);
}

math_d::agaa_SecondMoments exactMoments(const std::vector<glm::dvec3>& normals) {
    math_d::agaa_SecondMoments m{glm::dvec3(0), glm::dvec3(0)};
    for (const glm::dvec3& n : normals)
        math_d::agaa_addSecondMoments(m, 1.0 / double(normals.size()), n);
    return m;
}

template <class Moments> double distance(const Moments& a, const math_d::agaa_SecondMoments& b) {
    const glm::dvec3 squares = glm::abs(glm::dvec3(a.squares) - b.squares);
    const glm::dvec3 mixed = glm::abs(glm::dvec3(a.mixed) - b.mixed);
    return std::max({squares.x, squares.y, squares.z, mixed.x, mixed.y, mixed.z});
}

std::vector<glm::dvec3> someNormals(Random& random) {
    const glm::dvec3 middle = random.direction();
    const double radius = random.decades(1e-5, 1e2); // the latter: all directions
    std::vector<glm::dvec3> normals(1 + random.below(32));
    for (glm::dvec3& n : normals)
        n = glm::normalize(middle + radius * random.unit() * random.direction());
    return normals;
}

TEST(NormalMoments, SumsHaveTheMomentsOfAllNormals) {
    Random random(91);
    double inFloats = 0, inDoubles = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::vector<glm::dvec3> normals = someNormals(random);
        const math_d::agaa_SecondMoments exact = exactMoments(normals);
        inFloats = std::max(inFloats, distance(floatMoments(inFloat(normals)), exact));
        inDoubles = std::max(inDoubles, distance(doubleMoments(inDouble(normals)), exact));
    }
    EXPECT_LT(inDoubles, 6.5e-8); // measured 6.0e-8: half a step of a signed code
    EXPECT_LT(inFloats, 2.5e-7);  // measured 1.8e-7
}

TEST(NormalMoments, SumsOf32CodesFillNoWord) {
    for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),
                                glm::normalize(glm::dvec3(1, 1, 0)), glm::normalize(glm::dvec3(-1, 0, 1)),
                                glm::normalize(glm::dvec3(0, 1, 1)), glm::normalize(glm::dvec3(1, -1, 1))}) {
        const std::vector<glm::dvec3> normals(32, n);
        const Sums sums = inFloat(normals);
        for (const unsigned word : sums.words)
            EXPECT_LT(word, 1u << 29);
        EXPECT_LT(distance(floatMoments(sums), exactMoments(normals)), 2.5e-7);
    }
}

// Equal normals have no spread, also about a mean that is rounded to 11 bits.
TEST(NormalMoments, EqualNormalsDoNotWiden) {
    constexpr unsigned bits = 11;
    const float alpha2 = math_f::agaa_minAlpha2();
    const float lengthBound = math_f::agaa_storedLengthBound(1, bits);
    Random random(17);
    for (int i = 0; i < 20000; ++i) {
        const std::vector<glm::dvec3> normals(1 + random.below(32), random.direction());
        glm::vec3 mean;
        for (int k = 0; k < 3; ++k)
            mean[k] = math_f::agaa_fromSignedCode(math_f::agaa_signedCode(float(normals[0][k]), bits), bits);
        glm::vec3 axis;
        float along = 0, across = 0;
        math_f::agaa_spreadAlpha2(floatMoments(inFloat(normals)), glm::normalize(mean), 1.0f, alpha2, i & 1,
                                  lengthBound * lengthBound + 1e-6f, axis, along, across);
        ASSERT_NEAR(along, alpha2, 1e-5f * alpha2) << i;
        ASSERT_NEAR(across, alpha2, 1e-5f * alpha2) << i;
    }
}

} // namespace
