// A valid goal, observation and choice with their view; tests change some of them.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

struct GoalParts : ViewParts {
    explicit GoalParts(const Functions& sdk);

    AgaaGoal goal;
    AgaaMeasuredSettings measured[2]; // "single" and "ssaa", n=8, with errors and times; useMeasured() adds them to the
                                      // goal
    AgaaObservation observation;      // an observation of "ssaa", n=8
    AgaaChoice current;               // "ssaa", n=8
    AgaaChoice choice;                // initialised
    AgaaFrameStatistics statistics;

    void useMeasured() {
        goal.measured = measured;
        goal.measuredCount = 2;
    }
    AgaaResult choose(Test& test, const AgaaLog* log) {
        return test.sdk.agaaChooseSettings(get(), &caps, log, &goal, &observation, &current, &choice);
    }
    AgaaResult observe(Test& test, const AgaaLog* log) {
        return test.sdk.agaaObserve(get(), &caps, log, &statistics, &observation);
    }
};

} // namespace agaa::conformance
