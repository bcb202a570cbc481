// Times of a view's passes, from the device's timestamps. If the driver's timestamps are wrong, the times are those of
// the CPU's clock around glFinish.
#pragma once

#include "gl/context.h"

#include <chrono>
#include <vector>

namespace agaa::gl {

// Returns the difference of two timestamps of counters with `bits` bits in [1, 64], which wrap. The result can be
// negative: a pass that began but did not end keeps the end of an earlier frame.
inline double millisecondsBetween(GLuint64 begin, GLuint64 end, uint32_t bits) {
    const uint32_t unused = 64 - bits;
    return double(int64_t((end - begin) << unused) >> unused) * 1e-6;
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
