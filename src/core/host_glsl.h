// The GLSL that a host's fragment shader includes for one draw pass, assembled from a plan.
#pragma once

#include "core/plan.h"

#include <string>

namespace agaa {

std::string hostExtensions(const Plan& plan, const Pass& pass);
// descriptorSet: index at which the host binds the SDK's set.
std::string hostDeclarations(const Plan& plan, const Pass& pass, uint32_t descriptorSet);

// Differs between passes for which a host needs other shaders or pipelines, and only then.
uint64_t hostPassKey(const Plan& plan, const Pass& pass);

} // namespace agaa
