// The resources that a draw pass's GLSL declares, for engines that set or describe every uniform of their shaders.
#pragma once

#include "core/frame/host_pass.h"

#include <string_view>
#include <vector>

namespace agaa {

// Returns what the preprocessed text declares, in its order, without stages. The numbers of layouts and arrays are
// literals there. Names that are too long for AgaaGlslResource are cut off.
std::vector<AgaaGlslResource> declaredResources(std::string_view preprocessed);

// Returns what the texts of a draw pass declare under names that begin with `agaa_`.
std::vector<AgaaGlslResource> glslResources(const HostPass& pass);

} // namespace agaa
