#include "cases.h"

#include "cases/core/cases.h"

namespace agaa::conformance {

Suite makeSuite() {
    Suite suite;
    addCoreCases(suite);
    addGeneralCases(suite);
    addHostMemoryCases(suite);
    addTierCases(suite);
    addContextCases(suite);
    addVulkanContextCases(suite);
    addVulkanFaultCases(suite);
    addVulkanMemoryCases(suite);
    addTechniqueCases(suite);
    addOpenGlFaultCases(suite);
    addOpenGlContextCases(suite);
    addOpenGlStateCases(suite);
    addOpenGlCallbackCases(suite);
    addOtherApiCases(suite);
    addVulkanTierCases(suite);
    addOpenGlUnsupportedCases(suite);
    addVulkanUnsupportedCases(suite);
    addVulkanCapsCases(suite);
    addViewCases(suite);
    addResizeCases(suite);
    addDeviceCapsCases(suite);
    return suite;
}

} // namespace agaa::conformance
