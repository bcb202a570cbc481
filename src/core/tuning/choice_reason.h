// Why a choice was made, in sentences.
#pragma once

#include "core/tuning/predictions.h"

#include <string>

namespace agaa {

// Settings that the view can have, as they are predicted.
struct Candidate : Prediction {
    double milliseconds;
    uint64_t bytes;
};

// Writes AgaaChoice::reason. holding: of `count` settings, those that hold all limits. waits: for more observations of the
// current choice. leftOutBecause: of the first one that was left out.
void explain(AgaaChoice& choice, const AgaaGoal& goal, const Predictions& predictions, size_t holding, size_t count, bool waits,
             const std::string& leftOutBecause);

} // namespace agaa
