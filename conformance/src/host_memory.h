// Memory that a host of the suite hands to the library.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace agaa::conformance {

// alignment: a power of two. Returns null if there is no memory.
inline void* allocateHostMemory(size_t size, size_t alignment) {
    alignment = std::max(alignment, sizeof(void*));
#ifdef _WIN32
    return _aligned_malloc(size, alignment);
#else
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

inline void freeHostMemory(void* memory) {
#ifdef _WIN32
    _aligned_free(memory);
#else
    std::free(memory);
#endif
}

} // namespace agaa::conformance
