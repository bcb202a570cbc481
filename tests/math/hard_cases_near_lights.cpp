// Hard cases 65 and 66 of docs/numerics.md: lights nearer than a pixel is wide, and scenes of any scale.
#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

// The share of a point light's flux that a square of side 1 across z receives: the integral of h / r^3 over it.
double irradiance(const glm::dvec3& light) {
    const auto corner = [&](double u, double v) {
        return std::atan2(u * v, light.z * std::sqrt(u * u + v * v + light.z * light.z));
    };
    const double x = light.x, y = light.y;
    return corner(0.5 - x, 0.5 - y) + corner(0.5 + x, 0.5 - y) + corner(0.5 - x, 0.5 + y) + corner(0.5 + x, 0.5 + y);
}

double lambert(const glm::vec3& toLight, const glm::vec3& direction, float spread) {
    const glm::vec3 l = math_f::agaa_lightDirection(direction, 0);
    return double(
        math_f::agaa_pointAttenuation(math_f::agaa_spreadDistance2(glm::dot(toLight, toLight), spread), 0, 0) *
        std::max(l.z, 0.0f));
}

TEST(HardCase65_LightsWithinAnAggregate, OneEventHasTheLightOfItsPixel) {
    Random random(65);
    HardCaseFigures figures(65, "excess of a pixel over the light that it receives, times that light", 1);
    const float spread = 1.0f / 6; // of a square
    double energy = 0, truth = 0;
    for (int i = 0; i < 200000; ++i) {
        const glm::vec3 light(random.range(-2, 2), random.range(-2, 2), random.decades(0.02, 2));
        const double received = irradiance(glm::dvec3(light));
        const double ours = lambert(light, math_f::agaa_nearestToLight(light, {0, 0, 1}, spread), spread);
        // Where hardly any light falls, a pixel may have little light too much.
        const double scale = std::max(received, 0.1);
        figures.add(std::max(lambert(light, light, 0) - received, 0.0) / scale, std::max(ours - received, 0.0) / scale);
        energy += ours;
        truth += received;
    }
    EXPECT_NEAR(energy / truth, 1, 0.15);
}

TEST(HardCase65_LightsWithinAnAggregate, OneSampleIsShadedAtItsPosition) {
    Random random(165);
    for (int i = 0; i < 10000; ++i) {
        const glm::vec3 light = glm::vec3(random.direction()) * float(random.decades(1e-6, 1e6));
        const glm::vec3 normal = glm::vec3(random.direction());
        const glm::vec3 same = math_f::agaa_nearestToLight(light, normal, 0);
        ASSERT_LE(glm::length(same - light), 1e-6f * glm::length(light));
        for (const float spread : {1e-30f, 1e-3f, 1e3f, 1e30f}) {
            const glm::vec3 near = math_f::agaa_nearestToLight(light, normal, spread);
            ASSERT_LE(glm::length(near), 1.00001f * glm::length(light));
            ASSERT_NEAR(glm::dot(near, normal), glm::dot(light, normal), 1e-5f * glm::length(light));
        }
    }
}

TEST(HardCase66_ScenesOfAnyScale, LightsKeepTheirEnergy) {
    Random random(66);
    HardCaseFigures figures(66, "relative error of the light at a scale against the light at scale 1", 1e-5);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 toLight = glm::vec3(random.direction()) * float(random.decades(0.3, 30));
        const float range = i % 2 ? float(random.decades(1, 100)) : 0, radius = float(random.decades(1e-3, 0.1));
        const float scale = std::exp2(std::floor(float(random.range(-36, 20)))); // exact
        const auto at = [&](float s, float leastDistance2, float leastRange2) {
            const glm::vec3 d = toLight * s;
            const float d2 = std::max(glm::dot(d, d), leastDistance2);
            const float r = std::sqrt(std::max(range * s * range * s, range > 0 ? leastRange2 : 0.0f));
            return glm::dvec2(double(math_f::agaa_pointAttenuation(d2, r, radius * s * radius * s)) * double(s) *
                                  double(s),
                              double(glm::length(math_f::agaa_lightDirection(d, leastDistance2))));
        };
        const glm::dvec2 one = at(1, 0, 0), ours = at(scale, 0, 0), naive = at(scale, 1e-12f, 1e-20f);
        const double floor = 1e-3; // at the end of the range there is hardly any light
        figures.add(std::abs(naive.x - one.x) / std::max(one.x, floor),
                    std::abs(ours.x - one.x) / std::max(one.x, floor));
        figures.ours(std::abs(ours.y - one.y), 0);
    }
}

} // namespace
