#include "environment/irradiance.h"

#include <cmath>
#include <numbers>

namespace harness {

namespace {

// The polynomials of the basis without their factors.
std::array<double, 9> polynomials(const glm::dvec3& d) {
    return {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
}

// Squares of the factors of the basis, times the share of each band that reflects off a diffuse surface: 1, 2/3 and 1/4
// (equation 8 of the paper, divided by pi).
constexpr double bandShare[] = {1, 2.0 / 3, 0.25};
std::array<double, 9> factors() {
    constexpr double quarter = std::numbers::inv_pi / 4;
    std::array<double, 9> list{};
    list[0] = quarter * bandShare[0];
    for (size_t i = 1; i <= 3; ++i)
        list[i] = 3 * quarter * bandShare[1];
    for (const size_t i : {4, 5, 7})
        list[i] = 15 * quarter * bandShare[2];
    list[6] = 5.0 / 4 * quarter * bandShare[2];
    list[8] = 15.0 / 4 * quarter * bandShare[2];
    return list;
}

} // namespace

Irradiance makeIrradiance(const SphereImage& image) {
    std::array<glm::dvec3, 9> sums{};
    for (uint32_t y = 0; y < image.height; ++y) {
        const double solidAngle = image.solidAngle(y);
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::dvec3 radiance = glm::dvec3(image.at(x, y)) * solidAngle;
            const auto values = polynomials(glm::dvec3(image.directionOf(x, y)));
            for (size_t i = 0; i < sums.size(); ++i)
                sums[i] += radiance * values[i];
        }
    }
    const auto scale = factors();
    Irradiance irradiance;
    for (size_t i = 0; i < sums.size(); ++i)
        irradiance[i] = glm::vec3(sums[i] * scale[i]);
    return irradiance;
}

glm::vec3 irradianceAt(const Irradiance& irradiance, const glm::vec3& normal) {
    const auto values = polynomials(glm::dvec3(normal));
    glm::vec3 sum(0);
    for (size_t i = 0; i < values.size(); ++i)
        sum += irradiance[i] * float(values[i]);
    return glm::max(sum, glm::vec3(0));
}

} // namespace harness
