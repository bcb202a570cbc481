// How an image's error moves when the camera does: by parts of a pixel, and along a path.
#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace harness {

// After tone mapping, means over pixels and channels. The mean squared error over time is biasSquared + variance.
struct TemporalError {
    double biasSquared = 0; // of the error's mean over time
    double variance = 0;    // of the error over time
    double flicker = 0;     // standard deviation of the image over time, by that of the reference; 0 / 0 is 1
};

// Frame t of a walk to the side, with which what the camera aims at moves 1.3 pixels a frame, what is nearer more
// and what is farther less. height: of the image, in pixels.
Camera pathCamera(Camera camera, uint32_t frame, uint32_t height);

class TemporalAccumulator {
public:
    // Of one frame; all of one size.
    void add(const Image& image, const Image& reference);
    uint32_t count() const { return count_; }
    TemporalError result() const; // of at least one frame

private:
    struct Sums {
        double image = 0, image2 = 0, reference = 0, reference2 = 0, error = 0, error2 = 0;
    };
    std::vector<Sums> sums_;
    uint32_t count_ = 0;
};

} // namespace harness
