// Surfaces of a plan as hosts see them.
#pragma once

#include "core/plan/plan.h"

namespace agaa {

AgaaSurface describeSurface(const Plan& plan, ResourceId id);

} // namespace agaa
