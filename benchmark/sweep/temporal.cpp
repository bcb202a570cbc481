#include "sweep/temporal.h"

#include "image/tonemap.h"

#include <algorithm>
#include <cmath>

namespace harness {

Camera pathCamera(Camera camera, uint32_t frame, uint32_t height) {
    const glm::dvec3 forward = camera.target - camera.eye;
    glm::dvec3 right = glm::cross(forward, camera.up);
    if (glm::length(right) <= 1e-9 * glm::length(forward) * glm::length(camera.up)) // looks along up
        right = std::abs(forward.x) <= std::abs(forward.y) ? glm::dvec3(0, forward.z, -forward.y)
                                                           : glm::dvec3(-forward.z, 0, forward.x);
    const double pixel = 2 * std::tan(glm::radians(camera.fovDegrees) / 2) * glm::length(forward) / height;
    const double length = glm::length(right);
    const glm::dvec3 step = length > 0 ? right * (1.3 * pixel * frame / length) : glm::dvec3(0);
    camera.eye += step;
    camera.target += step;
    return camera;
}

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
