// What a technique is: a row of a table. src/core/techniques/ has them.
#pragma once

#include "agaa_sdk.h"

#include "core/view/facts.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace agaa {

// n that only an ordered grid has, 3 by 3.
inline constexpr uint32_t gridOnlySamples = 9;

class PlanBuilder;
struct ViewSettings;
struct ResolvedView;

// What decides whether a generation tier runs.
struct GenerationQuery {
    const AgaaDeviceCaps& caps;
    uint32_t hwSamples = 1;
    bool isForced = false;        // AgaaConfig::generationTier names the tier
    bool customDepth = false;     // materials write depth or discard on their own, so that no pass can compare with the
                                  // depth of an earlier one before it runs them
    bool hostGBuffer = false;     // the host draws it
    bool fetches = false;         // the view has an AgaaFetchFunction
    bool someUnfetched = false;   // it does not answer for all draws
    bool vertexPulling = false;   // the view has AGAA_VIEW_VERTEX_PULLING
    bool coverageSamples = false; // AUTO: of the tiers that have them
    bool needsMaterials = false;  // settings need materials where samples are grouped
    uint64_t aggregateBytes = 0;  // of one buffer, where another tier would need none; 0: not asked
};

struct TierAnswer {
    bool runs = false;
    std::string reason; // one sentence, either way
};

// A way to generate aggregates. src/core/plan/techniques/generation_tiers.cpp has them.
struct GenerationTier {
    AgaaTier tier;
    float relativeCost = 1;        // of whole frames, against post-depth atomics
    bool isAutomatic = false;      // AUTO may select it
    bool isModel = false;          // it is priced and never run
    bool knowsMaterials = false;   // when samples are grouped
    bool countsPrimitives = false;
    bool readsGBuffer = false;     // samples are grouped from a G-buffer
    // n counts coverage samples, 32, 64 or 128, that the tier finds by itself. Targets have one sample.
    bool hasCoverageSamples = false;
    TierAnswer (*answer)(const GenerationQuery& query);
};

// The most that a frame shades, whatever the scene.
struct ShadingWork {
    uint32_t eventsPerPixel = 0;  // 0: the technique has no bound
    uint32_t samplesPerEvent = 1; // that a shading event stands for, and looks up in shadows
};

// A struct that may be chained to AgaaConfig.
struct TechniqueSettings {
    uint32_t sType;
    // Where the struct is chained; its chain was checked. Throws Error where a member is out of range.
    void (*read)(const AgaaConfig& config, ViewSettings& view);
};

// Of techniques that find coverage by triangles, or draw again at equal depth.
inline constexpr uint64_t knownCoverageFacts = (grantingFacts | commonValues) & ~AGAA_FACT_CUSTOM_DEPTH;

struct Technique {
    const char* name;
    uint32_t maxSamples;        // n of tiers without coverage samples; 0: there are none
    uint32_t maxAggregates = 0; // c or S, of techniques with a generation stage; 0: none
    // Samples are grouped by position and by material: the technique has lit shadows, gloss weights and elliptic lobes.
    bool groupsSamples = false;
    std::span<const GenerationTier* const> tiers = {}; // of materials, in the order in which AUTO prefers them
    std::span<const TechniqueSettings* const> settings = {};
    void (*build)(PlanBuilder& builder);
    // Of the settings of a plan.
    ShadingWork (*work)(const ViewSettings& plan);

    // Sets defaults of the technique and checks what its row cannot express, after the tiers are chosen. Throws Error. May be
    // null.
    void (*resolve)(ResolvedView& view) = nullptr;
    // Whether AUTO takes an ordered grid where n can be placed on one; null: no.
    bool (*prefersOrderedGrid)(const ViewSettings& view) = nullptr;
    bool storesWidenedLobes = false; // as roughness, unless lobes are elliptic
    bool keepsSpread = false;        // of normals, for elliptic lobes
    // Bits of AgaaSceneFacts::flags that views may announce. Tiers may refuse more; what facts save follows from plans.
    uint64_t facts = grantingFacts | commonValues;

    // Whether n counts coverage samples: the tier, or with AUTO n itself, decides.
    bool countsCoverage(uint32_t generationTier, uint32_t samples) const;
    // Sums of aggregates count samples by powers of two.
    bool takesGridOnlySamples() const { return maxAggregates == 0; }
};
const std::vector<const Technique*>& techniques();
const Technique* findTechnique(std::string_view name); // null where there is none

// Of the structs that may be chained to AgaaConfig: settings of all techniques, so that a host may chain several.
std::vector<uint32_t> settingsTypes();

} // namespace agaa
