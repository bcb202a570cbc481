// Random choices of the fuzz targets: from a seed, or from the bytes of a fuzzer that searches by coverage.
#pragma once

#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>

namespace fuzz {

class Choices {
public:
    Choices(uint64_t seed, uint64_t run) : state_(seed * 0x9E3779B97F4A7C15u ^ (run + 1) * 0xD1342543DE82EF95u) {}
    // Each choice takes the fewest bytes that it needs. At the end of the bytes all choices are 0 and oneIn() is false.
    explicit Choices(std::span<const uint8_t> bytes) : bytes_(bytes), hasBytes_(true) {}

    uint64_t bits(unsigned byteCount = 8) {
        uint64_t value = 0;
        if (!hasBytes_)
            return mixed();
        const size_t taken = byteCount < bytes_.size() ? byteCount : bytes_.size();
        if (taken > 0)
            std::memcpy(&value, bytes_.data(), taken);
        bytes_ = bytes_.subspan(taken);
        return value;
    }
    // Returns a number in [0, count).
    uint64_t below(uint64_t count) {
        const unsigned byteCount = count <= 0x100 ? 1 : count <= 0x10000 ? 2 : count <= UINT64_C(0x100000000) ? 4 : 8;
        return bits(byteCount) % count;
    }
    bool oneIn(uint64_t count) { return below(count) == count - 1; }
    template <class List> const auto& of(const List& list) { return list[below(std::size(list))]; }
    // Returns 32 bits: an ordinary number, a limit of a type, a float at the end of its range, or any bits.
    uint32_t word() {
        static const uint32_t words[] = {0,          1,          2,          3,          4,          7,
                                         8,          9,          16,         32,         64,         128,
                                         255,        4096,       65536,      0x3f800000, 0x7f800000, 0x7fc00000,
                                         0xff800000, 0x80000000, 0x7fffffff, 0xffffffff, 0x3f000000, 0x7f7fffff};
        const uint64_t kind = below(4);
        if (kind == 0)
            return uint32_t(bits(4));
        if (kind == 1)
            return uint32_t(1) << below(32);
        return of(words);
    }
    float number() {
        const uint32_t value = word();
        float number;
        std::memcpy(&number, &value, sizeof number);
        return number;
    }

private:
    uint64_t mixed() { // SplitMix64
        uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    uint64_t state_ = 0;
    std::span<const uint8_t> bytes_;
    bool hasBytes_ = false;
};

} // namespace fuzz
