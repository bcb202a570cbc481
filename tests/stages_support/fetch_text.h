// The functions by which the tier ids fetches the known triangles of the small hosts.
#pragma once

#include "shown.h"

#include <string>

namespace agaa::test {

// GLSL. storage: vec3 hostPosition(uint vertex) and HostMaterial hostMaterial(uint primitive), a
// struct of the vectors of a Material. more: of agaaHostMaterial()'s text, after the material m is
// set. moreOfTriangles: of agaaHostTriangle()'s, after its corners are set. `spare` has Material::specular.w and
// emissive.w in both.
std::string fetchText(const ViewSettings& settings, const char* storage, const char* more = "",
                      const char* moreOfTriangles = "");
// By the text, which stays where it is; announces what the shot says.
AgaaFetchFunction fetchFunction(const ViewSettings& settings, const std::string& text, const Shot& shot);

} // namespace agaa::test
