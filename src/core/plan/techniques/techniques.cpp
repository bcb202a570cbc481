#include "core/plan/techniques/techniques.h"

#include "core/plan/planner.h"

namespace agaa {

TechniqueTable techniques() {
    static constexpr const Technique* table[] = {
        &singleTechnique, &fxaaTechnique,       &smaaTechnique,          &taaTechnique,  &msaaTechnique,
        &ssaaTechnique,   &visibilityTechnique, &simpleComplexTechnique, &sbaaTechnique, &agaaTechnique,
        &dcaaTechnique,   &sgbcTechnique,       &adaptiveTechnique};
    return table;
}

} // namespace agaa
