#include "sweep/rows.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace harness {

std::string SweepRow::name() const {
    std::ostringstream text;
    text << technique << '-' << samples;
    if (!preset.empty())
        text << '-' << preset;
    else if (aggregates)
        text << '-' << aggregates;
    if (shadingCost > 1)
        text << "-cost" << shadingCost;
    if (generationTier != AGAA_TIER_AUTO)
        text << '-' << agaaTierName(generationTier);
    return text.str();
}

static void applyCoverage(const std::string& preset, TechniqueConfig& config) {
    if (preset == "exact")
        config.coverage.flags = AGAA_COVERAGE_EXACT;
    if (preset == "paper")
        config.coverage.merge = AGAA_MERGE_PAPER;
    if (preset == "lean")
        config.ndf = AGAA_NDF_LEAN;
}

void SweepRow::apply(TechniqueConfig& config) const {
    config.technique = technique.c_str();
    config.samples = samples;
    config.aggregates = std::max(aggregates, 1u);
    config.measurement.shadingCost = shadingCost;
    config.generationTier = generationTier;
    if (technique == "dcaa" || technique == "sgbc")
        applyCoverage(preset, config);
    else if (technique == "adaptive")
        config.adaptive.flags |= preset == "device" ? AGAA_ADAPTIVE_DEVICE_PATTERN : 0;
    else if (!preset.empty() && config.applyPreset(preset.c_str()) != AGAA_OK)
        throw std::invalid_argument("There is no preset \"" + preset + "\".");
}

std::vector<SweepRow> sweepRows(bool quick) {
    if (quick)
        return {{"single"},
                {"fxaa"},
                {"smaa"},
                {"taa"},
                {"msaa", 8},
                {"ssaa", 8},
                {"visibility", 8},
                {"simple_complex", 8},
                {"sbaa", 8, 2},
                {"agaa", 8, 2},
                {"agaa", 8, 2, 1, AGAA_TIER_GBUFFER},
                {"agaa", 8, 2, 1, AGAA_TIER_IDS},
                {"agaa", 8, 4, 1, AGAA_TIER_IDS, "accurate"},
                {"dcaa", 64, 4},
                {"sgbc", 64, 4},
                {"adaptive", 8, 0, 1, AGAA_TIER_AUTO, "device"}};
    std::vector<SweepRow> rows = {{"single"}, {"fxaa"}, {"smaa"}, {"taa"}, {"msaa", 8}};
    for (uint32_t n : {4u, 8u, 16u, 32u}) {
        rows.push_back({"ssaa", n});
        rows.push_back({"visibility", n});
        rows.push_back({"simple_complex", n});
    }
    for (uint32_t s : {1u, 2u, 4u, 6u})
        rows.push_back({"sbaa", 8, s});
    rows.push_back({"sbaa", 16, 2});
    for (uint32_t s : {2u, 4u})
        rows.push_back({"sbaa", 32, s});
    for (uint32_t n : {4u, 8u, 16u, 32u})
        for (uint32_t c : {1u, 2u, 4u})
            if (c == 2 || n == 8)
                rows.push_back({"agaa", n, c});
    for (uint32_t n : {8u, 32u})
        for (AgaaTier tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
            rows.push_back({"agaa", n, 2, 1, tier});
    rows.push_back({"sbaa", 8, 2, 1, AGAA_TIER_GBUFFER});
    rows.push_back({"agaa", 8, 2, 1, AGAA_TIER_AUTO, "paper"});
    for (AgaaTier tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        rows.push_back({"agaa", 8, 1, 1, tier, "fast"});
        rows.push_back({"agaa", 8, 4, 1, tier, "balanced"});
        rows.push_back({"agaa", 8, 4, 1, tier, "accurate"});
        rows.push_back({"agaa", 32, 4, 1, tier, "accurate"});
    }
    for (uint32_t surfaces : {4u, 8u})
        rows.push_back({"dcaa", 64, surfaces});
    for (const char* preset : {"lean", "paper", "exact"})
        rows.push_back({"dcaa", 64, 4, 1, AGAA_TIER_AUTO, preset});
    for (uint32_t n : {32u, 64u})
        rows.push_back({"sgbc", n, 4});
    rows.push_back({"agaa", 64, 2, 1, AGAA_TIER_FRAGMENTS});
    rows.push_back({"agaa", 64, 4, 1, AGAA_TIER_FRAGMENTS, "accurate"});
    rows.push_back({"dcaa", 64, 4, 1, AGAA_TIER_MATERIAL_LISTS});
    // With the preset "device", adaptive has the sample locations of "ssaa". With 9 samples, both have an ordered grid.
    for (uint32_t n : {4u, 8u, 16u, 32u})
        rows.push_back({"adaptive", n, 0, 1, AGAA_TIER_AUTO, "device"});
    for (const char* technique : {"ssaa", "simple_complex", "adaptive"})
        rows.push_back({technique, 9});
    // Rows with a higher shading cost show frames in which lighting has the share that it has in heavier engines.
    const auto addHeavier = [&](SweepRow row, std::initializer_list<uint32_t> costs) {
        for (uint32_t cost : costs) {
            row.shadingCost = cost;
            rows.push_back(row);
        }
    };
    for (const SweepRow& row : {SweepRow{"ssaa", 8},
                                {"visibility", 8},
                                {"simple_complex", 8},
                                {"agaa", 8, 2},
                                {"agaa", 8, 2, 1, AGAA_TIER_IDS},
                                {"dcaa", 64, 4},
                                {"agaa", 64, 4, 1, AGAA_TIER_FRAGMENTS, "accurate"},
                                {"adaptive", 8, 0, 1, AGAA_TIER_AUTO, "device"}})
        addHeavier(row, {4, 16});
    for (const SweepRow& row : {SweepRow{"sbaa", 8, 2},
                                {"agaa", 8, 2, 1, AGAA_TIER_GBUFFER},
                                {"agaa", 8, 4, 1, AGAA_TIER_GBUFFER, "accurate"},
                                {"simple_complex", 32},
                                {"agaa", 32, 2},
                                {"agaa", 32, 2, 1, AGAA_TIER_GBUFFER},
                                {"agaa", 32, 2, 1, AGAA_TIER_IDS}})
        addHeavier(row, {4});
    return rows;
}

std::vector<SweepRow> namedSweepRows(const std::vector<std::string>& names) {
    const std::vector<SweepRow> table = sweepRows(false);
    std::vector<SweepRow> rows;
    for (const std::string& name : names) {
        const auto row = std::find_if(table.begin(), table.end(), [&](const SweepRow& r) { return r.name() == name; });
        if (row == table.end()) {
            std::string all;
            for (const SweepRow& known : table)
                all += (all.empty() ? "" : ", ") + known.name();
            throw std::invalid_argument("There is no row \"" + name + "\"; rows are " + all + ".");
        }
        if (std::count(names.begin(), names.end(), name) > 1)
            throw std::invalid_argument("The row \"" + name + "\" is asked for twice.");
        rows.push_back(*row);
    }
    return rows;
}

const std::vector<SweepEffect>& sweepEffects() {
    static const SweepRow accurate = {"agaa", 8, 4, 1, AGAA_TIER_GBUFFER, "accurate"};
    static const std::vector<SweepEffect> effects = {
        {.name = "shadow-filter",
         .off = [](TechniqueConfig& config) { config.measurement.flags |= AGAA_MEASURE_NO_SHADOW_FILTER; },
         .ofShadows = true},
        {.name = "filtered-diffuse",
         .off = [](TechniqueConfig& config) { config.measurement.flags |= AGAA_MEASURE_NO_DIFFUSE_FILTER; }},
        {.name = "ndf-widening",
         .fact = AGAA_FACT_SPECULAR,
         .off = [](TechniqueConfig& config) { config.ndf = AGAA_NDF_NONE; }},
        {.name = "specular", .fact = AGAA_FACT_SPECULAR},
        {.name = "emissive", .fact = AGAA_FACT_EMISSIVE},
        {.name = "ambient", .fact = AGAA_FACT_AMBIENT},
        {.name = "normal-maps", .ofNormalMaps = true},
        {.name = "lit-aggregates",
         .off = [](TechniqueConfig& config) { config.aggregation.litShadows = 0; },
         .ofShadows = true,
         .row = accurate},
        {.name = "elliptic-lobes",
         .fact = AGAA_FACT_SPECULAR,
         .off = [](TechniqueConfig& config) { config.ndf = AGAA_NDF_TOKSVIG; },
         .row = accurate},
        {.name = "gloss-weight",
         .fact = AGAA_FACT_SPECULAR,
         .off = [](TechniqueConfig& config) { config.aggregation.glossWeight = 0; },
         .row = accurate},
        {.name = "more-aggregates", .off = [](TechniqueConfig& config) { config.aggregates = 2; }, .row = accurate},
        {.name = "maximin-seeds",
         .off = [](TechniqueConfig& config) { config.measurement.seeds = AGAA_SEEDS_SUM_OF_SQUARES; },
         .row = accurate},
        {.name = "fused",
         .off = [](TechniqueConfig& config) { config.flags |= AGAA_CONFIG_BUFFERED; },
         .row = {"agaa", 8, 2, 1, AGAA_TIER_IDS}},
    };
    return effects;
}

bool isCalledFor(const SweepEffect& effect, const Scene& scene, const AgaaSceneFacts& facts) {
    if (effect.ofNormalMaps)
        return std::any_of(scene.materials.begin(), scene.materials.end(),
                           [](const Material& m) { return m.normalTexture >= 0; });
    if (effect.ofShadows)
        return facts.shadowMapCount > 0;
    return !effect.fact || (facts.flags & effect.fact);
}

} // namespace harness
