// What the SDK predicts of a view on a device.
#pragma once

#include "render/sdk_log.h"

#include <utility>

namespace harness {

AgaaMemoryReport predictMemory(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log);
// Stage and tier by name.
std::vector<std::pair<std::string, std::string>> plannedTiers(const AgaaViewDesc& desc,
                                                              const AgaaDeviceCaps& caps, SdkLog& log);

} // namespace harness
