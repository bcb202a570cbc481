// Named settings, chosen among those that benchmark/presets.py measures; docs/choosing.md has what they cost.
#include "core/presets.h"

namespace agaa {

namespace {

struct Preset {
    const char* name;
    uint32_t aggregates;
    float threshold;
    uint32_t seeds;
    uint32_t litShadows;
    float glossWeight;
    uint32_t ndf;
    uint64_t flags; // of those that presets decide
};

constexpr uint64_t decided = AGAA_CONFIG_SHADOW_ALONG_DEPTH | AGAA_CONFIG_SPLIT_SURFACES |
                             AGAA_CONFIG_FIRST_SAMPLE_ROUTING | AGAA_CONFIG_NO_SHADOW_FILTER |
                             AGAA_CONFIG_NO_DIFFUSE_FILTER | AGAA_CONFIG_FINE_MATERIALS;

constexpr Preset presets[] = {
    {"paper", 2, 0.02f, AGAA_SEEDS_SUM_OF_SQUARES, 0, 0.0f, AGAA_NDF_TOKSVIG,
     AGAA_CONFIG_SHADOW_ALONG_DEPTH | AGAA_CONFIG_SPLIT_SURFACES},
    {"fast", 1, 0.02f, AGAA_SEEDS_MAXIMIN, 0, 0.0f, AGAA_NDF_TOKSVIG, 0},
    {"balanced", 4, 0.4f, AGAA_SEEDS_MAXIMIN, 1, 0.5f, AGAA_NDF_LEAN, 0},
    {"accurate", 4, 0.1f, AGAA_SEEDS_MAXIMIN, 1, 0.5f, AGAA_NDF_LEAN, AGAA_CONFIG_FINE_MATERIALS},
};

} // namespace

bool applyPreset(std::string_view name, AgaaConfig& config, AgaaAggregation& aggregation) {
    for (const Preset& preset : presets)
        if (preset.name == name) {
            config.technique = "agaa";
            config.aggregates = preset.aggregates;
            aggregation.aggregateThreshold = preset.threshold;
            config.surfaceCosine = config.surfaceDistance = config.surfaceMaterial = 0;
            aggregation.seeds = preset.seeds;
            config.shadowTaps = 0;
            config.ndf = preset.ndf;
            aggregation.litShadows = preset.litShadows;
            aggregation.glossWeight = preset.glossWeight;
            config.flags = (config.flags & ~decided) | preset.flags;
            return true;
        }
    return false;
}

} // namespace agaa
