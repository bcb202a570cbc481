#include "core/view/tiers.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/view/technique.h"
#include "core/view/view_settings.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace agaa {

static bool hasSamples(const AgaaDeviceCaps& caps, uint32_t samples) {
    return (caps.sampleCounts >> std::countr_zero(samples)) & 1;
}

static VisibilityChoice scaledTarget(const AgaaDeviceCaps& caps, uint32_t samples) {
    VisibilityChoice choice;
    for (uint32_t hw = samples / 2; hw >= 1; hw /= 2) {
        if (!hasSamples(caps, hw))
            continue;
        const uint32_t groups = samples / hw;
        // The scales are 1x2, 2x2, 2x4, 4x4 and 4x8. Tall pixels measured better near vertical edges than wide ones.
        choice.scaleX = 1u << (std::bit_width(groups) - 1) / 2;
        choice.scaleY = groups / choice.scaleX;
        choice.hwSamples = hw;
        choice.tier = AGAA_TIER_SCALED_TARGET;
        choice.relativeCost = 1; // 0.9 to 1.0 of native at n = 4 on lavapipe
        choice.reason = format("a target of %ux%u sub-pixels at %u samples each gives %u per pixel.", choice.scaleX,
                               choice.scaleY, hw, samples);
        return choice;
    }
    choice.reason = format("%u samples cannot be made of the device's sample counts.", samples);
    return choice;
}

uint32_t gridSide(uint32_t samples) { return samples == 4 ? 2 : samples == 9 ? 3 : samples == 16 ? 4 : 0; }

// Each sample of the pixel gets a texel of one sample, as in ordered-grid supersampling.
static VisibilityChoice orderedGrid(uint32_t samples) {
    VisibilityChoice choice;
    const uint32_t side = gridSide(samples);
    if (side == 0) {
        choice.reason = format("an ordered grid has 4, 9 or 16 samples, not %u.", samples);
        return choice;
    }
    choice.tier = AGAA_TIER_ORDERED_GRID;
    choice.scaleX = choice.scaleY = side;
    choice.reason = format("a target of %ux%u texels of one sample each gives %u per pixel.", side, side, samples);
    return choice;
}

// Sets the layers of hw samples each that make n samples. Patterns are known for 2, 4 and 8 layers.
static bool hasLayers(const AgaaDeviceCaps& caps, uint32_t samples, VisibilityChoice& choice) {
    for (choice.layers = 2; choice.layers <= maxLayers; choice.layers *= 2) {
        choice.hwSamples = samples / choice.layers;
        // The pattern of 16 has samples at the border of the pixel, which no offset keeps inside.
        const bool canMove = choice.hwSamples <= 8 || caps.flags & AGAA_DEVICE_SAMPLE_LOCATIONS;
        if (choice.hwSamples >= 1 && canMove && hasSamples(caps, choice.hwSamples))
            return true;
    }
    return false;
}

static VisibilityChoice layers(const AgaaDeviceCaps& caps, uint32_t samples, AgaaTier tier) {
    VisibilityChoice choice;
    if (tier == AGAA_TIER_NV_MULTICAST && !(caps.flags & AGAA_DEVICE_NV_MULTICAST)) {
        choice.reason = "the device has no viewport multicast (AGAA_DEVICE_NV_MULTICAST).";
        return choice;
    }
    if (!hasLayers(caps, samples, choice)) {
        choice = {};
        choice.reason =
            format("%u samples cannot be made of up to %u layers of the device's sample counts.", samples, maxLayers);
        return choice;
    }
    choice.tier = tier;
    // The prepass takes this beside that of a scaled target, at n = 8, 16 and 32 on lavapipe. Multicast has not run.
    choice.relativeCost = tier == AGAA_TIER_NV_MULTICAST ? 0 : choice.layers == 2 ? 1.3f : 2.4f;
    const bool isPlaced = caps.flags & AGAA_DEVICE_SAMPLE_LOCATIONS && choice.hwSamples > 1;
    choice.reason = format("%u layers of %u samples each, %s, give %u per pixel.", choice.layers, choice.hwSamples,
                           isPlaced ? "spread over the pixel"
                                    : "moved by less than the distance of standard locations from its border",
                           samples);
    return choice;
}

VisibilityChoice chooseVisibility(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced, bool prefersGrid) {
    if (samples != gridOnlySamples)
        checkSampleCount(samples, "the number of samples per pixel");
    const bool isGridOnly = samples == gridOnlySamples;
    VisibilityChoice choice;
    if (forced == AGAA_TIER_ORDERED_GRID || (forced == AGAA_TIER_AUTO && (prefersGrid || isGridOnly))) {
        choice = orderedGrid(samples);
        if (choice.tier != AGAA_TIER_AUTO || forced != AGAA_TIER_AUTO)
            return choice;
    }
    if (isGridOnly) {
        choice.reason = format("the tier %s has no %u samples per pixel.", tierName(forced), samples);
        return choice;
    }
    if (forced == AGAA_TIER_NATIVE || forced == AGAA_TIER_AUTO) {
        if (hasSamples(caps, samples)) {
            choice.tier = AGAA_TIER_NATIVE;
            choice.hwSamples = samples;
            choice.reason = format("the device rasterises %u samples per pixel.", samples);
            return choice;
        }
        choice.reason = format("the device has no %u samples per pixel.", samples);
        if (forced == AGAA_TIER_NATIVE)
            return choice;
    }
    if (forced == AGAA_TIER_SCALED_TARGET || forced == AGAA_TIER_AUTO)
        return scaledTarget(caps, samples);
    if (forced == AGAA_TIER_LAYERS || forced == AGAA_TIER_NV_MULTICAST)
        return layers(caps, samples, AgaaTier(forced));
    choice.reason = format("the tier %s is not built for visibility.", tierName(forced));
    return choice;
}

VisibilityChoice coverageByEdges(uint32_t samples) {
    VisibilityChoice choice;
    choice.tier = AGAA_TIER_NATIVE;
    choice.reason = format("%u coverage samples by the edges of each triangle.", samples);
    return choice;
}

// Returns the names of the techniques that have the tier.
static std::string techniquesWith(TechniqueTable table, uint32_t tier) {
    std::string names;
    for (const Technique* technique : table)
        for (const GenerationTier* row : technique->tiers)
            if (row->tier == AgaaTier(tier))
                names += (names.empty() ? "\"" : ", \"") + std::string(technique->name) + "\"";
    return names;
}

GenerationChoice chooseGeneration(TechniqueTable table, const Technique& technique, GenerationQuery query,
                                  uint32_t forced) {
    checkSampleCount(query.hwSamples, "the number of samples per texel");
    query.isForced = forced != AGAA_TIER_AUTO;
    GenerationChoice choice;
    for (const GenerationTier* row : technique.tiers) {
        if (query.isForced ? row->tier != AgaaTier(forced)
                           : !row->isAutomatic || row->hasCoverageSamples != query.coverageSamples)
            continue;
        const TierAnswer answer = row->answer(query);
        choice.reason = answer.reason;
        if (answer.runs) {
            choice.row = row;
            return choice;
        }
    }
    if (choice.reason.empty()) { // the technique lacks the tier
        const std::string names = techniquesWith(table, forced);
        choice.reason = names.empty() ? format("the tier %s is not built for generation.", tierName(forced))
                                      : format("the tier %s is for %s.", tierName(forced), names.c_str());
    }
    return choice;
}

static AgaaCapability capability(const Technique& technique, uint32_t samples, AgaaStage stage, AgaaTier tier,
                                 bool native, float cost, const std::string& reason) {
    AgaaCapability row = AGAA_CAPABILITY_INIT;
    row.technique = technique.name;
    row.samples = samples;
    row.stage = stage;
    row.tier = tier;
    row.isNative = native;
    row.relativeCost = cost;
    std::strncpy(row.reason, reason.c_str(), sizeof row.reason - 1);
    return row;
}

// Puts the features that the host must provide before the reason.
static std::string withNeeds(const GenerationQuery& query, const std::string& reason) {
    std::string needs;
    if (query.fetches)
        needs = query.expandsTriangles ? "an AgaaFetchFunction and its maxTriangles" : "an AgaaFetchFunction";
    if (query.vertexPulling)
        needs += needs.empty() ? "AGAA_VIEW_VERTEX_PULLING" : " and AGAA_VIEW_VERTEX_PULLING";
    return needs.empty() ? reason : format("with %s, %s", needs.c_str(), reason.c_str());
}

// The first choice is that of AUTO. The other tiers that run follow, then those that need an AgaaFetchFunction.
static std::vector<GenerationChoice> runningChoices(TechniqueTable table, const Technique& technique,
                                                    const GenerationQuery& query) {
    GenerationQuery offered = query;
    offered.fetches = true;
    const GenerationChoice automatic = chooseGeneration(table, technique, query, AGAA_TIER_AUTO);
    std::vector<GenerationChoice> choices, offers;
    if (automatic.row)
        choices.push_back(automatic);
    for (const GenerationTier* row : technique.tiers) {
        if (row->hasCoverageSamples != query.coverageSamples || row->isModel || row == automatic.row)
            continue;
        if (const GenerationChoice choice = chooseGeneration(table, technique, query, row->tier); choice.row)
            choices.push_back(choice);
        else if (const GenerationChoice offer = chooseGeneration(table, technique, offered, row->tier); offer.row)
            offers.push_back(offer);
    }
    for (GenerationChoice& choice : choices)
        choice.reason = withNeeds(query, choice.reason);
    for (GenerationChoice& offer : offers)
        choices.push_back({offer.row, withNeeds(offered, offer.reason)});
    return choices;
}

// If nothing runs, the list has the tiers that run with vertex pulling, or else those that run if compute passes expand
// triangles.
static std::vector<GenerationChoice> generationChoices(TechniqueTable table, const Technique& technique,
                                                       const GenerationQuery& query) {
    GenerationQuery pulled = query, expanded = query;
    pulled.vertexPulling = true;
    expanded.expandsTriangles = true;
    for (const GenerationQuery* tried : std::initializer_list<const GenerationQuery*>{&query, &pulled, &expanded})
        if (const std::vector<GenerationChoice> choices = runningChoices(table, technique, *tried); !choices.empty())
            return choices;
    GenerationQuery fetched = query;
    fetched.fetches = true;
    return {{nullptr, chooseGeneration(table, technique, fetched, AGAA_TIER_AUTO).reason}};
}

namespace {

void addVisibility(std::vector<AgaaCapability>& rows, const Technique& technique, uint32_t samples,
                   const VisibilityChoice& choice) {
    rows.push_back(capability(technique, samples, AGAA_STAGE_PREPASS, choice.tier, choice.tier == AGAA_TIER_NATIVE,
                              choice.relativeCost, choice.reason));
}

void addGeneration(std::vector<AgaaCapability>& rows, TechniqueTable table, const Technique& technique,
                   uint32_t samples, const GenerationQuery& query) {
    for (const GenerationChoice& choice : generationChoices(table, technique, query))
        rows.push_back(capability(technique, samples, AGAA_STAGE_GENERATION,
                                  choice.row ? choice.row->tier : AGAA_TIER_AUTO, false,
                                  choice.row ? choice.row->relativeCost : 0, choice.reason));
}

void addShading(std::vector<AgaaCapability>& rows, const Technique& technique, uint32_t samples) {
    rows.push_back(capability(technique, samples, AGAA_STAGE_SHADING, AGAA_TIER_NATIVE, true, 1, "a compute pass."));
}

// Adds rows for samples that the device rasterises.
void addDeviceSamples(std::vector<AgaaCapability>& rows, TechniqueTable table, const AgaaDeviceCaps& caps,
                      const Technique& technique, uint32_t samples) {
    const bool prefersGrid = technique.prefersOrderedGrid && technique.prefersOrderedGrid({});
    const VisibilityChoice visibility = chooseVisibility(caps, samples, AGAA_TIER_AUTO, prefersGrid);
    addVisibility(rows, technique, samples, visibility);
    if (visibility.tier == AGAA_TIER_AUTO)
        return; // no later stage can run either
    for (const AgaaTier tier :
         {AGAA_TIER_NATIVE, AGAA_TIER_SCALED_TARGET, AGAA_TIER_ORDERED_GRID, AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST})
        if (const VisibilityChoice other = chooseVisibility(caps, samples, tier);
            other.tier != AGAA_TIER_AUTO && other.tier != visibility.tier)
            addVisibility(rows, technique, samples, other);
    if (technique.maxAggregates)
        rows.push_back(
            capability(technique, samples, AGAA_STAGE_DEFINITION, AGAA_TIER_NATIVE, true, 1, "a compute pass."));
    if (!technique.tiers.empty())
        addGeneration(rows, table, technique, samples,
                      {.caps = caps,
                       .hwSamples = visibility.hwSamples,
                       .hasScaledTarget = visibility.scaleX * visibility.scaleY > 1,
                       .lacksStencil = !(caps.flags & (AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8))});
    addShading(rows, technique, samples);
}

void addCoverageSamples(std::vector<AgaaCapability>& rows, TechniqueTable table, const AgaaDeviceCaps& caps,
                        const Technique& technique, uint32_t samples) {
    addVisibility(rows, technique, samples, coverageByEdges(samples));
    addGeneration(rows, table, technique, samples, {.caps = caps, .coverageSamples = true});
    addShading(rows, technique, samples);
}

} // namespace

std::vector<AgaaCapability> listCapabilities(TechniqueTable table, const AgaaDeviceCaps& caps) {
    std::vector<AgaaCapability> rows;
    for (const Technique* technique : table) {
        for (uint32_t samples = 1; samples <= technique->maxSamples; samples *= 2)
            addDeviceSamples(rows, table, caps, *technique, samples);
        if (technique->allowsGridOnlySamples() && technique->maxSamples > gridOnlySamples)
            addDeviceSamples(rows, table, caps, *technique, gridOnlySamples);
        // At n = 32 tiers of both kinds may run. AUTO then uses samples of the device.
        for (uint32_t samples : {32u, 64u, 128u})
            if (technique->countsCoverage(AGAA_TIER_AUTO, samples))
                addCoverageSamples(rows, table, caps, *technique, samples);
    }
    return rows;
}

} // namespace agaa
