// Devices by their capabilities, and the entries of agaaQueryCapabilities for them.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

// Devices from an ideal device to one without capabilities.
std::vector<AgaaDeviceCaps> capsOfDevices(Test& test);
std::vector<AgaaCapability> capabilitiesOf(Test& test, const AgaaDeviceCaps* caps);

} // namespace agaa::conformance
