#include "hard/configurations.h"

#include <stdexcept>

namespace harness::hard {

const char* nameOf(Shading shading) {
    constexpr const char* names[] = {"one sample", "few samples",   "every sample", "surfaces",
                                     "aggregates", "one aggregate", "one event"};
    static_assert(std::size(names) == kShadings);
    return names[size_t(shading)];
}

Shading HardConfiguration::shading() const {
    if (samples == 1)
        return Shading::One;
    if (technique == "visibility")
        return Shading::Event;
    if (samples < 8)
        return Shading::Few;
    if (technique == "ssaa")
        return Shading::Samples;
    if (aggregates == 1)
        return Shading::Mean;
    return technique == "agaa" ? Shading::Aggregates : Shading::Surfaces;
}

std::string HardConfiguration::name() const {
    std::string name = technique + " n=" + std::to_string(samples);
    if (isAccurate)
        name += " accurate";
    else if (aggregates > 0)
        name += " c=" + std::to_string(aggregates);
    if (generationTier != AGAA_TIER_AUTO)
        name += std::string(" ") + agaaTierName(generationTier);
    return name;
}

void HardConfiguration::apply(TechniqueConfig& config) const {
    config.technique = technique.c_str();
    config.samples = samples;
    config.aggregates = aggregates ? aggregates : 2; // other techniques do not use it, but it must be in range
    config.generationTier = generationTier;
    if (isAccurate && config.applyPreset("accurate") != AGAA_OK)
        throw std::runtime_error("The preset accurate does not exist.");
}

namespace {

void add(std::vector<HardConfiguration>& list, const char* technique, std::initializer_list<uint32_t> samples,
         uint32_t maxAggregates, std::initializer_list<uint32_t> tiers) {
    for (const uint32_t tier : tiers)
        for (const uint32_t n : samples)
            for (uint32_t c = maxAggregates ? 1 : 0; c <= maxAggregates; ++c)
                list.push_back({technique, n, c, tier});
}

} // namespace

const std::vector<HardConfiguration>& hardConfigurations() {
    static const std::vector<HardConfiguration> configurations = [] {
        std::vector<HardConfiguration> list;
        add(list, "single", {1}, 0, {AGAA_TIER_AUTO});
        for (const char* filter : {"fxaa", "smaa", "taa"})
            add(list, filter, {1}, 0, {AGAA_TIER_AUTO});
        add(list, "visibility", {1, 2, 4, 8, 16, 32}, 0, {AGAA_TIER_AUTO});
        for (const char* technique : {"msaa", "ssaa", "simple_complex"})
            add(list, technique, {1, 2, 4, 8, 9, 16, 32}, 0, {AGAA_TIER_AUTO});
        add(list, "sbaa", {1, 2, 4, 8, 16, 32}, 6,
            {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER});
        add(list, "agaa", {1, 2, 4, 8, 16, 32}, 4,
            {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS});
        add(list, "agaa", {32, 64, 128}, 4, {AGAA_TIER_FRAGMENTS});
        add(list, "adaptive", {1, 2, 4, 8, 9, 16, 32}, 0, {AGAA_TIER_GBUFFER, AGAA_TIER_IDS});
        add(list, "dcaa", {32, 64, 128}, 8,
            {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS, AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER});
        add(list, "sgbc", {32, 64, 128}, 8, {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS});
        for (const uint32_t tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
            for (const uint32_t n : {8u, 16u, 32u})
                list.push_back({"agaa", n, 4, tier, true});
        for (const uint32_t n : {32u, 64u, 128u})
            list.push_back({"agaa", n, 4, AGAA_TIER_FRAGMENTS, true});
        return list;
    }();
    return configurations;
}

} // namespace harness::hard
