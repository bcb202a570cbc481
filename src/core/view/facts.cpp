#include "core/view/facts.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/structs.h"

#include <bit>

namespace agaa {

AgaaSceneFacts checkFacts(const AgaaSceneFacts* pointer) {
    AgaaSceneFacts facts = readStruct(pointer);
    checkRange(uint64_t(facts.maxLights), 0, 4096, "AgaaSceneFacts::maxLights");
    checkRange(uint64_t(facts.shadowMapCount), 0, AGAA_MAX_SHADOW_MAPS, "AgaaSceneFacts::shadowMapCount");
    checkFlags(facts.flags, grantingFacts | commonValues, "AgaaSceneFacts::flags");
    checkRange(double(facts.alpha2), 4.1e-6, 1.0, "AgaaSceneFacts::alpha2");
    checkRange(double(facts.specular), 0.0, 1.0, "AgaaSceneFacts::specular");
    if (facts.flags & AGAA_FACT_NO_TRANSLUCENCY)
        facts.flags &= ~AGAA_FACT_NO_CUTOUTS;
    return facts;
}

bool isWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer) {
    return (inner.flags & grantingFacts & ~outer.flags) == 0 && inner.maxLights <= outer.maxLights &&
           inner.shadowMapCount <= outer.shadowMapCount;
}

void checkWithin(const AgaaSceneFacts& inner, const AgaaSceneFacts& outer, const char* name) {
    if (isWithin(inner, outer))
        return;
    fail(AGAA_ERROR_OUT_OF_RANGE,
         format("%s (flags 0x%llx, %u lights, %u shadow maps) are not within those of the view (0x%llx, %u, %u).", name,
                static_cast<unsigned long long>(inner.flags), inner.maxLights, inner.shadowMapCount,
                static_cast<unsigned long long>(outer.flags), outer.maxLights, outer.shadowMapCount));
}

uint32_t extentOf(const AgaaSceneFacts& facts) {
    return uint32_t(std::popcount(facts.flags & computeFacts)) + facts.shadowMapCount;
}

AgaaSceneFacts computeFactsOf(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced) {
    AgaaSceneFacts result = announced;
    result.flags = (facts.flags & computeFacts) | (announced.flags & ~computeFacts);
    result.shadowMapCount = facts.shadowMapCount;
    return result;
}

uint64_t leftOut(const AgaaSceneFacts& facts, const AgaaSceneFacts& announced) {
    return announced.flags & ~facts.flags & grantingFacts & computeFacts;
}

} // namespace agaa
