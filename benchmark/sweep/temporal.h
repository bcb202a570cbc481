// Errors over time while the camera moves: by sub-pixel shifts, and along a path.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <vector>

namespace harness {

// Means over pixels and channels after tone mapping. The mean squared error over time is biasSquared + variance.
struct TemporalError {
    double biasSquared = 0; // the square of the error's mean over time
    double variance = 0;    // the variance of the error over time
    double flicker = 0;     // standard deviation of the image over time, divided by the reference's; 0 / 0 is 1
};

class TemporalAccumulator {
public:
    // Adds a frame. All images have the same size.
    void add(const Image& image, const Image& reference);
    uint32_t count() const { return count_; }
    TemporalError result() const; // requires at least one frame

private:
    struct Sums {
        double image = 0, image2 = 0, reference = 0, reference2 = 0, error = 0, error2 = 0;
    };
    std::vector<Sums> sums_;
    uint32_t count_ = 0;
};

} // namespace harness
