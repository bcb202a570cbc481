// Errors of a sequence of frames against a sequence of references.
#pragma once

#include "image/image.h"
#include "render/motion_image.h"

#include <optional>
#include <vector>

namespace harness {

// Tells which pixels show a surface that another one hid a short time ago.
class Disocclusion {
public:
    static constexpr uint32_t frames = 8; // for which a pixel counts as disoccluded

    // Adds the next frame. A surface was hidden if the pixels at its place in the previous frame showed nearer ones, by
    // more than a 50th of the distance, or if the place was outside of the image. Pixels that have less than a fifth of
    // the place do not count.
    void add(const MotionImage& motion);
    // Returns whether the pixel's surface became visible within the last `frames` frames.
    bool isNew(size_t pixel) const { return age_[pixel] < frames; }
    bool wasVisible(size_t pixel) const { return age_[pixel] > 0; } // in the previous frame
    double share() const;                                           // of the pixels that are new

private:
    std::vector<float> distance_; // of the newest frame
    std::vector<uint32_t> age_;   // frames since the pixel's surface became visible
};

// All errors are of tone-mapped values.
struct MotionError {
    std::vector<double> frames; // mean square error of each frame
    double error = 0;           // its mean
    // Root of the mean square of the change of the error from frame to frame, where a surface stays visible.
    double flicker = 0;
    std::optional<double> ghosting; // mean square error of new pixels; none if there are none
    double sharpness = 0; // the reference's differences from its 3 x 3 means, as far as the image has them; 1: all
    std::vector<double> response; // per frame: share of the change of light since `since` that the image shows
};

class MotionErrorMeter {
public:
    static constexpr uint32_t settling = 8; // first frames, of which only MotionError::frames has the error

    // since   The frame from which changes of the image are measured; none: no response.
    explicit MotionErrorMeter(std::optional<uint32_t> since = {}) : since_(since) {}
    // Adds a frame. All images have the same size. `disocclusion` has the frame's motion.
    void add(const Image& image, const Image& reference, const MotionImage& motion, const Disocclusion& disocclusion);
    MotionError result() const; // requires more than `settling` frames

private:
    void addSharpness(const Image& image, const Image& reference);
    void addResponse(const Image& image, const Image& reference);

    struct Mean {
        double sum = 0, count = 0;
        void add(double value) { sum += value, ++count; }
        double value() const { return count ? sum / count : 0; }
    };
    std::optional<uint32_t> since_;
    std::vector<float> error_; // of the newest frame, per channel
    std::vector<double> frames_, response_;
    Mean changes_, ghosting_;
    double detail_ = 0, referenceDetail_ = 0;
    Image imageBefore_, referenceBefore_; // of the frame since_
};

} // namespace harness
