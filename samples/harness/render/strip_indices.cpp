#include "render/strip_indices.h"

namespace harness {

std::vector<uint32_t> stripIndices() {
    std::vector<uint32_t> indices;
    indices.reserve(stripsPerDraw * stripIndexCount);
    for (uint32_t strip = 0; strip < stripsPerDraw; ++strip)
        for (uint32_t i = 0; i + 2 < stripVertices; ++i) {
            const uint32_t first = strip * stripVertices + i, odd = i & 1; // odd triangles have opposite winding
            indices.insert(indices.end(), {first + odd, first + 1 - odd, first + 2});
        }
    return indices;
}

} // namespace harness
