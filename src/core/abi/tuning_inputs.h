// Views and plans in the public terms that tuning needs.
#pragma once

#include "core/plan/plan.h"
#include "core/tuning/goals.h"

namespace agaa {

TunedView tunedView(const ViewSettings& settings, const AgaaDeviceCaps& caps);

// The settings of a view's frames, without counts and times. plan: made from `settings`.
AgaaObservation observedSettings(const ViewSettings& settings, const Plan& plan);

} // namespace agaa
