// Surfaces of a plan as the public struct describes them.
#pragma once

#include "core/plan/plan.h"

namespace agaa {

AgaaSurface describeSurface(const Plan& plan, ResourceId id);

} // namespace agaa
