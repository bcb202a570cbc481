#include "core/view/technique.h"

#include "core/base/names.h"

#include <algorithm>

namespace agaa {

const Technique* findTechnique(TechniqueTable table, std::string_view name) {
    for (const Technique* technique : table)
        if (isSameName(name, technique->name))
            return technique;
    return nullptr;
}

bool Technique::countsCoverage(uint32_t generationTier, uint32_t samples) const {
    for (const GenerationTier* row : tiers)
        if (row->hasCoverageSamples &&
            (generationTier == AGAA_TIER_AUTO ? samples > maxSamples : row->tier == AgaaTier(generationTier)))
            return true;
    return maxSamples == 0;
}

std::vector<uint32_t> settingsTypes(TechniqueTable table) {
    std::vector<uint32_t> types;
    for (const Technique* technique : table)
        for (const TechniqueSettings* settings : technique->settings)
            if (std::find(types.begin(), types.end(), settings->sType) == types.end())
                types.push_back(settings->sType);
    return types;
}

} // namespace agaa
