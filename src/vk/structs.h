// The rows of the versioned structs of Vulkan.
#pragma once

#include "agaa_vk.h"
#include "core/base/structs.h"

namespace agaa {

#define AGAA_VK_STRUCT AGAA_STRUCT_ROW
#include "core/base/structs.inc"

} // namespace agaa
