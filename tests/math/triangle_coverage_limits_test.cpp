// Coverage masks of triangles with extreme coordinates (src/shaders/math/triangle_coverage.glsl). Triangles without
// area and behind the eye are in hard_cases_coverage.cpp.
#include "coverage_oracle.h"

using namespace test_math;

namespace {

// Homogeneous vertices times a number are the same vertices.
TEST(TriangleCoverageLimits, LargeAndSmallCoordinatesCoverTheSame) {
    Random random(52);
    const glm::vec2 centre(77.5f, 33.5f);
    for (int i = 0; i < 10000; ++i) {
        Vertices t;
        for (glm::vec3& v : t)
            v = vertex(77 + random.range(-3, 4), 33 + random.range(-3, 4), random.decades(0.1, 10));
        const glm::uvec4 expected = mask(t, centre, 64);
        for (const float factor : {0x1p-80f, 0x1p-30f, 0x1p30f, 0x1p80f})
            ASSERT_EQ(mask({t[0] * factor, t[1], t[2] * factor}, centre, 64), expected) << factor;
    }
}

TEST(TriangleCoverageLimits, ExtremeInputIsDecided) {
    const std::vector<float> values = {0.0f, 1e-40f, -1e-20f, 1.0f, -3.0f, 1e12f, -1e20f, 3e38f};
    Random random(51);
    const auto pick = [&] { return values[random.below(unsigned(values.size()))]; };
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 a(pick(), pick(), pick()), b(pick(), pick(), pick()), c(pick(), pick(), pick());
        const glm::vec2 centre(0.5f, 16383.5f);
        EXPECT_EQ(mask({a, b, c}, centre, 64) & ~math_f::agaa_allCoverage(64), glm::uvec4(0));
        if (a.z <= 0 && b.z <= 0 && c.z <= 0) {
            EXPECT_EQ(mask({a, b, c}, centre, 64), glm::uvec4(0));
        }
    }
}

} // namespace
