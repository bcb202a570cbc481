#include "environment/reflectance_table.h"

#include "environment/hammersley.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace harness {

namespace {

constexpr uint32_t pointCount = 1024;

// Returns the height-correlated Smith term, G / (4 cos cos) (Heitz 2014).
double smith(double alpha2, double toEye, double toLight) {
    const double maskEye = toLight * std::sqrt(alpha2 + (1 - alpha2) * toEye * toEye);
    const double maskLight = toEye * std::sqrt(alpha2 + (1 - alpha2) * toLight * toLight);
    return 0.5 / (maskEye + maskLight);
}

glm::vec2 reflectance(double roughness, double cosine) {
    const double alpha2 = std::max(std::pow(roughness, 4), 1e-7);
    const glm::dvec3 eye(std::sqrt(1 - cosine * cosine), 0, cosine);
    glm::dvec2 sum(0);
    for (uint32_t i = 0; i < pointCount; ++i) {
        const glm::dvec2 point = hammersley(i, pointCount);
        const double z2 = (1 - point.x) / (1 + (alpha2 - 1) * point.x);
        const double across = std::sqrt(1 - z2), angle = 2 * std::numbers::pi * point.y;
        const glm::dvec3 half(across * std::cos(angle), across * std::sin(angle), std::sqrt(z2));
        const double toHalf = glm::dot(eye, half);
        const double toLight = 2 * toHalf * half.z - eye.z;
        if (toHalf <= 0 || toLight <= 0)
            continue;
        const double weight = 4 * smith(alpha2, cosine, toLight) * toLight * toHalf / half.z;
        const double m = 1 - toHalf, fresnel = m * m * m * m * m;
        sum += weight * glm::dvec2(1 - fresnel, fresnel);
    }
    return glm::vec2(sum / double(pointCount));
}

} // namespace

std::vector<glm::vec2> makeReflectanceTable() {
    std::vector<glm::vec2> table;
    constexpr double last = reflectanceSteps - 1;
    for (uint32_t row = 0; row < reflectanceSteps; ++row)
        for (uint32_t column = 0; column < reflectanceSteps; ++column) // the integral has a limit at cosine 0
            table.push_back(reflectance(row / last, std::max(column / last, 1e-3)));
    return table;
}

} // namespace harness
