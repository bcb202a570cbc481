#include "shown.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace agaa::test {

void addAmbient(AgaaFrame& frame) { frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 0.25f; }

std::vector<float> withAlpha(std::span<const float> rgb) {
    std::vector<float> rgba;
    for (size_t i = 0; i < rgb.size(); i += 3)
        rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 1.0f});
    return rgba;
}

std::vector<float> withoutAlpha(std::span<const float> rgba) {
    std::vector<float> rgb;
    for (size_t i = 0; i < rgba.size(); i += 4)
        rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    return rgb;
}

size_t nonFinite(std::span<const float> rgb) {
    return size_t(std::ranges::count_if(rgb, [](float value) { return !std::isfinite(value); }));
}

double sumOf(std::span<const float> rgb) { return std::accumulate(rgb.begin(), rgb.end(), 0.0); }

static double toneMapped(float x) { return std::pow(double(x) / (1 + double(x)), 1 / 2.2); }

Difference compare(std::span<const float> a, std::span<const float> b) {
    double sum = 0;
    size_t far = 0;
    for (size_t p = 0; p < a.size(); p += 3) {
        double most = 0;
        for (size_t i = p; i < p + 3; ++i) {
            const double d = std::fabs(toneMapped(a[i]) - toneMapped(b[i]));
            sum += d * d;
            most = std::max(most, d);
        }
        far += most > 24.0 / 255;
    }
    return {-10 * std::log10(std::max(sum / double(a.size()), 1e-20)), 3 * double(far) / double(a.size())};
}

} // namespace agaa::test
