#include "sweep/temporal.h"

#include "image/tonemap.h"

#include <algorithm>
#include <cmath>

namespace harness {

void TemporalAccumulator::add(const Image& image, const Image& reference) {
    sums_.resize(image.rgb.size());
    for (size_t i = 0; i < sums_.size(); ++i) {
        const double a = toneMap(double(image.rgb[i])), r = toneMap(double(reference.rgb[i]));
        Sums& s = sums_[i];
        s.image += a;
        s.image2 += a * a;
        s.reference += r;
        s.reference2 += r * r;
        s.error += a - r;
        s.error2 += (a - r) * (a - r);
    }
    ++count_;
}

TemporalError TemporalAccumulator::result() const {
    const double count = double(count_);
    // With values in [0, 1] and few frames, the difference of sums keeps enough digits.
    const auto variance = [&](double sum, double sum2) {
        return std::max(sum2 / count - (sum / count) * (sum / count), 0.0);
    };
    TemporalError out;
    double image = 0, reference = 0;
    for (const Sums& s : sums_) {
        out.biasSquared += (s.error / count) * (s.error / count);
        out.variance += variance(s.error, s.error2);
        image += variance(s.image, s.image2);
        reference += variance(s.reference, s.reference2);
    }
    out.biasSquared /= double(sums_.size());
    out.variance /= double(sums_.size());
    out.flicker = reference > 0 ? std::sqrt(image / reference) : image > 0 ? INFINITY : 1;
    return out;
}

} // namespace harness
