// How an image's error moves when the camera does, by parts of a pixel.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <vector>

namespace harness {

// After tone mapping, means over pixels and channels. The mean squared error over time is biasSquared + variance.
struct TemporalError {
    double biasSquared = 0; // of the error's mean over time
    double variance = 0;    // of the error over time
    double flicker = 0;     // standard deviation of the image over time, by that of the reference; 0 / 0 is 1
};

class TemporalAccumulator {
public:
    // Of one shift; all of one size.
    void add(const Image& image, const Image& reference);
    TemporalError result() const; // of at least one shift

private:
    struct Sums {
        double image = 0, image2 = 0, reference = 0, reference2 = 0, error = 0, error2 = 0;
    };
    std::vector<Sums> sums_;
    uint32_t count_ = 0;
};

} // namespace harness
