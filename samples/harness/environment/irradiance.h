// Irradiance by the direction of a surface, as spherical harmonics (Ramamoorthi and Hanrahan 2001, "An Efficient
// Representation for Irradiance Environment Maps"). Nine coefficients suffice, because a surface averages light over a
// hemisphere: their mean error is about 1 % of photographs of places.
#pragma once

#include "environment/sphere_image.h"

#include <array>

namespace harness {

// Coefficients of irradiance / pi, which is the radiance of a white diffuse surface, in the order 1, y, z, x, xy, yz,
// 3 z^2 - 1, xz, x^2 - y^2 of the polynomials that shaders evaluate.
using Irradiance = std::array<glm::vec3, 9>;

Irradiance makeIrradiance(const SphereImage& image);

// Returns irradiance / pi of a surface with a unit normal, at least 0. shaders/environment.glsl has the same function
// for aggregates.
glm::vec3 irradianceAt(const Irradiance& irradiance, const glm::vec3& normal);

} // namespace harness
