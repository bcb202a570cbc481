// Placement of memory blocks so that blocks of disjoint lifetimes share memory.
#pragma once

#include <cstdint>
#include <vector>

namespace agaa {

struct ArenaBlock {
    uint64_t size = 0;
    uint64_t alignment = 1;
    uint32_t firstPass = 0;
    uint32_t lastPass = 0;
    uint64_t offset = 0; // out
};
// Places blocks so that blocks of disjoint lifetimes may share memory: sets their offsets. Returns the height of the
// arena.
uint64_t placeBlocks(std::vector<ArenaBlock>& blocks);

} // namespace agaa
