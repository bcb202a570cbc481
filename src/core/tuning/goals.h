// Settings for a goal: the table of choices against limits of error, time and memory. It needs public data only; the
// caller plans the view.
#pragma once

#include "core/tuning/cost_model.h"

#include <functional>

namespace agaa {

// The cost of settings, known from their plan.
struct PlannedCost {
    uint64_t bytes = 0;          // of all surfaces, as AgaaMemoryReport::totalBytes
    uint32_t geometryPasses = 0; // as AgaaTarget::geometryPasses
};

// The view that settings are chosen for.
struct TunedView {
    AgaaSceneFacts facts{};
    uint64_t pixels = 0;
    // Plans the view with the settings of a row. Throws Error if it cannot have them.
    std::function<PlannedCost(const ChoiceRow& row)> plan;
};

// Implements agaaChooseSettings. Throws Error if a number is out of its range or no settings can be planned.
AgaaChoice chooseSettings(const TunedView& view, const AgaaGoal& goal, const AgaaObservation& observation,
                          const AgaaChoice& current);

// Sets what a row of the table determines. measurement may be null.
void applySettings(const ChoiceRow& row, AgaaConfig& config, AgaaAggregation& aggregation,
                   AgaaMeasurement* measurement);
// Throws Error if the table lacks the settings of the choice; the arguments are then unchanged.
void applyChoice(const AgaaChoice& choice, AgaaConfig& config, AgaaAggregation& aggregation,
                 AgaaMeasurement* measurement);

} // namespace agaa
