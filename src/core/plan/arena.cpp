#include "core/plan/arena.h"

#include "core/base/checked.h"

#include <algorithm>

namespace agaa {

uint64_t placeBlocks(std::vector<ArenaBlock>& blocks) {
    // Blocks are placed in descending order of size, each at the lowest offset that no block with an overlapping
    // lifetime covers.
    std::vector<size_t> order(blocks.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return blocks[a].size > blocks[b].size; });
    uint64_t height = 0;
    for (size_t i = 0; i < order.size(); ++i) {
        ArenaBlock& block = blocks[order[i]];
        std::vector<const ArenaBlock*> neighbours;
        for (size_t j = 0; j < i; ++j) {
            const ArenaBlock& other = blocks[order[j]];
            if (other.firstPass <= block.lastPass && block.firstPass <= other.lastPass)
                neighbours.push_back(&other);
        }
        std::sort(neighbours.begin(), neighbours.end(),
                  [](const ArenaBlock* a, const ArenaBlock* b) { return a->offset < b->offset; });
        block.offset = 0;
        for (const ArenaBlock* other : neighbours) {
            if (checkedAdd(block.offset, block.size) <= other->offset)
                break;
            block.offset = std::max(block.offset, alignUp(checkedAdd(other->offset, other->size), block.alignment));
        }
        height = std::max(height, checkedAdd(block.offset, block.size));
    }
    return height;
}

} // namespace agaa
