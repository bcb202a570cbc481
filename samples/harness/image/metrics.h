// Error metrics between a reference and a test image of equal size.
#pragma once

#include "image/image.h"

namespace harness {

struct Metrics {
    double mse = 0;              // linear, mean over pixels and channels
    double mseTm = 0;            // mean square error after x/(1+x), then ^(1/2.2)
    double relMse = 0;           // mean of (a-b)^2 / (reference^2 + 1e-2)
    double psnr = 0;             // PSNR of mseTm in dB; infinite for equal images
    double psnrPeak = 1;         // peak value of the PSNR
    double flip = 0;             // LDR-FLIP mean on the tone-mapped images (Andersson et al. 2020)
    double flipP95 = 0;          // 95th percentile of FLIP
    double maxAbs = 0;           // largest linear channel difference
    double meanAbsTm = 0;        // mean over pixels and channels, tone-mapped
    double above4 = 0;           // share of pixels with a tone-mapped channel that differs by more than 4/255
    double pixelsPerDegree = 67; // viewing condition of FLIP
};

// Throws std::runtime_error if sizes differ or a channel is not finite.
Metrics compareImages(const Image& reference, const Image& test);

} // namespace harness
