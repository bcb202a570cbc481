// The reason for a choice, in sentences.
#pragma once

#include "core/tuning/predictions.h"

#include <string>

namespace agaa {

// Settings that the view can have, with their predictions.
struct Candidate : Prediction {
    double milliseconds;
    uint64_t bytes;
};

// Writes AgaaChoice::reason. satisfying: the number of settings, of `count`, that satisfy all limits. waits: the
// current choice is kept until more of its frames were observed. firstExclusion: why the first excluded settings cannot
// be planned.
void explain(AgaaChoice& choice, const AgaaGoal& goal, const Predictions& predictions, size_t satisfying, size_t count,
             bool waits, const std::string& firstExclusion);

} // namespace agaa
