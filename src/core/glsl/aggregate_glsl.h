// GLSL with which a shading pass of the host reads the aggregates of a plan.
#pragma once

#include "core/plan/plan.h"

#include <string>

namespace agaa {

// Throws Error if the plan has no aggregates in memory.
std::string aggregateGlsl(const Plan& plan);

} // namespace agaa
