// Indices of draws whose vertex shader expands triangles (AGAA_VIEW_VERTEX_PULLING).
#pragma once

#include <cstdint>
#include <vector>

namespace harness {

constexpr uint32_t stripVertices = 8; // AGAA_MAX_STRIP
constexpr uint32_t stripIndexCount = 3 * (stripVertices - 2);
constexpr uint32_t stripsPerDraw = 4096; // a larger mesh takes several draws, with another first vertex

// The strips of stripsPerDraw triangles as a list of triangles, so that vertices are shaded once and no strip needs a draw or
// an instance of its own. Vertex k of the strip of triangle t is 8 t + k.
std::vector<uint32_t> stripIndices();

} // namespace harness
