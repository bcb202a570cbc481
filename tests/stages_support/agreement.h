// Compares frames of programs that may round differently, and settles which of two draws at the same place is shown.
//
// Mesa's software rasterisers neither contract nor reorder sums, and run the fragments of a pixel one after another.
// Other devices promise neither: equal expressions of two programs may differ by rounding, and fragments arrive in any
// order unless the depth and stencil tests alone decide.
#pragma once

#include "triangles.h"

#include <agaa_sdk.h>

#include <span>

namespace agaa::test {

bool isInOrder(const AgaaDeviceCaps& caps);

// Bit by bit on software rasterisers; elsewhere up to a share of `rounding` of each value and of 1.
void expectSameImage(std::span<const float> got, std::span<const float> expected, const AgaaDeviceCaps& caps,
                     float rounding = 2e-5f);

// Where the device may run fragments in any order, triangles at the place of an earlier one are made like it: all, or
// those of pairs of which one is masked.
enum class Ties { Masked, All };
std::vector<Triangle> settleTies(std::vector<Triangle> triangles, const AgaaDeviceCaps& caps, Ties ties = Ties::Masked);

} // namespace agaa::test
