// LDR-FLIP written down from the paper once more: two-dimensional kernels, one plain sum a pixel,
// no code shared with the harness. Slow; for small images.
#pragma once

#include "image/image.h"

#include <vector>

std::vector<double> directFlip(const harness::Image& reference, const harness::Image& test, double pixelsPerDegree);
