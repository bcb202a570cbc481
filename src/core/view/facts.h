// Facts of scenes: what a view announces, and what frames may leave out of it.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

// Bits of AgaaSceneFacts::flags that grant effects: a frame may have fewer.
inline constexpr uint64_t grantingFacts = AGAA_FACT_ALL_SHADED | AGAA_FACT_CUSTOM_DEPTH;
// Bits that say what all materials or lights have in common. They are those of the view in all its frames.
inline constexpr uint64_t commonValues = AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR | AGAA_FACT_ONE_SPECULAR |
                                         AGAA_FACT_NO_DIFFUSE | AGAA_FACT_NO_LOCAL_LIGHTS | AGAA_FACT_NO_TRANSLUCENCY |
                                         AGAA_FACT_NO_CUTOUTS | AGAA_FACT_PLANE_NORMALS;
// Bits that change compute passes. Others change layouts, tiers and draw passes, which are those of the view.
inline constexpr uint64_t computeFacts = AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT;

// Throws where the facts are not valid, whatever the view. null is not valid.
AgaaSceneFacts checkFacts(const AgaaSceneFacts* facts);

// Whether all that a scene of the inner facts has is in the outer ones.
bool isWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer);
// Throws where they are not. name: of the inner ones, for the message.
void checkWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer, const char* name);
// How much a scene of these facts has: less where facts lie within others and change compute passes.
uint32_t extentOf(const AgaaSceneFacts& facts);

// The facts of compute passes: all else is the view's.
AgaaSceneFacts computeFactsOf(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced);
// Effects of the announced facts that these leave out, bits of AgaaSceneFacts::flags.
uint64_t leftOut(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced);

} // namespace agaa
