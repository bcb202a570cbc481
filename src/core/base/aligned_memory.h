// Aligned memory of the C library, whose functions Windows lacks.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace agaa {

// alignment: a power of two. Returns null if there is no memory.
inline void* allocateAligned(size_t size, size_t alignment) {
#ifdef _WIN32
    return _aligned_malloc(size, alignment);
#else
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

inline void freeAligned(void* memory) {
#ifdef _WIN32
    _aligned_free(memory);
#else
    std::free(memory);
#endif
}

} // namespace agaa
