#include "render/motion_error.h"

#include "image/tonemap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace harness {

namespace {

// Calls visit(pixel, weight) for the four pixels around a place, if it is inside of the image. Places are in pixels;
// the centre of the first one is at (0.5, 0.5).
template <class Visit> bool visitAround(const glm::vec2& place, uint32_t width, uint32_t height, const Visit& visit) {
    if (!(place.x >= 0 && place.y >= 0 && place.x <= float(width) && place.y <= float(height)))
        return false;
    const glm::vec2 corner = glm::floor(place - 0.5f), part = place - 0.5f - corner;
    for (int i = 0; i < 4; ++i) {
        const int x = std::clamp(int(corner.x) + (i & 1), 0, int(width) - 1);
        const int y = std::clamp(int(corner.y) + (i >> 1), 0, int(height) - 1);
        visit(size_t(y) * width + size_t(x), (i & 1 ? part.x : 1 - part.x) * (i >> 1 ? part.y : 1 - part.y));
    }
    return true;
}

glm::vec2 previousPlace(const MotionImage& motion, size_t pixel) {
    return glm::vec2(pixel % motion.width, pixel / motion.width) + 0.5f + motion.toPrevious[pixel];
}

// Returns the tone-mapped luma of each pixel without its mean over 3 x 3 pixels.
std::vector<double> detailOf(const Image& image) {
    std::vector<double> luma(image.pixelCount()), detail(image.pixelCount());
    for (size_t i = 0; i < luma.size(); ++i)
        luma[i] = 0.2126 * toneMap(image.rgb[3 * i]) + 0.7152 * toneMap(image.rgb[3 * i + 1]) +
                  0.0722 * toneMap(image.rgb[3 * i + 2]);
    for (int y = 0; y < int(image.height); ++y)
        for (int x = 0; x < int(image.width); ++x) {
            double sum = 0;
            for (int i = 0; i < 9; ++i)
                sum += luma[size_t(std::clamp(y + i / 3 - 1, 0, int(image.height) - 1)) * image.width +
                            size_t(std::clamp(x + i % 3 - 1, 0, int(image.width) - 1))];
            const size_t at = size_t(y) * image.width + size_t(x);
            detail[at] = luma[at] - sum / 9;
        }
    return detail;
}

} // namespace

void Disocclusion::add(const MotionImage& motion) {
    constexpr float leastWeight = 0.2f; // of the pixels that show a place; one has 1/4 at least
    const size_t pixels = motion.distance.size();
    std::vector<uint32_t> age(pixels, frames);
    for (size_t i = 0; i < pixels && !age_.empty(); ++i) {
        const float expected = motion.previousDistance[i];
        bool wasHidden = true;
        uint32_t oldest = 0;
        const bool isInside =
            visitAround(previousPlace(motion, i), motion.width, motion.height, [&](size_t pixel, float weight) {
                if (weight < leastWeight)
                    return;
                if (std::isinf(expected) ? std::isfinite(distance_[pixel]) : distance_[pixel] < 0.98f * expected)
                    return;
                wasHidden = false;
                oldest = std::max(oldest, age_[pixel]);
            });
        age[i] = !isInside || wasHidden ? 0 : std::min(oldest, frames - 1) + 1;
    }
    age_ = std::move(age);
    distance_ = motion.distance;
}

double Disocclusion::share() const {
    double count = 0;
    for (size_t i = 0; i < age_.size(); ++i)
        count += isNew(i);
    return age_.empty() ? 0 : count / double(age_.size());
}

void MotionErrorMeter::add(const Image& image, const Image& reference, const MotionImage& motion,
                           const Disocclusion& disocclusion) {
    const bool counts = frames_.size() >= settling;
    std::vector<float> error(image.rgb.size());
    double sum = 0;
    for (size_t i = 0; i < error.size(); ++i) {
        error[i] = float(toneMap(double(image.rgb[i])) - toneMap(double(reference.rgb[i])));
        sum += double(error[i]) * error[i];
    }
    for (size_t i = 0; counts && i < error.size(); ++i) {
        const size_t pixel = i / 3;
        if (disocclusion.isNew(pixel))
            ghosting_.add(double(error[i]) * error[i]);
        if (!disocclusion.wasVisible(pixel))
            continue;
        double before = 0;
        visitAround(previousPlace(motion, pixel), image.width, image.height,
                    [&](size_t at, float weight) { before += double(weight) * error_[3 * at + i % 3]; });
        changes_.add((error[i] - before) * (error[i] - before));
    }
    if (counts)
        addSharpness(image, reference);
    frames_.push_back(sum / double(error.size()));
    error_ = std::move(error);
    addResponse(image, reference);
}

void MotionErrorMeter::addSharpness(const Image& image, const Image& reference) {
    const std::vector<double> shown = detailOf(image), wanted = detailOf(reference);
    detail_ += std::inner_product(shown.begin(), shown.end(), wanted.begin(), 0.0);
    referenceDetail_ += std::inner_product(wanted.begin(), wanted.end(), wanted.begin(), 0.0);
}

void MotionErrorMeter::addResponse(const Image& image, const Image& reference) {
    const size_t frame = frames_.size() - 1;
    if (!since_ || frame < *since_)
        return;
    if (frame == *since_) {
        imageBefore_ = image;
        referenceBefore_ = reference;
        return;
    }
    double shown = 0, whole = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const double change = toneMap(double(reference.rgb[i])) - toneMap(double(referenceBefore_.rgb[i]));
        shown += (toneMap(double(image.rgb[i])) - toneMap(double(imageBefore_.rgb[i]))) * change;
        whole += change * change;
    }
    response_.push_back(whole > 0 ? shown / whole : 1);
}

MotionError MotionErrorMeter::result() const {
    MotionError out;
    out.frames = frames_;
    const auto counted = frames_.begin() + settling;
    out.error = std::accumulate(counted, frames_.end(), 0.0) / double(frames_.end() - counted);
    out.flicker = std::sqrt(changes_.value());
    if (ghosting_.count)
        out.ghosting = ghosting_.value();
    out.sharpness = referenceDetail_ > 0 ? detail_ / referenceDetail_ : 1;
    out.response = response_;
    return out;
}

} // namespace harness
