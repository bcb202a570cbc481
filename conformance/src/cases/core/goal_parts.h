// A goal, an observation and a choice that are valid, with the view that they are of; tests change some of them.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

struct GoalParts : ViewParts {
    explicit GoalParts(const Functions& sdk);

    AgaaGoal goal;
    AgaaObservation observation; // of "ssaa", n=8
    AgaaChoice current;          // "ssaa", n=8
    AgaaChoice choice;           // initialised
    AgaaFrameStatistics statistics;

    AgaaResult choose(Test& test, const AgaaLog* log) {
        return test.sdk.agaaChooseSettings(get(), &caps, log, &goal, &observation, &current, &choice);
    }
    AgaaResult observe(Test& test, const AgaaLog* log) {
        return test.sdk.agaaObserve(get(), &caps, log, &statistics, &observation);
    }
};

} // namespace agaa::conformance
