// A key that distinguishes views.
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace harness {

// Returns equal keys for equal views. The key is empty if a chained struct is unknown here: the view is then unique.
std::string viewKey(const AgaaViewDesc& desc);

} // namespace harness
