// GLSL for custom attributes: the macros of src/shaders/common/custom.glsl.
#pragma once

#include "core/view/layout.h"

#include <string>

namespace agaa {

// Returns empty text if the layout has no custom attributes.
std::string customGlsl(const Layout& layout);

} // namespace agaa
