// Hard cases 39 and 40 of docs/numerics.md: the falloff of lights.
#include <cfloat>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

TEST(HardCase39_LightAtTheSurface, FiniteAtDistanceZero) {
    Random random(639);
    HardCaseFigures figures(39, "relative error of the attenuation; error of the direction's length", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const float distance = i % 4 ? float(random.decades(1e-3, 100)) : 0.0f;
        const glm::vec3 d = glm::vec3(random.direction()) * distance;
        const float d2 = glm::dot(d, d), radius = i % 3 ? float(random.decades(1e-3, 1)) : 0.0f;
        const float range = i % 5 ? 0.0f : float(random.decades(1, 1000));
        // Relative to the light without its window, which is 0 at the end of the range.
        const double attenuation = double(math_f::agaa_pointAttenuation(d2, range, radius * radius));
        const double reference = math_d::agaa_pointAttenuation(double(d2), double(range), double(radius * radius));
        const double scale = math_d::agaa_pointAttenuation(double(d2), 0.0, double(radius * radius));
        figures.add(std::abs(double(1.0f / d2) - reference) / scale, std::abs(attenuation - reference) / scale);
        // The direction is a unit vector, or nothing at the light.
        const float length = glm::length(math_f::agaa_lightDirection(d, radius * radius));
        figures.add(std::abs(double(glm::length(d / glm::length(d))) - 1.0),
                    distance == 0.0f ? double(length) : std::abs(double(length) - 1.0));
    }
}

TEST(HardCase39_LightAtTheSurface, ExtremesAreFinite) {
    for (float range : {0.0f, 1e-30f, 1.0f, 100.0f, FLT_MAX}) {
        for (float rMin2 : {0.0f, 1e-4f, 1.0f}) {
            for (float d2 : {0.0f, FLT_TRUE_MIN, 1e-20f, 1.0f, FLT_MAX}) {
                const float a = math_f::agaa_pointAttenuation(d2, range, rMin2);
                ASSERT_TRUE(std::isfinite(a) && a >= 0.0f) << range << " " << rMin2 << " " << d2;
            }
        }
    }
    EXPECT_EQ(math_f::agaa_lightDirection({0, 0, 0}, 1e-4f), glm::vec3(0));
    EXPECT_EQ(math_f::agaa_pointAttenuation(0.0f, 10.0f, 0.25f), 4.0f);
    Worst step("attenuation: step at the end of the range", 1e-6);
    step.add(double(math_f::agaa_pointAttenuation(math_f::agaa_sq(99.99f), 100.0f, 1e-4f)));
}

TEST(HardCase40_EqualSpotCones, StepWithoutNaN) {
    Random random(640);
    HardCaseFigures figures(40, "error of the share of light", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const float outer = random.rangeF(-1, 1), inner = i % 2 ? outer : random.rangeF(outer, 1);
        const float x = i % 4 == 1 ? outer : random.rangeF(-1, 1);
        const double width = std::max(double(inner) - double(outer), 1e-4);
        const double reference = std::clamp((double(x) - double(outer)) / width, 0.0, 1.0);
        figures.add(std::abs(std::clamp(double((x - outer) / (inner - outer)), 0.0, 1.0) - reference),
                    std::abs(double(math_f::agaa_spotCone(x, inner, outer)) - reference));
    }
    for (float c : {-1.0f, 0.0f, 0.5f, 1.0f}) {
        for (float x : {-1.0f, 0.0f, 0.5f, 1.0f}) {
            const float v = math_f::agaa_spotCone(x, c, c);
            ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << c << " " << x;
            if (x > c + 1e-3f) {
                EXPECT_EQ(v, 1.0f);
            }
            if (x <= c) {
                EXPECT_EQ(v, 0.0f);
            }
        }
    }
    // Swapped cones are a step too, not a negative light.
    EXPECT_EQ(math_f::agaa_spotCone(0.9f, 0.5f, 0.8f), 1.0f);
    EXPECT_EQ(math_f::agaa_spotCone(0.7f, 0.5f, 0.8f), 0.0f);
}
