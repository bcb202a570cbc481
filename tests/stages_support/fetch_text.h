// The functions by which the tier ids fetches the known triangles of the small hosts.
#pragma once

#include "shown.h"

#include <string>

namespace agaa::test {

// GLSL. storage: vec3 hostPosition(uint vertex), HostMaterial hostMaterial(uint primitive), a struct of the vectors of
// a Material, and uint hostSeed(HostMaterial h). The shot has further text of the functions, after material, corners
// and draws are set. `spare` has Material::specular.w and emissive.w in the first two.
std::string fetchText(const ViewSettings& settings, const char* storage, const Shot& shot);
// By the text, which stays where it is; announces what the shot says.
AgaaFetchFunction fetchFunction(const ViewSettings& settings, const std::string& text, const Shot& shot);

} // namespace agaa::test
