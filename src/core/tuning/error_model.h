// Errors of settings in one scene, predicted from the measured errors of others in that scene.
//
// The logarithms of the error shares of all settings are jointly normal, with the means and covariances of the table's
// scenes; each measurement has independent noise. The prediction is the conditional distribution (Rasmussen and
// Williams, Gaussian Processes for Machine Learning, 2006, section 2.2, as a sum over the scenes).
#pragma once

#include "core/tuning/cost_model.h"

#include <vector>

namespace agaa {

struct MeasuredShare {
    const ChoiceRow* row;
    float errorShare; // above 0
};

class ErrorModel {
public:
    explicit ErrorModel(std::span<const MeasuredShare> measured);

    // Returns the error share that is not exceeded with a probability, [1e-9, 1e9].
    float errorShare(const ChoiceRow& row, double probability) const;

private:
    using Vector = std::array<double, tableScenes>;
    Vector lowerSolution(Vector right) const; // of factor_ x = right
    Vector upperSolution(Vector right) const; // of the transposed factor_ x = right

    std::array<Vector, tableScenes> factor_{}; // Cholesky factor of the precision of the scenes' weights; lower
    Vector weights_{};                         // mean of the weights of the scenes
};

// Returns x so that a standard normal variable is at most x with the probability, which is clamped to [0.001, 0.999].
double normalQuantile(double probability);

} // namespace agaa
