// One row a technique; the files beside this one hold them.
#pragma once

#include "core/plan_builder.h"

namespace agaa {

extern const Technique singleTechnique;
extern const Technique ssaaTechnique;
extern const Technique agaaTechnique;

} // namespace agaa
