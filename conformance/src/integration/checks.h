// The duties of a host. Each is a check of an engine that integrates the SDK.
#pragma once

#include "../suite.h"

namespace agaa::conformance {

bool isComplete(const AgaaConformanceHost* host);
// Adds the checks. The host must outlive them.
Suite makeHostChecks(const AgaaConformanceHost& host, const Functions& functions);

} // namespace agaa::conformance
