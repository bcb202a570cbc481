// The tests that need no device, by topic.
#pragma once

#include "suite.h"

namespace agaa::conformance {

void addCoreCases(Suite& suite); // defined in all.cpp: adds all of them

void addInitCases(Suite& suite);
void addHeaderCases(Suite& suite);
void addConfigMemberCases(Suite& suite);
void addViewMemberCases(Suite& suite);
void addLayoutMemberCases(Suite& suite);
void addNameCases(Suite& suite);
void addPresetCases(Suite& suite);
void addCapabilityCases(Suite& suite);
void addMemoryCases(Suite& suite);
void addPriceCases(Suite& suite);
void addGoalCases(Suite& suite);
void addGoalMemberCases(Suite& suite);
void addTextCases(Suite& suite);
void addRequirementCases(Suite& suite);
void addThreadCases(Suite& suite);
void addUnsupportedCases(Suite& suite);
void addHostFunctionCases(Suite& suite);
void addConventionCases(Suite& suite);
void addPlanCases(Suite& suite);

} // namespace agaa::conformance
