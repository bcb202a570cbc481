// Indices of draws whose vertex shader expands triangles (AGAA_VIEW_VERTEX_PULLING).
#pragma once

#include <cstdint>
#include <vector>

namespace harness {

constexpr uint32_t stripVertices = 8; // AGAA_MAX_STRIP
constexpr uint32_t stripIndexCount = 3 * (stripVertices - 2);
constexpr uint32_t stripsPerDraw = 4096; // a larger mesh takes more draws, with different first vertices

// Returns the strips of stripsPerDraw triangles as a triangle list, so that vertices are shaded once and a strip needs
// no draw or instance. Vertex k of the strip of triangle t is 8 t + k.
std::vector<uint32_t> stripIndices();

} // namespace harness
