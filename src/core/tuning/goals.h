// Settings for a goal: the table of choices against limits of error, time and memory.
#pragma once

#include "core/view/view_settings.h"

namespace agaa {

// As agaaChooseSettings. Throws Error where a number is out of its range, or no settings can be planned.
AgaaChoice chooseSettings(const ViewSettings& view, const AgaaDeviceCaps& caps, const AgaaGoal& goal,
                          const AgaaObservation& observation, const AgaaChoice& current);

// Throws Error where the choice has settings that are not in the table. All are then unchanged.
void applyChoice(const AgaaChoice& choice, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);

} // namespace agaa
