// Tangent frames for normal maps.
#pragma once

#include "scene/scene.h"

#include <span>

namespace harness {

// Frames as glTF has them: cross(normal, tangent) * w points against v, as a normal map's green
// does. Sets vertices' tangents from positions, normals and uv; indices are relative to the span. A
// vertex without a direction (degenerate uv) gets any unit vector across its normal.
void generateTangents(std::span<Vertex> vertices, std::span<const uint32_t> indices);
// The part of a tangent across the unit normal as a unit vector, or any where there is none.
glm::vec3 tangentAcross(const glm::vec3& normal, const glm::vec3& tangent);
// Area-weighted smooth normals; a vertex of no triangle gets +y.
void generateNormals(std::span<Vertex> vertices, std::span<const uint32_t> indices);

} // namespace harness
