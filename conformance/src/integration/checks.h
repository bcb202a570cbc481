// The duties of a host, each as a check of an engine that integrates the SDK.
#pragma once

#include "../suite.h"

namespace agaa::conformance {

bool isComplete(const AgaaConformanceHost* host);
// The checks refer to the host; it must outlive them.
Suite makeHostChecks(const AgaaConformanceHost& host, const Functions& functions);

} // namespace agaa::conformance
