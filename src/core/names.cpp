#include "core/names.h"

#include <iterator>

namespace agaa {

namespace {
struct TierName {
    uint32_t tier;
    const char* name;
};
constexpr TierName tierNames[] = {
    {AGAA_TIER_AUTO, "auto"},
    {AGAA_TIER_NATIVE, "native"},
    {AGAA_TIER_NV_MULTICAST, "nv-multicast"},
    {AGAA_TIER_SCALED_TARGET, "scaled-target"},
    {AGAA_TIER_LAYERS, "layers"},
    {AGAA_TIER_NV_MIXED_SAMPLES, "nv-mixed-samples"},
    {AGAA_TIER_POST_DEPTH_ATOMICS, "post-depth-atomics"},
    {AGAA_TIER_PER_SAMPLE, "per-sample"},
    {AGAA_TIER_GBUFFER, "gbuffer"},
    {AGAA_TIER_IDS, "ids"},
};
} // namespace

const char* tierName(uint32_t tier) {
    for (const TierName& entry : tierNames)
        if (entry.tier == tier)
            return entry.name;
    return "unknown";
}

bool tierFromName(std::string_view name, uint32_t& tier) {
    for (const TierName& entry : tierNames)
        if (entry.name == name) {
            tier = entry.tier;
            return true;
        }
    return false;
}

const char* stageName(uint32_t stage) {
    static constexpr const char* names[] = {"prepass", "definition", "generation", "shading",
                                            "other"};
    return stage < std::size(names) ? names[stage] : "unknown";
}

} // namespace agaa
