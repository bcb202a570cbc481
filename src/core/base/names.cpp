#include "core/base/names.h"

#include "core/base/error.h"

#include <algorithm>
#include <iterator>

namespace agaa {

namespace {
struct TierName {
    uint32_t tier;
    const char* name;
};
constexpr TierName tiers[] = {
    {AGAA_TIER_AUTO, "auto"},
    {AGAA_TIER_NATIVE, "native"},
    {AGAA_TIER_NV_MULTICAST, "nv-multicast"},
    {AGAA_TIER_SCALED_TARGET, "scaled-target"},
    {AGAA_TIER_LAYERS, "layers"},
    {AGAA_TIER_ORDERED_GRID, "ordered-grid"},
    {AGAA_TIER_NV_MIXED_SAMPLES, "nv-mixed-samples"},
    {AGAA_TIER_POST_DEPTH_ATOMICS, "post-depth-atomics"},
    {AGAA_TIER_PER_SAMPLE, "per-sample"},
    {AGAA_TIER_GBUFFER, "gbuffer"},
    {AGAA_TIER_IDS, "ids"},
    {AGAA_TIER_FRAGMENT_LISTS, "lists"},
    {AGAA_TIER_FRAGMENTS, "fragments"},
    {AGAA_TIER_MATERIAL_LISTS, "material-lists"},
    {AGAA_TIER_FRAGMENT_INTERLOCK, "interlock"},
    {AGAA_TIER_RASTER_ORDER, "raster-order"},
};
constexpr const char* stages[] = {"prepass", "definition", "generation", "shading", "other"};
} // namespace

bool isSameName(std::string_view a, std::string_view b) {
    const auto plain = [](char c) { return c == '_' ? '-' : c; };
    return std::ranges::equal(a, b, {}, plain, plain);
}

std::string printable(const char* name) {
    std::string text;
    for (const char* at = name; *at && at - name < 64; ++at) {
        const auto byte = static_cast<unsigned char>(*at);
        text += byte < 0x20 || byte == 0x7F ? format("\\x%02X", byte) : std::string(1, *at);
    }
    return text;
}

bool isTier(uint32_t tier) {
    return std::ranges::any_of(tiers, [&](const TierName& entry) { return entry.tier == tier; });
}

const char* tierName(uint32_t tier) {
    for (const TierName& entry : tiers)
        if (entry.tier == tier)
            return entry.name;
    return "unknown";
}

bool tierFromName(std::string_view name, uint32_t& tier) {
    for (const TierName& entry : tiers)
        if (isSameName(entry.name, name)) {
            tier = entry.tier;
            return true;
        }
    return false;
}

const char* stageName(uint32_t stage) { return stage < std::size(stages) ? stages[stage] : "unknown"; }

std::vector<const char*> tierNames() {
    std::vector<const char*> names;
    for (const TierName& entry : tiers)
        names.push_back(entry.name);
    return names;
}

std::vector<const char*> stageNames() { return {std::begin(stages), std::end(stages)}; }

} // namespace agaa
