#include "core/techniques/techniques.h"

namespace agaa {

const std::vector<const Technique*>& techniques() {
    static const std::vector<const Technique*> table = {
        &singleTechnique, &fxaaTechnique,          &msaaTechnique, &ssaaTechnique,
        &simpleComplexTechnique, &sbaaTechnique, &agaaTechnique};
    return table;
}

const Technique* findTechnique(std::string_view name) {
    for (const Technique* technique : techniques())
        if (name == technique->name)
            return technique;
    return nullptr;
}

} // namespace agaa
