// GLSL for attributes of the host's own: the macros of src/shaders/passes/custom.glsl.
#pragma once

#include "core/layout.h"

#include <string>

namespace agaa {

std::string customGlsl(const Layout& layout); // empty where the layout has none

} // namespace agaa
