#include "core/base/arguments.h"

#include <bit>
#include <string>

namespace agaa {

void checkRange(double value, double low, double high, const char* name) {
    if (!(value >= low && value <= high)) // also false for NaN
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %g, outside [%g;%g].", name, value, low, high));
}

void checkRange(uint64_t value, uint64_t low, uint64_t high, const char* name) {
    if (value < low || value > high)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("%s is %llu, outside [%llu;%llu].", name, static_cast<unsigned long long>(value),
                    static_cast<unsigned long long>(low), static_cast<unsigned long long>(high)));
}

void checkFlags(uint64_t flags, uint64_t known, const char* name) {
    if (flags & ~known)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s has the bits 0x%llx, which this library does not know.", name,
                                             static_cast<unsigned long long>(flags & ~known)));
}

void checkReserved(uint64_t value, const char* name) {
    if (value != 0)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is reserved and must be 0.", name));
}

void checkSampleCount(uint32_t samples, const char* name) {
    if (samples < 1 || samples > 32 || !std::has_single_bit(samples))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %u, not one of 1, 2, 4, 8, 16, 32.", name, samples));
}

void checkHeaderVersion(uint32_t version) {
    if ((version >> 12) != (AGAA_HEADER_VERSION >> 12))
        fail(AGAA_ERROR_VERSION, format("the host was built for version %u.%u, this library is %u.%u.", version >> 22,
                                        version >> 12 & 0x3FF, AGAA_VERSION_MAJOR, AGAA_VERSION_MINOR));
}

} // namespace agaa
