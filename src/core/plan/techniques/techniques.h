// The row of each technique. Each is defined in a file of this folder.
#pragma once

#include "core/plan/plan_builder.h"

namespace agaa {

extern const Technique singleTechnique;
extern const Technique fxaaTechnique;
extern const Technique smaaTechnique;
extern const Technique taaTechnique;
extern const Technique msaaTechnique;
extern const Technique ssaaTechnique;
extern const Technique visibilityTechnique;
extern const Technique simpleComplexTechnique;
extern const Technique sbaaTechnique;
extern const Technique agaaTechnique;
extern const Technique dcaaTechnique;
extern const Technique sgbcTechnique;
extern const Technique adaptiveTechnique;

} // namespace agaa
