#include "image/metrics.h"

#include "image/check.h"
#include "image/flip.h"
#include "image/tonemap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace harness {

namespace {

void requireFinite(const Image& image, const std::string& what) {
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        if (std::isfinite(image.rgb[i]))
            continue;
        const size_t pixel = i / 3;
        throw std::runtime_error(what + " has a value that is not finite in channel " + "RGB"[i % 3] + " of pixel (" +
                                 std::to_string(pixel % image.width) + ", " + std::to_string(pixel / image.width) +
                                 ").");
    }
}

Image toneMapped(const Image& image) {
    Image out = image;
    std::transform(out.rgb.begin(), out.rgb.end(), out.rgb.begin(), [](float value) { return float(toneMap(value)); });
    return out;
}

} // namespace

Metrics compareImages(const Image& reference, const Image& test) {
    requireConsistent(reference, "The reference image");
    requireConsistent(test, "The test image");
    if (reference.width != test.width || reference.height != test.height)
        throw std::runtime_error("The reference image of " + sizeOf(reference) + " pixels and the test image of " +
                                 sizeOf(test) + " pixels differ in size.");
    requireFinite(reference, "The reference image");
    requireFinite(test, "The test image");

    Metrics out;
    size_t above = 0, counted = ~size_t(0); // the pixel counted last
    for (size_t i = 0; i < reference.rgb.size(); ++i) {
        const double a = reference.rgb[i];
        const double b = test.rgb[i];
        const double square = (a - b) * (a - b);
        const double mapped = toneMap(a) - toneMap(b);
        out.mse += square;
        out.mseTm += mapped * mapped;
        out.relMse += square / (a * a + 1e-2);
        out.maxAbs = std::max(out.maxAbs, std::abs(a - b));
        out.meanAbsTm += std::abs(mapped);
        if (std::abs(mapped) > 4.0 / 255 && counted != i / 3) {
            counted = i / 3;
            ++above;
        }
    }
    const auto values = double(reference.rgb.size());
    out.meanAbsTm /= values;
    out.above4 = double(above) / double(reference.pixelCount());
    out.mse /= values;
    out.mseTm /= values;
    out.relMse /= values;
    out.psnr = out.mseTm > 0 ? 10 * std::log10(out.psnrPeak * out.psnrPeak / out.mseTm)
                             : std::numeric_limits<double>::infinity();

    const std::vector<float> errors = flipErrorMap(toneMapped(reference), toneMapped(test), out.pixelsPerDegree);
    out.flip = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    out.flipP95 = percentile(errors, 0.95);
    return out;
}

} // namespace harness
