// Lights against boxes (math/light_culling.glsl): a light that is left out gives nothing at any place of the box, in
// float as the GPU has it, and most of those that give nothing are left out.
#include "shader_math.h"
#include "test_support.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace test_math;

namespace {

struct Case {
    glm::vec3 low, high, light, direction;
    float range = 0, cosOuter = 0;
};

// Boxes from points to large ones, at distances of many decades.
Case randomCase(Random& random) {
    Case c;
    const double scale = random.decades(1e-3, 1e9);
    const glm::dvec3 at = random.direction() * scale * random.decades(1e-3, 1);
    const glm::dvec3 size = glm::abs(random.direction()) * scale * random.decades(1e-6, 1);
    c.low = glm::vec3(at);
    c.high = glm::vec3(at + size);
    c.light = glm::vec3(at + random.direction() * scale * random.decades(1e-3, 3));
    c.direction = glm::vec3(random.direction());
    c.range = float(scale * random.decades(1e-3, 3));
    c.cosOuter = float(1 - random.decades(1e-6, 2));
    return c;
}

glm::vec3 placeIn(const Case& c, Random& random) {
    glm::vec3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] =
            std::clamp(c.low[axis] + float(random.unit()) * (c.high[axis] - c.low[axis]), c.low[axis], c.high[axis]);
    return p;
}

} // namespace

TEST(MathLightCulling, RangesThatDoNotReachGiveNothing) {
    Random random(31);
    int out = 0, culled = 0;
    for (int round = 0; round < 20000; ++round) {
        const Case c = randomCase(random);
        const bool reaches = math_f::agaa_rangeReaches(c.light, c.range, c.low, c.high);
        const glm::dvec3 away =
            glm::clamp(glm::dvec3(c.light), glm::dvec3(c.low), glm::dvec3(c.high)) - glm::dvec3(c.light);
        out += glm::length(away) > double(c.range) * 1.01;
        culled += !reaches;
        for (int i = 0; !reaches && i < 16; ++i) {
            const glm::vec3 d = c.light - placeIn(c, random);
            ASSERT_EQ(math_f::agaa_pointAttenuation(glm::dot(d, d), c.range, 0), 0) << round;
        }
    }
    EXPECT_GT(culled, 0.95 * out);
    EXPECT_GT(out, 2000);
}

TEST(MathLightCulling, ConesThatDoNotReachGiveNothing) {
    Random random(32);
    int out = 0, culled = 0;
    for (int round = 0; round < 20000; ++round) {
        const Case c = randomCase(random);
        const glm::vec3 centre = 0.5f * (c.low + c.high);
        const float radius = glm::length(c.high - centre);
        const bool reaches = math_f::agaa_coneReaches(c.light, c.direction, c.cosOuter, centre, radius);
        const glm::dvec3 v = glm::dvec3(centre) - glm::dvec3(c.light);
        const double angle = std::acos(std::clamp(glm::dot(v, glm::dvec3(c.direction)) / glm::length(v), -1.0, 1.0));
        const double needed =
            std::acos(std::max(double(c.cosOuter), -1.0)) + std::asin(std::min(double(radius) / glm::length(v), 1.0));
        out += c.cosOuter > 0 && glm::length(v) > 2.0 * double(radius) && angle > needed + 0.1;
        culled += !reaches;
        for (int i = 0; !reaches && i < 16; ++i) {
            const glm::vec3 toLight = math_f::agaa_lightDirection(c.light - placeIn(c, random), 0);
            ASSERT_EQ(math_f::agaa_spotCone(glm::dot(-toLight, c.direction), c.cosOuter, c.cosOuter), 0) << round;
        }
    }
    EXPECT_GT(culled, 0.95 * out);
    EXPECT_GT(out, 2000);
}

TEST(MathLightCulling, WithoutAnEndTheyReachEverything) {
    const glm::vec3 far(1e18f), low(-1e12f), high(1e12f);
    EXPECT_TRUE(math_f::agaa_rangeReaches(far, 0, low, high));
    EXPECT_TRUE(math_f::agaa_rangeReaches(far, 4e18f, low, high));
    EXPECT_FALSE(math_f::agaa_rangeReaches(far, 1e17f, low, high));
    EXPECT_TRUE(math_f::agaa_rangeReaches(glm::vec3(0), 1e-6f, low, high)) << "a light inside";
    EXPECT_TRUE(math_f::agaa_coneReaches(far, glm::vec3(0, 0, 1), -0.5f, glm::vec3(0), 1)) << "more than half of space";
    EXPECT_TRUE(math_f::agaa_coneReaches(glm::vec3(0), glm::vec3(0, 0, 1), 0.9f, glm::vec3(0), 1)) << "a light inside";
    EXPECT_FALSE(math_f::agaa_coneReaches(glm::vec3(0), glm::vec3(0, 0, 1), 0.9f, glm::vec3(0, 0, -10), 1)) << "behind";
    EXPECT_TRUE(math_f::agaa_coneReaches(glm::vec3(0), glm::vec3(0, 0, 1), 0.9f, glm::vec3(0, 0, 10), 1));
}
