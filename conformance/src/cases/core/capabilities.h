// Devices by their capabilities, and what agaaQueryCapabilities lists for them.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

// From an ideal device to one that has nothing.
std::vector<AgaaDeviceCaps> capsOfDevices(Test& test);
std::vector<AgaaCapability> capabilitiesOf(Test& test, const AgaaDeviceCaps* caps);

} // namespace agaa::conformance
