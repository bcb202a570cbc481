// The table of reflectances against sums over all directions.
#include "environment/reflectance_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace harness;

namespace {

constexpr double last = reflectanceSteps - 1;

// The reflectance of a lobe for F0, by steps of equal solid angle over the directions of light.
double brute(double roughness, double cosine, double f0) {
    constexpr int steps = 800;
    const double a2 = std::pow(roughness, 4);
    const glm::dvec3 eye(std::sqrt(1 - cosine * cosine), 0, cosine);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double z = (i + 0.5) / steps, angle = 2 * std::numbers::pi * (k + 0.5) / steps;
            const double across = std::sqrt(1 - z * z);
            const glm::dvec3 light(across * std::cos(angle), across * std::sin(angle), z);
            const glm::dvec3 half = glm::normalize(eye + light);
            const double d = half.z * half.z * (a2 - 1) + 1;
            const double lambda =
                z * std::sqrt(a2 + (1 - a2) * cosine * cosine) + cosine * std::sqrt(a2 + (1 - a2) * z * z);
            const double fresnel = f0 + (1 - f0) * std::pow(1 - glm::dot(eye, half), 5);
            sum += fresnel * a2 / (std::numbers::pi * d * d) * 0.5 / lambda * z;
        }
    return sum * 2 * std::numbers::pi / (double(steps) * steps);
}

TEST(ReflectanceTable, EntriesAreIntegrals) {
    const std::vector<glm::vec2> table = makeReflectanceTable();
    for (const uint32_t row : {12u, 20u, 31u})
        for (const uint32_t column : {3u, 16u, 31u}) {
            const glm::dvec2 entry(table[row * reflectanceSteps + column]);
            for (const double f0 : {0.04, 1.0})
                EXPECT_NEAR(f0 * entry.x + entry.y, brute(row / last, column / last, f0), 0.02)
                    << "roughness " << row / last << ", cosine " << column / last << ", F0 " << f0;
        }
}

TEST(ReflectanceTable, AMirrorReflectsAllLightByFresnelsTerm) {
    const std::vector<glm::vec2> table = makeReflectanceTable();
    for (uint32_t column = 1; column < reflectanceSteps; ++column) {
        EXPECT_NEAR(table[column].x + table[column].y, 1, 1e-3);
        EXPECT_NEAR(table[column].y, std::pow(1 - column / last, 5), 1e-3);
    }
    for (const glm::vec2& entry : table) {
        EXPECT_GE(entry.x, 0);
        EXPECT_GE(entry.y, 0);
        EXPECT_LE(entry.x + entry.y, 1.03f);
    }
}

} // namespace
