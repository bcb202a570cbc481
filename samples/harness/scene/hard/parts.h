// Parts that the scenes of hard cases share.
#pragma once

#include "scene/builtin/mesh_builder.h"
#include "scene/hard/scenes.h"

namespace harness::hard {

// Returns the index of a new material. The colour is linear.
uint32_t addLinear(Scene& scene, const char* name, const glm::vec3& color, float roughness, float metallic = 0);
// Returns the index of a new material that emits and reflects nothing.
uint32_t addEmitter(Scene& scene, const char* name, const glm::vec3& emission);

// Adds a rectangle at one depth that faces the camera.
void addRectangle(builtin::MeshBuilder& mesh, const glm::vec2& low, const glm::vec2& high, float z);
// Adds a mesh once.
void placeMesh(Scene& scene, const builtin::MeshBuilder& mesh, uint32_t material);
// Adds a wall behind everything in the view of frontCamera().
void addBackdrop(Scene& scene, float z, const glm::vec3& color);

// Adds a directional light. The direction need not be unit.
Light& addSun(Scene& scene, const glm::dvec3& direction, const glm::vec3& color);
Light& addLamp(Scene& scene, const glm::dvec3& position, const glm::vec3& intensity, float radius);

} // namespace harness::hard
