// The tests on a device, by what they are about.
#pragma once

#include "suite.h"

namespace agaa::conformance {

void addGeneralCases(Suite& suite);
void addHostMemoryCases(Suite& suite);
void addTierCases(Suite& suite);
void addContextCases(Suite& suite);
void addVulkanContextCases(Suite& suite);
void addVulkanFaultCases(Suite& suite);
void addVulkanMemoryCases(Suite& suite);
void addTechniqueCases(Suite& suite);
void addOpenGlFaultCases(Suite& suite);
void addOpenGlContextCases(Suite& suite);
void addOpenGlStateCases(Suite& suite);
void addOpenGlCallbackCases(Suite& suite);
void addOtherApiCases(Suite& suite);
void addVulkanTierCases(Suite& suite);
void addOpenGlUnsupportedCases(Suite& suite);
void addVulkanUnsupportedCases(Suite& suite);
void addVulkanCapsCases(Suite& suite);
void addViewCases(Suite& suite);
void addResizeCases(Suite& suite);
void addDeviceCapsCases(Suite& suite);

} // namespace agaa::conformance
