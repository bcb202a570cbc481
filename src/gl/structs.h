// The rows of the versioned structs of OpenGL.
#pragma once

#include "agaa_gl.h"
#include "core/base/structs.h"

namespace agaa {

#define AGAA_GL_STRUCT AGAA_STRUCT_ROW
#include "core/base/structs.inc"

} // namespace agaa
