// GLSL for attributes of the host's own: the macros of src/shaders/common/custom.glsl.
#pragma once

#include "core/view/layout.h"

#include <string>

namespace agaa {

std::string customGlsl(const Layout& layout); // empty where the layout has none

} // namespace agaa
