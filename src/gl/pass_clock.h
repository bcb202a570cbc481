// Times of a view's passes, from the device's timestamps. If the driver's timestamps are wrong, the times are those of
// the CPU's clock around glFinish.
#pragma once

#include "core/base/timestamps.h"
#include "core/plan/plan.h"
#include "gl/context.h"

#include <chrono>
#include <span>
#include <vector>

namespace agaa::gl {

// Returns elapsedTicks(), which are nanoseconds in OpenGL, in milliseconds.
inline double millisecondsBetween(GLuint64 begin, GLuint64 end, uint32_t bits) {
    return double(elapsedTicks(begin, end, bits)) * 1e-6;
}

class PassClock {
public:
    // steps: those of the view, which outlives the clock.
    PassClock(const Context& context, std::span<const Step> steps, size_t passCount, uint32_t slotCount);
    ~PassClock();
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;

    void begin(uint32_t slot, size_t step);
    void end(uint32_t slot, size_t step);
    // A step without work. Its time of an earlier frame no longer counts.
    void skip(uint32_t slot, size_t step) { hasTime_[index(slot, step)] = false; }
    std::vector<double> milliseconds(uint32_t slot) const; // of each pass: the sum of its steps

private:
    size_t index(uint32_t slot, size_t step) const { return slot * steps_.size() + step; }
    double millisecondsOf(size_t index) const;

    const Context& context_;
    std::span<const Step> steps_;
    size_t passCount_;
    std::vector<GLuint> queries_; // two per step and slot
    std::vector<double> times_;   // per step and slot
    std::vector<bool> hasTime_;   // per step and slot
    std::chrono::steady_clock::time_point begin_;
};

} // namespace agaa::gl
