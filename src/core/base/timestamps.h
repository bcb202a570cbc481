// Differences of the timestamps of counters that wrap (hard case 57).
#pragma once

#include <cstdint>

namespace agaa {

// Returns the ticks between two timestamps of a counter with `bits` bits in [1, 64]. The bits above may have any value.
// The result is negative if the end precedes the begin.
inline int64_t elapsedTicks(uint64_t begin, uint64_t end, uint32_t bits) {
    const uint32_t unused = 64 - bits;
    return int64_t((end - begin) << unused) >> unused;
}

// Returns whether a measured time can be that of a pass. Timestamps of different frames have a negative difference or
// one of hours.
inline bool isPassTime(double milliseconds) { return milliseconds >= 0.0 && milliseconds <= 1e7; }

// Adds the time of a step to that of its pass, which is no time of a pass if one of its steps has none.
inline void addStepTime(double& pass, double step) { pass = isPassTime(pass) && isPassTime(step) ? pass + step : -1; }

} // namespace agaa
