// LDR-FLIP: how visible the difference is when a viewer flips between two images.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator
// for Alternating Images", HPG 2020.
#pragma once

#include "image/image.h"

#include <vector>

namespace harness {

// Returns the error of each pixel in [0, 1], rows from top to bottom. Both images hold sRGB-encoded display values;
// values outside [0, 1] are clamped. The images must be finite and of equal size.
std::vector<float> flipErrorMap(const Image& reference, const Image& test, double pixelsPerDegree);

// Returns the quantile of the values at the given fraction, interpolated linearly between the two nearest order
// statistics. `values` must not be empty.
double percentile(std::vector<float> values, double fraction);

} // namespace harness
