// The tiers that generate aggregates.
#pragma once

#include "core/view/technique.h"

namespace agaa {

extern const GenerationTier idsTier;
extern const GenerationTier postDepthTier;
extern const GenerationTier perSampleTier;
extern const GenerationTier gbufferTier;
extern const GenerationTier mixedSamplesTier;
extern const GenerationTier pricedMixedSamplesTier; // memory of the papers
// These shade samples and generate no aggregates.
extern const GenerationTier sampleIdsTier;
extern const GenerationTier sampleGBufferTier;
extern const GenerationTier fragmentListsTier, materialListsTier, interlockTier, rasterOrderTier, fragmentsTier;

} // namespace agaa
