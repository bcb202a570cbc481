// GLSL by which a host's own shading pass reads the aggregates of a plan.
#pragma once

#include "core/plan/plan.h"

#include <string>

namespace agaa {

// Throws Error where the plan leaves none in memory.
std::string aggregateGlsl(const Plan& plan);

} // namespace agaa
