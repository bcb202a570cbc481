#include "cases.h"

namespace agaa::conformance {

void addCoreCases(Suite& suite) {
    addInitCases(suite);
    addHeaderCases(suite);
    addConfigMemberCases(suite);
    addViewMemberCases(suite);
    addLayoutMemberCases(suite);
    addNameCases(suite);
    addPresetCases(suite);
    addCapabilityCases(suite);
    addMemoryCases(suite);
    addPriceCases(suite);
    addGoalCases(suite);
    addGoalMemberCases(suite);
    addTextCases(suite);
    addRequirementCases(suite);
    addThreadCases(suite);
    addUnsupportedCases(suite);
    addHostFunctionCases(suite);
    addConventionCases(suite);
    addPlanCases(suite);
}

Suite makeCoreSuite() {
    Suite suite;
    addCoreCases(suite);
    return suite;
}

} // namespace agaa::conformance
