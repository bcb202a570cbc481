// The tests on a device, by topic.
#pragma once

#include "suite.h"

namespace agaa::conformance {

void addGeneralCases(Suite& suite);
void addHostMemoryCases(Suite& suite);
void addTierCases(Suite& suite);
void addFragmentListCases(Suite& suite);
void addContextCases(Suite& suite);
void addVulkanContextCases(Suite& suite);
void addFaultCases(Suite& suite);
void addVulkanMemoryCases(Suite& suite);
void addTechniqueCases(Suite& suite);
void addOpenGlContextCases(Suite& suite);
void addOpenGlStateCases(Suite& suite);
void addOpenGlFrameStateCases(Suite& suite);
void addOpenGlStateCallbackCases(Suite& suite);
void addOpenGlPendingErrorCases(Suite& suite);
void addOtherApiCases(Suite& suite);
void addVulkanTierCases(Suite& suite);
void addVulkanLayerCases(Suite& suite);
void addOpenGlUnsupportedCases(Suite& suite);
void addVulkanUnsupportedCases(Suite& suite);
void addVulkanCapsCases(Suite& suite);
void addVariantCases(Suite& suite);
void addViewCases(Suite& suite);
void addResizeCases(Suite& suite);
void addDeviceCapsCases(Suite& suite);
void addFrameRangeCases(Suite& suite);
void addTemporalFrameCases(Suite& suite);
void addLightMemberCases(Suite& suite);
void addFrameArgumentCases(Suite& suite);
void addFrameOrderCases(Suite& suite);
void addFrameCallbackCases(Suite& suite);
void addDiscardedFrameCases(Suite& suite);
void addLossCases(Suite& suite);
void addBreadcrumbCases(Suite& suite);
void addObjectNameCases(Suite& suite);
void addDriverBreadthCases(Suite& suite);
void addFrameFaultCases(Suite& suite);
void addFrameCountCases(Suite& suite);
void addFrameHeaderCases(Suite& suite);
void addDrawPassCases(Suite& suite);
void addDrawPassErrorCases(Suite& suite);
void addGlslResourceCases(Suite& suite);
void addDrawTargetCases(Suite& suite);
void addSurfaceCases(Suite& suite);
void addStatisticsCases(Suite& suite);
void addImageCases(Suite& suite);
void addCoverageImageCases(Suite& suite);
void addCounterCases(Suite& suite);
void addRepeatedFrameCases(Suite& suite);
void addResolvedOutputCases(Suite& suite);
void addVkOutputCases(Suite& suite);
void addGlArgumentCases(Suite& suite);
void addValidationCases(Suite& suite);

} // namespace agaa::conformance
