// PCG32 (O'Neill 2014). It gives the same numbers on every machine, which std distributions do not guarantee.
#pragma once

#include <cmath>
#include <cstdint>

namespace harness {

class Random {
public:
    explicit Random(uint64_t seed) {
        next();
        state_ += seed;
        next();
    }
    uint32_t next() {
        const uint64_t old = state_;
        state_ = old * 6364136223846793005ull + 1442695040888963407ull;
        const uint32_t shifted = uint32_t(((old >> 18) ^ old) >> 27);
        const uint32_t rotation = uint32_t(old >> 59);
        return (shifted >> rotation) | (shifted << ((32 - rotation) & 31));
    }
    float unit() { return float(next() >> 8) * (1.0f / 16777216.0f); } // [0, 1)
    float in(float low, float high) { return low + (high - low) * unit(); }
    uint32_t below(uint32_t count) { return uint32_t(uint64_t(next()) * count >> 32); }

private:
    uint64_t state_ = 0;
};

} // namespace harness
