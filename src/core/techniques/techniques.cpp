#include "core/techniques/techniques.h"

namespace agaa {

const std::vector<const Technique*>& techniques() {
    static const std::vector<const Technique*> table = {&singleTechnique, &ssaaTechnique,
                                                        &agaaTechnique};
    return table;
}

} // namespace agaa
