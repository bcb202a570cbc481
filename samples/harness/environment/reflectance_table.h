// The share of light from everywhere that a lobe reflects, by its roughness and the angle to the eye: the second sum of
// the split-sum approximation (Karis 2013). The lobe is that of the library: GGX with Smith's height-correlated term
// and Schlick's Fresnel term.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace harness {

constexpr uint32_t reflectanceSteps = 32;

// Returns rows of growing roughness, sqrt(alpha), from 0 to 1, each with growing cosines between the normal and the
// direction to the eye, from 0 to 1. The reflectance is F0 x + y.
std::vector<glm::vec2> makeReflectanceTable();

} // namespace harness
