// Named settings. benchmark/presets.py measures the candidates; docs/choosing.md lists their costs.
#include "core/view/presets.h"

#include "core/base/error.h"
#include "core/base/names.h"

#include <algorithm>

namespace agaa {

namespace {

// The defaults are those of AGAA_…_INIT.
struct Preset {
    const char* name = "";
    uint32_t aggregates = 2;
    float threshold = 0.02f;
    uint32_t seeds = AGAA_SEEDS_MAXIMIN;
    uint32_t litShadows = 0;
    float glossWeight = 0;
    uint32_t ndf = AGAA_NDF_TOKSVIG;
    uint64_t flags = 0, measurementFlags = 0; // only bits that presets decide
};

constexpr uint64_t decided = AGAA_CONFIG_SPLIT_SURFACES | AGAA_CONFIG_FINE_MATERIALS;
constexpr uint64_t decidedMeasurement = AGAA_MEASURE_SHADOW_ALONG_DEPTH | AGAA_MEASURE_FIRST_SAMPLE_ROUTING |
                                        AGAA_MEASURE_NO_SHADOW_FILTER | AGAA_MEASURE_NO_DIFFUSE_FILTER |
                                        AGAA_MEASURE_SHADOW_COVARIANCE | AGAA_MEASURE_STORED_DEPTH;

constexpr Preset presets[] = {
    {.name = "paper",
     .seeds = AGAA_SEEDS_SUM_OF_SQUARES,
     .flags = AGAA_CONFIG_SPLIT_SURFACES,
     .measurementFlags = AGAA_MEASURE_SHADOW_ALONG_DEPTH},
    {.name = "fast", .aggregates = 1},
    {.name = "balanced",
     .aggregates = 4,
     .threshold = 0.4f,
     .litShadows = 1,
     .glossWeight = 0.5f,
     .ndf = AGAA_NDF_LEAN},
    {.name = "accurate",
     .aggregates = 4,
     .threshold = 0.1f,
     .litShadows = 1,
     .glossWeight = 0.5f,
     .ndf = AGAA_NDF_LEAN,
     .flags = AGAA_CONFIG_FINE_MATERIALS},
};

constexpr Preset defaults;

// The description is checked when a view is created.
bool hasClasses(const AgaaLayout* layout) {
    if (!layout || layout->sType != AGAA_STRUCTURE_TYPE_LAYOUT)
        return false;
    const auto* end = layout->attributes + std::min(layout->attributeCount, uint32_t(AGAA_MAX_LAYOUT_ATTRIBUTES));
    return std::any_of(layout->attributes, end, [](const AgaaLayoutAttribute& a) {
        return a.semantic == AGAA_SEMANTIC_CUSTOM && a.filter == AGAA_FILTER_CLASS;
    });
}

// Two geometry passes group samples before materials are known.
bool knowsMaterials(uint32_t tier) {
    return tier == AGAA_TIER_AUTO || tier == AGAA_TIER_IDS || tier == AGAA_TIER_FRAGMENTS || tier == AGAA_TIER_GBUFFER;
}

void apply(const Preset& preset, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement) {
    const bool isDefault = preset.seeds == AGAA_SEEDS_MAXIMIN && preset.measurementFlags == 0;
    if (!measurement && !isDefault)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("the preset \"%s\" needs an AgaaMeasurement.", preset.name));
    config.aggregates = hasClasses(config.layout) ? std::min(preset.aggregates + 1, 4u) : preset.aggregates;
    config.surfaceCosine = config.surfaceDistance = config.surfaceMaterial = 0;
    config.shadowTaps = 0;
    config.ndf = preset.ndf;
    config.flags = (config.flags & ~decided) | preset.flags;
    aggregation.aggregateThreshold = preset.threshold;
    const bool groupsByMaterials = knowsMaterials(config.generationTier);
    const bool shadesAtOnce = groupsByMaterials && !(config.flags & AGAA_CONFIG_BUFFERED);
    aggregation.litShadows = shadesAtOnce ? preset.litShadows : 0;
    aggregation.glossWeight = groupsByMaterials ? preset.glossWeight : 0;
    if (!measurement)
        return;
    measurement->seeds = preset.seeds;
    measurement->flags = (measurement->flags & ~decidedMeasurement) | preset.measurementFlags;
}

void setPreset(const Preset& preset, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement) {
    apply(preset, config, aggregation, measurement);
    config.technique = "agaa";
}

// Returns whether applying the preset would change nothing.
bool isApplied(const Preset& preset, const AgaaConfig& config, const AgaaAggregation& aggregation,
               const AgaaMeasurement& measurement) {
    AgaaConfig c = config;
    AgaaAggregation a = aggregation;
    AgaaMeasurement m = measurement;
    apply(preset, c, a, &m);
    return c.aggregates == config.aggregates && c.surfaceCosine == config.surfaceCosine &&
           c.surfaceDistance == config.surfaceDistance && c.surfaceMaterial == config.surfaceMaterial &&
           c.shadowTaps == config.shadowTaps && c.ndf == config.ndf && c.flags == config.flags &&
           a.aggregateThreshold == aggregation.aggregateThreshold && a.litShadows == aggregation.litShadows &&
           a.glossWeight == aggregation.glossWeight && m.seeds == measurement.seeds && m.flags == measurement.flags;
}

} // namespace

std::vector<const char*> presetNames() {
    std::vector<const char*> names;
    for (const Preset& preset : presets)
        names.push_back(preset.name);
    return names;
}

void applyPreset(const char* name, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement) {
    for (const Preset& preset : presets)
        if (isSameName(preset.name, name))
            return setPreset(preset, config, aggregation, measurement);
    fail(AGAA_ERROR_INVALID_ARGUMENT, format("no preset is called \"%s\".", printable(name).c_str()));
}

void applyDefaults(AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement) {
    apply(defaults, config, aggregation, measurement);
}

const char* presetOf(const AgaaConfig& config, const AgaaAggregation& aggregation, const AgaaMeasurement& measurement) {
    if (!isSameName(config.technique, "agaa"))
        return nullptr;
    for (const Preset& preset : presets)
        if (isApplied(preset, config, aggregation, measurement))
            return preset.name;
    return nullptr;
}

} // namespace agaa
