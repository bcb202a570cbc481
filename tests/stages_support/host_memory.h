// A host's allocator, which knows what it gave.
#pragma once

#include "agaa_sdk.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace agaa::test {

struct HostMemory {
    std::set<void*> blocks;
    size_t calls = 0;

    template <class Desc>
    void useFor(Desc& context) {
        context.allocate = allocate;
        context.free = free;
        context.allocateUser = this;
    }
    static void* AGAA_CALL allocate(void* user, size_t size, size_t alignment) {
        auto& memory = *static_cast<HostMemory*>(user);
        ++memory.calls;
        void* block = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        memory.blocks.insert(block);
        return block;
    }
    static void AGAA_CALL free(void* user, void* block) {
        EXPECT_EQ(static_cast<HostMemory*>(user)->blocks.erase(block), 1u);
        std::free(block);
    }
};

} // namespace agaa::test
