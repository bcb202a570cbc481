// The state of an OpenGL context: made unusual, and read, to see whether the SDK changes it.
#pragma once

#include "suite.h"

#include <cstdint>
#include <utility>

namespace agaa::conformance {

// Values by the names of states, in the order of reading.
using OpenGlState = std::vector<std::pair<std::string, std::vector<int64_t>>>;

OpenGlState readOpenGlState();
// Sets everything that can be set to other values than the initial ones, with objects that remain until the context is
// destroyed.
void makeStateUnusual();

} // namespace agaa::conformance
