// The numbers of finished frames that choices are made of.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

// settings: the settings of the frames, without counts and times. previous: its counts or times are kept if the
// statistics have none and it has the same settings. Throws Error if the statistics are not valid.
AgaaObservation observe(const AgaaObservation& settings, const AgaaFrameStatistics& statistics,
                        const AgaaObservation& previous);

// Throws Error if a member is out of its range.
void checkObservation(const AgaaObservation& observation);

} // namespace agaa
