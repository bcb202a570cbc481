// The interface of techniques. Each is a row of a table; src/core/plan/techniques/ has the rows. Their functions build
// plans, so that they are defined later than this folder. Functions of this folder that look through all rows get the
// table as an argument; planner.h returns it.
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

// The value of n that only an ordered grid of 3 by 3 samples has.
inline constexpr uint32_t gridOnlySamples = 9;

class PlanBuilder;
struct ViewSettings;
struct ResolvedView;

// The conditions on which a generation tier runs.
struct GenerationQuery {
    const AgaaDeviceCaps& caps;
    uint32_t hwSamples = 1;
    bool isForced = false;         // AgaaConfig::generationTier names the tier
    bool customDepth = false;      // materials write depth or discard, so that no pass can compare with the depth of an
                                   // earlier pass before it runs them
    bool hostGBuffer = false;      // the host draws the G-buffer
    bool fetches = false;          // the view has an AgaaFetchFunction
    bool someUnfetched = false;    // the function does not fetch all draws
    bool vertexPulling = false;    // the view has AGAA_VIEW_VERTEX_PULLING
    bool expandsTriangles = false; // compute passes do so, by AgaaFetchFunction::maxTriangles
    bool accumulates = false;      // over frames, for which the view needs a depth buffer
    bool coverageSamples = false;  // AUTO selects among tiers with coverage samples
    bool needsMaterials = false;   // settings need materials when samples are grouped
    uint64_t aggregateBytes = 0;   // of one buffer, if another tier needs none; 0: not checked
    // Tiers that sum aggregates in attachments read the rest.
    bool hasScaledTarget = false; // the samples of a pixel are in several texels
    bool lacksStencil = false;    // no stencil test keeps the first of equal depths
    bool hasUnfiltered = false;   // aggregates have attributes that are no sums
    bool keepsMoments = false;    // aggregates have second moments of their normals
    uint32_t attachments = 0;     // that aggregates need; 0: not checked
};

struct TierAnswer {
    bool runs = false;
    std::string reason; // one sentence, whether it runs or not
};

// A method to generate aggregates. src/core/plan/techniques/generation_tiers.cpp has the rows.
struct GenerationTier {
    AgaaTier tier;
    float relativeCost = 1;      // of whole frames, against post-depth atomics
    bool isAutomatic = false;    // AUTO may select it
    bool isModel = false;        // it is priced and never run
    bool knowsMaterials = false; // when samples are grouped
    bool countsPrimitives = false;
    bool readsGBuffer = false;  // samples are grouped from a G-buffer
    bool sumsFragments = false; // the second geometry pass adds fragments to the sums of aggregates in memory
    // n counts coverage samples, 32, 64 or 128, that the tier finds by itself. Targets have one sample.
    bool hasCoverageSamples = false;
    TierAnswer (*answer)(const GenerationQuery& query);
};

// Upper bounds of the shading work of a frame, for all scenes.
struct ShadingWork {
    uint32_t eventsPerPixel = 0;  // 0: the technique has no bound
    uint32_t samplesPerEvent = 1; // that a shading event represents and looks up in shadow maps
};

// A struct that may be chained to AgaaConfig.
struct TechniqueSettings {
    uint32_t sType;
    // Reads the struct if it is chained. The chain was checked. Throws Error if a member is out of range.
    void (*read)(const AgaaConfig& config, ViewSettings& view);
};

// Facts for techniques that compute coverage from triangles or draw again at equal depth.
inline constexpr uint64_t knownCoverageFacts = (grantingFacts | commonValues) & ~AGAA_FACT_CUSTOM_DEPTH;

struct Technique {
    const char* name;
    uint32_t maxSamples;        // n of tiers without coverage samples; 0: there are none
    uint32_t maxAggregates = 0; // c or S, of techniques with a generation stage; 0: none
    // Samples are grouped by position and by material: the technique has lit shadows, gloss weights and elliptic lobes.
    bool groupsSamples = false;
    bool comparesSamples = false;                      // passes choose the samples of pixels that they shade
    std::span<const GenerationTier* const> tiers = {}; // of materials, in the order in which AUTO prefers them
    std::span<const TechniqueSettings* const> settings = {};
    void (*build)(PlanBuilder& builder);
    // Returns the bounds for settings that a plan resolved.
    ShadingWork (*work)(const ViewSettings& view);

    // Sets defaults of the technique and checks what its row cannot express, after the tiers are chosen. Throws Error.
    // May be null.
    void (*resolve)(ResolvedView& view) = nullptr;
    // Returns whether AUTO prefers an ordered grid if n samples form one. Null: it does not.
    bool (*prefersOrderedGrid)(const ViewSettings& view) = nullptr;
    bool storesWidenedLobes = false; // as roughness, except elliptic lobes
    bool keepsSpread = false;        // of normals, for elliptic lobes
    // Bits of AgaaSceneFacts::flags that views may announce. Tiers may refuse some of them.
    uint64_t facts = grantingFacts | commonValues;

    // Returns whether n counts coverage samples. The tier decides, or with AUTO the value of n.
    bool countsCoverage(uint32_t generationTier, uint32_t samples) const;
    // Returns whether n may be gridOnlySamples. Sums of aggregates need powers of two.
    bool allowsGridOnlySamples() const { return maxAggregates == 0; }
};

// All rows, in static storage.
using TechniqueTable = std::span<const Technique* const>;

const Technique* findTechnique(TechniqueTable table, std::string_view name); // null if there is none

// Returns the types of settings that may be chained to AgaaConfig, those of all techniques. A host may chain multiple
// ones.
std::vector<uint32_t> settingsTypes(TechniqueTable table);

} // namespace agaa
