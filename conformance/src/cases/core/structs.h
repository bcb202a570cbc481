// The versioned structs by name, and memory for structs of any size.
#pragma once

#include "suite.h"

#include <cstring>

namespace agaa::conformance {

struct StructRow {
    std::string name;
    uint32_t sType;
    size_t size;      // size in these headers
    size_t firstSize; // size in version 0.2, or in the first version that has the struct; no host has a smaller one
    std::vector<unsigned char> initial;                                             // AGAA_…_INIT
    std::function<void(const Functions&, void* structure, size_t structSize)> init; // agaaInit…
};

const std::vector<StructRow>& versionedStructs();
const StructRow& versionedStruct(const std::string& name);

// Memory with the alignment of structs, filled with a pattern.
class Bytes {
public:
    static constexpr unsigned char pattern = 0xEE;
    explicit Bytes(size_t size) : size_(size), words_((size + 7) / 8, 0xEEEEEEEEEEEEEEEEu) {}
    unsigned char* data() { return reinterpret_cast<unsigned char*>(words_.data()); }
    const unsigned char* data() const { return reinterpret_cast<const unsigned char*>(words_.data()); }
    size_t size() const { return size_; }
    AgaaStructHeader& header() { return *reinterpret_cast<AgaaStructHeader*>(words_.data()); }
    bool operator==(const Bytes&) const = default;
    // Returns the index of the first byte from `from` on that is not `value`, or size().
    size_t findDifference(size_t from, size_t to, unsigned char value) const;

private:
    size_t size_;
    std::vector<uint64_t> words_;
};

// Returns whether two structs have the same bytes, padding included.
template <class T> bool isSameBytes(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Returns whether the library has the version of these headers, and so knows nothing beyond them.
inline bool isSameVersion(const Test& test) { return test.sdk.agaaGetVersion() == AGAA_HEADER_VERSION; }

// A type that libraries of this soname are unlikely to use.
constexpr uint32_t farStructType = 0x3FFFFFF0;

} // namespace agaa::conformance
