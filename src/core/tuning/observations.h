// What finished frames showed, in the numbers that choices are made of.
#pragma once

#include "core/plan/plan.h"

namespace agaa {

// view: what the plan was made of. previous: its counts or times stay where the statistics have none, if they are of the same
// settings. Throws Error where the statistics are not valid.
AgaaObservation observe(const ViewSettings& view, const Plan& plan, const AgaaFrameStatistics& statistics,
                        const AgaaObservation& previous);

// Throws Error where a member is out of its range.
void checkObservation(const AgaaObservation& observation);

} // namespace agaa
