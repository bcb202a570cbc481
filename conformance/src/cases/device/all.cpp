#include "cases.h"

#include "cases/core/cases.h"

namespace agaa::conformance {

Suite makeSuite() {
    Suite suite;
    addCoreCases(suite);
    addGeneralCases(suite);
    addHostMemoryCases(suite);
    addTierCases(suite);
    addFragmentListCases(suite);
    addContextCases(suite);
    addVulkanContextCases(suite);
    addFaultCases(suite);
    addVulkanMemoryCases(suite);
    addTechniqueCases(suite);
    addOpenGlContextCases(suite);
    addOpenGlStateCases(suite);
    addOpenGlFrameStateCases(suite);
    addOpenGlStateCallbackCases(suite);
    addOpenGlPendingErrorCases(suite);
    addOtherApiCases(suite);
    addVulkanTierCases(suite);
    addVulkanLayerCases(suite);
    addOpenGlUnsupportedCases(suite);
    addVulkanUnsupportedCases(suite);
    addVulkanCapsCases(suite);
    addVariantCases(suite);
    addViewCases(suite);
    addResizeCases(suite);
    addDeviceCapsCases(suite);
    addFrameRangeCases(suite);
    addTemporalFrameCases(suite);
    addLightMemberCases(suite);
    addFrameArgumentCases(suite);
    addFrameOrderCases(suite);
    addFrameCallbackCases(suite);
    addDiscardedFrameCases(suite);
    addLossCases(suite);
    addBreadcrumbCases(suite);
    addObjectNameCases(suite);
    addDriverBreadthCases(suite);
    addFrameFaultCases(suite);
    addFrameCountCases(suite);
    addFrameHeaderCases(suite);
    addDrawPassCases(suite);
    addDrawPassErrorCases(suite);
    addGlslResourceCases(suite);
    addDrawTargetCases(suite);
    addSurfaceCases(suite);
    addStatisticsCases(suite);
    addImageCases(suite);
    addCoverageImageCases(suite);
    addCounterCases(suite);
    addRepeatedFrameCases(suite);
    addResolvedOutputCases(suite);
    addVkOutputCases(suite);
    addGlArgumentCases(suite);
    addValidationCases(suite);
    return suite;
}

} // namespace agaa::conformance
