#include "core/techniques/techniques.h"

namespace agaa {

const std::vector<const Technique*>& techniques() {
    static const std::vector<const Technique*> table = {
        &singleTechnique, &fxaaTechnique,          &msaaTechnique, &ssaaTechnique,
        &simpleComplexTechnique, &sbaaTechnique, &agaaTechnique};
    return table;
}

} // namespace agaa
