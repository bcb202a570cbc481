// Facts of scenes. A view announces facts; its frames may announce fewer effects.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

// Bits of AgaaSceneFacts::flags that allow effects. A frame may have fewer than its view.
inline constexpr uint64_t grantingFacts = AGAA_FACT_ALL_SHADED | AGAA_FACT_CUSTOM_DEPTH;
// Bits that state a property of all materials or lights. All frames have those of the view.
inline constexpr uint64_t commonValues = AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR | AGAA_FACT_ONE_SPECULAR |
                                         AGAA_FACT_NO_DIFFUSE | AGAA_FACT_NO_LOCAL_LIGHTS | AGAA_FACT_NO_TRANSLUCENCY |
                                         AGAA_FACT_NO_CUTOUTS | AGAA_FACT_PLANE_NORMALS;
// Bits that change compute passes. Other bits change layouts, tiers and draw passes, which frames cannot change.
inline constexpr uint64_t computeFacts = AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT;

// Returns the checked facts. Throws Error if they are null or not valid for any view.
AgaaSceneFacts checkFacts(const AgaaSceneFacts* facts);

// Returns whether the outer facts allow everything that the inner ones do.
bool isWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer);
// Throws Error if they do not. The message calls the inner facts `name`.
void checkWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer, const char* name);
// Returns the number of effects that change compute passes. It is smaller for facts within others that differ in them.
uint32_t extentOf(const AgaaSceneFacts& facts);

// Returns the announced facts with those effects of compute passes that `facts` have.
AgaaSceneFacts computeFactsOf(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced);
// Returns the bits of announced effects that `facts` lack.
uint64_t leftOut(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced);

} // namespace agaa
