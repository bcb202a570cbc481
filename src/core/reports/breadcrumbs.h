// The passes that the device reached last, for reports of a lost device.
#pragma once

#include "agaa_sdk.h"
#include "core/frame/view_state.h"

namespace agaa {

// Returns AGAA_NOT_READY, without a change of `out`, if the device has begun no pass. Throws Error if the view records
// no breadcrumbs.
AgaaResult breadcrumbs(const ViewState& view, AgaaBreadcrumbs& out);

} // namespace agaa
