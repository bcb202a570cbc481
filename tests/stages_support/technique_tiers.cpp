#include "technique_tiers.h"

#include <map>

namespace agaa::test {

std::ostream& operator<<(std::ostream& out, const TechniqueTier& t) {
    out << t.technique << " n=" << t.n << ' ' << agaaTierName(t.tier) << ' ' << agaaTierName(t.visibility)
        << " flags=" << t.flags;
    return out << (t.coverageFlags ? " exact" : "") << (t.isBatched ? " in batches" : "")
               << (t.isMixed ? " some unfetched" : "");
}

const std::vector<TechniqueTier>& techniqueTiers() {
    using enum TechniqueTier::Evaluations;
    static const std::vector<TechniqueTier> tiers = {
        {.technique = "single", .n = 1},
        {.technique = "fxaa", .n = 1},
        {.technique = "smaa", .n = 1},
        {.technique = "msaa", .n = 4, .evaluations = EachTexel},
        {.technique = "msaa", .n = 8, .evaluations = EachTexel},
        {.technique = "ssaa", .n = 8, .evaluations = EachTexel},
        {.technique = "ssaa", .n = 9, .visibility = AGAA_TIER_ORDERED_GRID, .evaluations = EachTexel},
        {.technique = "visibility", .n = 8, .evaluations = EachTexel},
        {.technique = "simple_complex", .n = 8, .evaluations = EachTexel},
        {.technique = "sbaa", .n = 8, .tier = AGAA_TIER_PER_SAMPLE, .evaluations = EachSample},
        {.technique = "sbaa", .n = 8, .tier = AGAA_TIER_POST_DEPTH_ATOMICS, .evaluations = EachTexel},
        {.technique = "sbaa", .n = 8, .tier = AGAA_TIER_GBUFFER, .evaluations = EachTexel},
        {.technique = "agaa",
         .n = 4,
         .tier = AGAA_TIER_POST_DEPTH_ATOMICS,
         .visibility = AGAA_TIER_ORDERED_GRID,
         .evaluations = EachTexel},
        {.technique = "agaa", .n = 8, .tier = AGAA_TIER_PER_SAMPLE, .evaluations = EachSample},
        {.technique = "agaa", .n = 8, .tier = AGAA_TIER_GBUFFER, .evaluations = EachTexel},
        {.technique = "agaa",
         .n = 8,
         .tier = AGAA_TIER_GBUFFER,
         .flags = AGAA_CONFIG_BUFFERED,
         .evaluations = EachTexel},
        {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS},
        {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS, .flags = AGAA_CONFIG_BUFFERED},
        {.technique = "agaa",
         .n = 8,
         .tier = AGAA_TIER_IDS,
         .flags = AGAA_CONFIG_FINE_MATERIALS,
         .evaluations = EachTexel},
        {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS, .isMixed = true, .evaluations = OfOtherPasses},
        {.technique = "msaa", .n = 8, .visibility = AGAA_TIER_LAYERS, .evaluations = EachTexel},
        {.technique = "agaa",
         .n = 8,
         .tier = AGAA_TIER_POST_DEPTH_ATOMICS,
         .visibility = AGAA_TIER_LAYERS,
         .evaluations = EachTexel},
        {.technique = "agaa",
         .n = 16,
         .tier = AGAA_TIER_GBUFFER,
         .visibility = AGAA_TIER_LAYERS,
         .evaluations = EachTexel},
        {.technique = "agaa",
         .n = 32,
         .tier = AGAA_TIER_IDS,
         .visibility = AGAA_TIER_LAYERS,
         .flags = AGAA_CONFIG_FINE_MATERIALS,
         .evaluations = EachTexel},
        {.technique = "agaa", .n = 64, .tier = AGAA_TIER_FRAGMENTS},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_FRAGMENT_LISTS},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_FRAGMENT_LISTS, .coverageFlags = AGAA_COVERAGE_EXACT},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_FRAGMENT_LISTS, .isBatched = true},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS, .coverageFlags = AGAA_COVERAGE_EXACT},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS, .isBatched = true},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_FRAGMENT_INTERLOCK},
        {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_RASTER_ORDER, .layout = "dcaa28"},
        {.technique = "sgbc", .n = 64, .tier = AGAA_TIER_FRAGMENT_LISTS},
        {.technique = "sgbc", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS},
        {.technique = "adaptive", .n = 8, .tier = AGAA_TIER_GBUFFER, .evaluations = EachTexel},
        {.technique = "adaptive", .n = 8, .tier = AGAA_TIER_IDS, .evaluations = OfOtherPasses},
    };
    return tiers;
}

bool fetches(const TechniqueTier& tier) {
    return tier.tier == AGAA_TIER_IDS || tier.tier == AGAA_TIER_FRAGMENT_LISTS || tier.tier == AGAA_TIER_FRAGMENTS;
}

bool carriesMaterials(const TechniqueTier& tier) {
    return tier.tier == AGAA_TIER_MATERIAL_LISTS || tier.tier == AGAA_TIER_FRAGMENT_INTERLOCK ||
           tier.tier == AGAA_TIER_RASTER_ORDER;
}

bool runs(const TechniqueTier& tier, const AgaaDeviceCaps& caps) {
    return (tier.tier != AGAA_TIER_FRAGMENT_INTERLOCK || caps.flags & AGAA_DEVICE_FRAGMENT_INTERLOCK) &&
           (tier.tier != AGAA_TIER_RASTER_ORDER || caps.flags & AGAA_DEVICE_FRAMEBUFFER_FETCH);
}

void apply(const TechniqueTier& tier, ViewSettings& settings) {
    static std::map<std::string, AgaaLayout> layouts;
    settings.config.technique = tier.technique;
    settings.config.samples = tier.n;
    settings.config.generationTier = tier.tier;
    settings.config.visibilityTier = tier.visibility;
    settings.config.flags = tier.flags;
    settings.config.coverage.flags = tier.coverageFlags;
    if (tier.layout) {
        const auto [layout, isNew] = layouts.try_emplace(tier.layout, AgaaLayout AGAA_LAYOUT_INIT);
        if (isNew)
            agaaGetBuiltinLayout(tier.layout, &layout->second);
        settings.config.layout = &layout->second;
    }
    if (tier.isBatched) {
        settings.config.coverage.fragmentsPerPixel = 1;
        settings.config.coverage.maxBatches = 4;
    }
    if (tier.isMixed)
        settings.shader = ViewSettings::Shader::ThirdUnfetched;
}

} // namespace agaa::test
