// What tells one view from another.
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace harness {

// Equal for equal views; empty where chained structs, which are unknown here, make the view one of its kind.
std::string viewKey(const AgaaViewDesc& desc);

} // namespace harness
