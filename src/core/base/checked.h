// 64-bit arithmetic that reports overflow. Surface sizes depend on values of the host (hard case 38).
#pragma once

#include "core/base/error.h"

#include <cstdint>

namespace agaa {

inline uint64_t checkedMultiply(uint64_t a, uint64_t b) {
    uint64_t product = 0;
    if (__builtin_mul_overflow(a, b, &product))
        fail(AGAA_ERROR_TOO_LARGE, "a surface's size does not fit 64 bits.");
    return product;
}

inline uint64_t checkedAdd(uint64_t a, uint64_t b) {
    uint64_t sum = 0;
    if (__builtin_add_overflow(a, b, &sum))
        fail(AGAA_ERROR_TOO_LARGE, "the sum of the surfaces' sizes does not fit 64 bits.");
    return sum;
}

inline uint64_t alignUp(uint64_t value, uint64_t alignment) {
    return checkedAdd(value, alignment - 1) / alignment * alignment;
}

} // namespace agaa
