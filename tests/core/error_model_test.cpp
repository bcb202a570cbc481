// Errors of settings predicted from measured errors: against the formula of the conditional normal distribution, at the
// ends of its ranges, and in the scenes of the table.
#include "core/tuning/error_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace agaa;

namespace {

using Matrix = std::vector<std::vector<double>>;

const ChoiceRow& rowNamed(const char* technique, uint32_t samples) {
    return *findRow(technique, samples, 0, nullptr, AGAA_TIER_AUTO);
}

double meanOf(const ChoiceRow& row) {
    double sum = 0;
    for (const float share : row.errorShares)
        sum += std::log(double(share));
    return sum / tableScenes;
}

double covariance(const ChoiceRow& a, const ChoiceRow& b) {
    double sum = 0;
    for (size_t scene = 0; scene < tableScenes; ++scene)
        sum +=
            (std::log(double(a.errorShares[scene])) - meanOf(a)) * (std::log(double(b.errorShares[scene])) - meanOf(b));
    return sum / (tableScenes - 1);
}

// Returns x of a x = b, by elimination with pivots.
std::vector<double> solve(Matrix a, std::vector<double> b) {
    const size_t n = b.size();
    for (size_t i = 0; i < n; ++i) {
        size_t pivot = i;
        for (size_t row = i; row < n; ++row)
            if (std::abs(a[row][i]) > std::abs(a[pivot][i]))
                pivot = row;
        std::swap(a[i], a[pivot]);
        std::swap(b[i], b[pivot]);
        for (size_t row = i + 1; row < n; ++row) {
            const double factor = a[row][i] / a[i][i];
            for (size_t column = i; column < n; ++column)
                a[row][column] -= factor * a[i][column];
            b[row] -= factor * b[i];
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t column = i + 1; column < n; ++column)
            b[i] -= a[i][column] * b[column];
        b[i] /= a[i][i];
    }
    return b;
}

// mean_r + C_rM (C_MM + noise^2)^-1 (y_M - mean_M), and its variance.
float conditional(const std::vector<MeasuredShare>& measured, const ChoiceRow& row, double probability) {
    constexpr double noise = 0.1;
    const size_t n = measured.size();
    Matrix covariances(n, std::vector<double>(n));
    std::vector<double> differences(n), with(n);
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j)
            covariances[i][j] = covariance(*measured[i].row, *measured[j].row) + (i == j ? noise * noise : 0);
        differences[i] = std::log(double(measured[i].errorShare)) - meanOf(*measured[i].row);
        with[i] = covariance(row, *measured[i].row);
    }
    const std::vector<double> weights = solve(covariances, with);
    double mean = meanOf(row), variance = covariance(row, row) + noise * noise;
    for (size_t i = 0; i < n; ++i) {
        mean += weights[i] * differences[i];
        variance -= weights[i] * with[i];
    }
    return float(std::exp(mean + normalQuantile(probability) * std::sqrt(variance)));
}

// What measuring the rows in a scene of the table gives.
std::vector<MeasuredShare> measuredIn(size_t scene, std::initializer_list<const ChoiceRow*> rows) {
    std::vector<MeasuredShare> found;
    for (const ChoiceRow* row : rows)
        found.push_back({row, row->errorShares[scene]});
    return found;
}

double meanDistance(size_t scene, const ErrorModel& model) {
    double sum = 0;
    for (const ChoiceRow& row : choiceRows())
        sum += std::abs(std::log(double(model.errorShare(row, 0.5) / row.errorShares[scene])));
    return sum / double(choiceRows().size());
}

} // namespace

TEST(ErrorModel, IsTheConditionalDistribution) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> logarithm(-2, 2);
    for (size_t count = 0; count <= 6; ++count)
        for (int run = 0; run < 20; ++run) {
            std::vector<MeasuredShare> measured;
            for (size_t i = 0; i < count; ++i) {
                const ChoiceRow& row = choiceRows()[1 + random() % (choiceRows().size() - 1)];
                measured.push_back({&row, float(std::exp(meanOf(row) + logarithm(random)))});
            }
            const ErrorModel model(measured);
            for (const ChoiceRow& row : choiceRows().subspan(1))
                for (const double probability : {0.1, 0.5, 0.98})
                    EXPECT_NEAR(model.errorShare(row, probability) / conditional(measured, row, probability), 1, 1e-4);
        }
}

TEST(ErrorModel, WithoutMeasurementsItIsTheGeometricMeanOfTheScenes) {
    const ErrorModel model({});
    for (const ChoiceRow& row : choiceRows())
        EXPECT_NEAR(model.errorShare(row, 0.5) / std::exp(meanOf(row)), 1, 1e-6);
}

TEST(ErrorModel, MeasurementsInKnownScenesBringPredictionsNearer) {
    double none = 0, one = 0, two = 0;
    for (size_t scene = 0; scene < tableScenes; ++scene) {
        none += meanDistance(scene, ErrorModel({}));
        one += meanDistance(scene, ErrorModel(measuredIn(scene, {&rowNamed("ssaa", 8)})));
        two += meanDistance(scene, ErrorModel(measuredIn(scene, {&rowNamed("ssaa", 8), &rowNamed("ssaa", 32)})));
    }
    EXPECT_LT(one, 0.8 * none);
    EXPECT_LT(two, 0.8 * one);
}

TEST(ErrorModel, ErrorsAreMoreCertainTheMoreIsMeasured) {
    const ChoiceRow& row = rowNamed("simple_complex", 8);
    const auto spread = [&](const ErrorModel& model) {
        return model.errorShare(row, 0.8) / model.errorShare(row, 0.5);
    };
    const ErrorModel none({}), one(measuredIn(0, {&rowNamed("ssaa", 32)})),
        two(measuredIn(0, {&rowNamed("ssaa", 32), &rowNamed("ssaa", 8)}));
    EXPECT_GT(spread(none), spread(one));
    EXPECT_GT(spread(one), spread(two));
    EXPECT_GT(spread(two), 1);
}

TEST(ErrorModel, SingleIsOne) {
    const ErrorModel model(measuredIn(3, {&rowNamed("ssaa", 8), &rowNamed("single", 1)}));
    for (const double probability : {0.0, 0.5, 1.0})
        EXPECT_EQ(model.errorShare(rowNamed("single", 1), probability), 1);
}

TEST(ErrorModel, ExtremeMeasurementsGiveFiniteErrors) {
    for (const float share : {std::numeric_limits<float>::denorm_min(), 1e-30f, 1.0f, 1e9f})
        for (const ChoiceRow& measured : choiceRows()) {
            const MeasuredShare m{&measured, share};
            const ErrorModel model({&m, 1});
            for (const ChoiceRow& row : choiceRows())
                for (const double probability : {0.0, 0.5, 1.0}) {
                    const float found = model.errorShare(row, probability);
                    EXPECT_TRUE(std::isfinite(found) && found > 0 && found <= 1.001e9f) << found;
                }
        }
}

TEST(ErrorModel, NormalQuantiles) { // Abramowitz and Stegun, table 26.5
    EXPECT_NEAR(normalQuantile(0.5), 0, 1e-12);
    EXPECT_NEAR(normalQuantile(0.8), 0.8416212, 1e-7);
    EXPECT_NEAR(normalQuantile(0.98), 2.0537489, 1e-7);
    EXPECT_NEAR(normalQuantile(0.025), -1.9599640, 1e-7);
    EXPECT_NEAR(normalQuantile(0), -3.0902323, 1e-7); // 0.001
    EXPECT_NEAR(normalQuantile(1), 3.0902323, 1e-7);
}
