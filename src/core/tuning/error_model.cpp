#include "core/tuning/error_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace agaa {

namespace {

constexpr double noise = 0.1;          // standard deviation of a logarithm
constexpr double smallestShare = 1e-9; // 0 would satisfy every limit
constexpr double largestShare = 1e9;   // as AgaaMeasuredSettings::errorShare

using Logarithms = std::array<double, tableScenes>;

double meanOf(const Logarithms& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / double(tableScenes);
}

Logarithms logarithms(const ChoiceRow& row) {
    Logarithms found;
    std::transform(row.errorShares.begin(), row.errorShares.end(), found.begin(), [](float s) { return std::log(s); });
    return found;
}

double mean(const ChoiceRow& row) { return meanOf(logarithms(row)); }

Logarithms deviations(const ChoiceRow& row) {
    Logarithms found = logarithms(row);
    const double middle = meanOf(found);
    for (double& number : found)
        number -= middle;
    return found;
}

double dot(const Logarithms& a, const Logarithms& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

} // namespace

ErrorModel::ErrorModel(std::span<const MeasuredShare> measured) {
    std::array<Vector, tableScenes> precision{};
    Vector right{};
    for (size_t i = 0; i < tableScenes; ++i)
        precision[i][i] = double(tableScenes - 1);
    for (const MeasuredShare& m : measured) {
        const Logarithms of = deviations(*m.row);
        const double difference = std::log(double(m.errorShare)) - mean(*m.row);
        for (size_t i = 0; i < tableScenes; ++i) {
            right[i] += of[i] * difference / (noise * noise);
            for (size_t j = 0; j < tableScenes; ++j)
                precision[i][j] += of[i] * of[j] / (noise * noise);
        }
    }
    for (size_t i = 0; i < tableScenes; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double rest = precision[i][j];
            for (size_t k = 0; k < j; ++k)
                rest -= factor_[i][k] * factor_[j][k];
            factor_[i][j] = i == j ? std::sqrt(rest) : rest / factor_[j][j];
        }
    weights_ = upperSolution(lowerSolution(right));
}

ErrorModel::Vector ErrorModel::lowerSolution(Vector right) const {
    for (size_t i = 0; i < tableScenes; ++i) {
        for (size_t k = 0; k < i; ++k)
            right[i] -= factor_[i][k] * right[k];
        right[i] /= factor_[i][i];
    }
    return right;
}

ErrorModel::Vector ErrorModel::upperSolution(Vector right) const {
    for (size_t i = tableScenes; i-- > 0;) {
        for (size_t k = i + 1; k < tableScenes; ++k)
            right[i] -= factor_[k][i] * right[k];
        right[i] /= factor_[i][i];
    }
    return right;
}

float ErrorModel::errorShare(const ChoiceRow& row, double probability) const {
    const Logarithms of = deviations(row);
    const Vector half = lowerSolution(of);
    const double variance = dot(half, half);
    const double ownNoise = variance > 0 ? noise : 0; // "single" is 1 in every scene
    const double logarithm =
        mean(row) + dot(of, weights_) + normalQuantile(probability) * std::hypot(std::sqrt(variance), ownNoise);
    return float(std::exp(std::clamp(logarithm, std::log(smallestShare), std::log(largestShare))));
}

double normalQuantile(double probability) {
    const double wanted = std::clamp(probability, 0.001, 0.999);
    double low = -4, high = 4;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        const double below = 0.5 * std::erfc(-middle / std::numbers::sqrt2);
        (below < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace agaa
