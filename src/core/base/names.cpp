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

// Returns the length of the UTF-8 character at the beginning of a text; 0 if there is none, or if it is a control
// character.
static size_t characterLength(std::string_view text) {
    const auto byteAt = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const uint32_t first = byteAt(0);
    if (first < 0x80)
        return first >= 0x20 && first != 0x7F ? 1 : 0;
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    uint32_t code = first & (0xFFu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byteAt(i) & 0xC0) != 0x80)
            return 0;
        code = code << 6 | (byteAt(i) & 0x3F);
    }
    // Two bytes encode control characters below 0xA0. Longer codes must not be shorter ones in disguise.
    constexpr uint32_t least[] = {0, 0, 0xA0, 0x800, 0x10000};
    const bool isSurrogate = code >= 0xD800 && code <= 0xDFFF;
    const bool isLineBreak = code == 0x2028 || code == 0x2029;
    return first >= 0xC2 && first <= 0xF4 && code >= least[length] && code <= 0x10FFFF && !isSurrogate && !isLineBreak
               ? length
               : 0;
}

std::string printable(std::string_view text, size_t maxBytes) {
    std::string out;
    for (size_t at = 0; at < text.size();) {
        const size_t length = std::max<size_t>(characterLength(text.substr(at)), 1);
        if (at + length > maxBytes)
            break;
        if (characterLength(text.substr(at)) == 0)
            out += format("\\x%02X", static_cast<unsigned char>(text[at]));
        else
            out += text.substr(at, length);
        at += length;
    }
    return out;
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
