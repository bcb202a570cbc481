// Times of a view's passes, from the device's timestamps. If the driver's timestamps are wrong, the times are those of
// the CPU's clock around glFinish.
#pragma once

#include "core/base/timestamps.h"
#include "gl/context.h"

#include <chrono>
#include <vector>

namespace agaa::gl {

// Returns elapsedTicks(), which are nanoseconds in OpenGL, in milliseconds.
inline double millisecondsBetween(GLuint64 begin, GLuint64 end, uint32_t bits) {
    return double(elapsedTicks(begin, end, bits)) * 1e-6;
}

class PassClock {
public:
    PassClock(const Context& context, size_t passCount, uint32_t slotCount);
    ~PassClock();
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;

    void begin(uint32_t slot, size_t pass);
    void end(uint32_t slot, size_t pass);
    std::vector<double> milliseconds(uint32_t slot) const; // of each pass

private:
    size_t index(uint32_t slot, size_t pass) const { return slot * passCount_ + pass; }

    const Context& context_;
    size_t passCount_;
    std::vector<GLuint> queries_; // two per pass and slot
    std::vector<double> times_;
    std::vector<std::chrono::steady_clock::time_point> begins_; // by pass: repeated passes alternate
};

} // namespace agaa::gl
