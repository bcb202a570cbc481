#include "core/frame/context.h"

#include "core/base/aligned_memory.h"
#include "core/base/error.h"

namespace agaa {

void* HostAllocator::allocate(size_t size, size_t alignment) const {
    void* memory = allocateCallback ? allocateCallback(user, size, alignment) : allocateAligned(size, alignment);
    require(memory, AGAA_ERROR_OUT_OF_MEMORY, "host memory could not be allocated.");
    return memory;
}

void HostAllocator::free(void* memory) const {
    if (freeCallback)
        freeCallback(user, memory);
    else
        freeAligned(memory);
}

} // namespace agaa
