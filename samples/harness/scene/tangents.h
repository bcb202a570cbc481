// Tangent frames for normal maps.
#pragma once

#include "scene/scene.h"

#include <span>

namespace harness {

// Sets the tangents of vertices from positions, normals and uv. Frames follow glTF: cross(normal, tangent) * w points
// against v, like the green channel of a normal map. Indices are relative to the span. A vertex with degenerate uv gets
// any unit vector perpendicular to its normal.
void generateTangents(std::span<Vertex> vertices, std::span<const uint32_t> indices);
// Returns the normalised part of a tangent that is perpendicular to the unit normal, or any perpendicular vector if
// there is none.
glm::vec3 tangentAcross(const glm::vec3& normal, const glm::vec3& tangent);
// Gives each triangle its own vertices, with the normal of the triangle, or +y if the triangle has no area.
void makeFlat(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices);

} // namespace harness
