#include "core/view/resolved_view.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/view/lanes.h"
#include "core/view/tiers.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>

namespace agaa {

namespace {

// Removes what neither the scene nor the technique uses.
void stripUnusedFeatures(ResolvedView& view, const Technique& technique) {
    AgaaConfig& config = view.config;
    const bool showsFacts = view.measurement.debugView == AGAA_DEBUG_VIEW_FACTS;
    config.flags |= showsFacts ? AGAA_CONFIG_CHECK_FACTS : 0;
    config.flags |= config.flags & AGAA_CONFIG_CHECK_FACTS ? AGAA_CONFIG_COUNTERS : 0;
    if (view.measurement.debugView != AGAA_DEBUG_VIEW_NONE) // numbers must not be mixed
        config.flags &= ~AGAA_CONFIG_ACCUMULATE;
    // The debug view of facts stores its colours as diffuse albedo.
    view.layout = reduceLayout(view.layout, view.facts.flags & ~(showsFacts ? AGAA_FACT_NO_DIFFUSE : 0),
                               technique.storesWidenedLobes);
    if (!technique.groupsSamples) { // hosts may leave the settings of "agaa" set while they measure other techniques
        view.aggregation.litShadows = 0;
        config.flags &= ~(AGAA_CONFIG_BUFFERED | AGAA_CONFIG_FINE_MATERIALS);
        view.measurement.flags &= ~AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
    }
    if (view.aggregates < 2) // all samples go to the same aggregate
        view.measurement.flags &= ~AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
    // Elliptic lobes need a specular lobe and a technique that keeps the spread of normals.
    if (!(technique.groupsSamples || technique.keepsSpread) || !view.layout.hasSpecularLight)
        config.ndf = std::min<uint32_t>(config.ndf, AGAA_NDF_TOKSVIG);
    if (!technique.groupsSamples || (view.measurement.flags & AGAA_MEASURE_NO_DIFFUSE_FILTER) ||
        (view.facts.flags & AGAA_FACT_NO_DIFFUSE))
        view.measurement.diffuseFilter = AGAA_DIFFUSE_RECTIFIED;
    if (!technique.groupsSamples || !view.layout.hasSpecularLight)
        view.aggregation.glossWeight = 0;
    const uint32_t lit = view.aggregation.litShadows & ((1u << view.facts.shadowMapCount) - 1);
    if (lit != view.aggregation.litShadows)
        view.notes.push_back(
            "lit aggregates: AgaaAggregation::litShadows names shadows that AgaaSceneFacts does not declare; "
            "they are left out.");
    view.aggregation.litShadows = lit;
}

void checkFacts(const ResolvedView& view, const Technique& technique) {
    const uint64_t refused = view.facts.flags & ~technique.facts;
    if (refused & AGAA_FACT_CUSTOM_DEPTH)
        fail(AGAA_ERROR_UNSUPPORTED, format("\"%s\" does not take materials that write depth or discard on their own "
                                            "(AGAA_FACT_CUSTOM_DEPTH).",
                                            technique.name));
    if (refused)
        fail(AGAA_ERROR_UNSUPPORTED, format("\"%s\" does not take the bits 0x%llx of AgaaSceneFacts::flags.",
                                            technique.name, static_cast<unsigned long long>(refused)));
}

void chooseVisibilityTier(ResolvedView& view, const Technique& technique, const AgaaDeviceCaps& caps) {
    if (technique.countsCoverage(view.config.generationTier, view.samples)) {
        const uint32_t forced = view.config.visibilityTier;
        if (forced != AGAA_TIER_AUTO && forced != AGAA_TIER_NATIVE)
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("visibility cannot run: coverage samples of \"%s\" are found by edges, so that "
                        "the tier %s is not for them.",
                        technique.name, tierName(forced)));
        if (!view.coveragePositions.empty())
            view.samplePositions = view.coveragePositions;
        view.notes.push_back("visibility: " + coverageByEdges(view.samples).reason);
        return;
    }
    if (!view.samplePositions.empty()) {
        view.hwSamples = view.samples;
        view.notes.push_back("visibility: the host says where the samples of its G-buffer lie.");
        return;
    }
    // If the target of an ordered grid is too large for the device, other tiers may have smaller ones.
    const bool fits = uint64_t(std::max(view.width, view.height)) * gridSide(view.samples) <= caps.maxImageSize;
    const VisibilityChoice choice =
        chooseVisibility(caps, view.samples, view.config.visibilityTier,
                         fits && technique.prefersOrderedGrid && technique.prefersOrderedGrid(view));
    if (choice.tier == AGAA_TIER_AUTO)
        fail(AGAA_ERROR_UNSUPPORTED, "visibility cannot run: " + choice.reason);
    view.visibilityTier = choice.tier;
    view.hwSamples = choice.hwSamples;
    view.scaleX = choice.scaleX;
    view.scaleY = choice.scaleY;
    view.layers = choice.layers;
    view.placesSamples = choice.layers > 1 && choice.hwSamples > 1 && caps.flags & AGAA_DEVICE_SAMPLE_LOCATIONS;
    require(view.layers == 1 || !view.hostGBuffer, AGAA_ERROR_UNSUPPORTED,
            "visibility cannot run: the G-buffer of a host has no layers.");
    view.notes.push_back("visibility: " + choice.reason);
}

// The aggregates in memory that two geometry passes fill.
uint64_t aggregateBytes(const ResolvedView& view) {
    const uint64_t moments =
        (view.keepsNormalMoments() ? AGAA_MOMENT_WORDS : 0) + (view.storesDepth() ? AGAA_DEPTH_MOMENT_WORDS : 0);
    const Layout layout = view.needsSampleNormals() ? twoPassLayout(view.layout, view.facts.flags) : view.layout;
    const uint64_t words = packAggregate(layout, view.samples).words + moments;
    return checkedMultiply(uint64_t(view.width) * view.height, 4 * words * view.aggregates + view.claimBytes());
}

// Folded roughness and the spread of normals are one value in memory, which elliptic lobes cannot separate.
bool needsEachNormal(const ResolvedView& view) { return view.keepsNormalMoments() && view.layout.foldsRoughness(); }

// Sets what tiers that sum aggregates in attachments need.
void describeAttachments(const ResolvedView& view, const AgaaDeviceCaps& caps, GenerationQuery& query) {
    const Layout layout = view.needsSampleNormals() ? twoPassLayout(view.layout, view.facts.flags) : view.layout;
    query.hasScaledTarget = view.scaleX * view.scaleY * view.layers > 1;
    const uint64_t stencils = AGAA_DEVICE_D32S8 | (view.reversedZ ? 0 : AGAA_DEVICE_D24S8);
    query.lacksStencil = !(caps.flags & stencils) || view.measurement.flags & AGAA_MEASURE_NO_STENCIL;
    query.hasUnfiltered = layout.unfilteredChannels() != 0 || layout.classChannel() != 0;
    query.keepsMoments = view.keepsNormalMoments();
    query.attachments = uint32_t(packBlendedAggregate(layout, view.samples).attachments.size());
}

void chooseGenerationTier(ResolvedView& view, const AgaaDeviceCaps& caps, TechniqueTable table) {
    const Technique& technique = *view.technique;
    if (technique.tiers.empty())
        return;
    const AgaaConfig& config = view.config;
    GenerationQuery query{.caps = caps,
                          .hwSamples = view.hwSamples,
                          .customDepth = (view.facts.flags & AGAA_FACT_CUSTOM_DEPTH) != 0,
                          .hostGBuffer = view.hostGBuffer,
                          .fetches = view.maxDraws > 0,
                          .someUnfetched = view.someUnfetched,
                          .vertexPulling = view.vertexPulling,
                          .expandsTriangles = view.maxTriangles > 0,
                          .accumulates = view.accumulates(),
                          .coverageSamples = technique.countsCoverage(config.generationTier, view.samples),
                          .needsMaterials = view.aggregation.litShadows || view.aggregation.glossWeight > 0 ||
                                            view.keepsNormalMoments()};
    // The other tiers shade at once, without aggregates in memory.
    if (technique.groupsSamples && !query.coverageSamples && !(config.flags & AGAA_CONFIG_BUFFERED))
        query.aggregateBytes = aggregateBytes(view);
    // The tier that sums aggregates in attachments is for "agaa".
    if (technique.groupsSamples && config.generationTier == AGAA_TIER_NV_MIXED_SAMPLES)
        describeAttachments(view, caps, query);
    const GenerationChoice choice = chooseGeneration(table, technique, query, config.generationTier);
    if (!choice.row)
        fail(AGAA_ERROR_UNSUPPORTED, "generation cannot run: " + choice.reason);
    view.generation = choice.row;
    view.generationTier = choice.row->tier;
    view.notes.push_back("generation: " + choice.reason);
}

void chooseViewLanes(ResolvedView& view, const AgaaDeviceCaps& caps) {
    const Technique& technique = *view.technique;
    const bool countsCoverage = technique.countsCoverage(view.config.generationTier, view.samples);
    const bool resolvesLists = technique.groupsSamples || view.coverage.flags & AGAA_COVERAGE_EXACT;
    if (!(technique.maxAggregates || technique.comparesSamples) || view.isModel() || (countsCoverage && !resolvesLists))
        return;
    const LaneChoice choice = countsCoverage ? chooseListLanes(caps, technique.groupsSamples, view.measurement.lanes)
                                             : chooseLanes(caps, view.samples, view.measurement.lanes);
    if (choice.lanes == AGAA_LANES_AUTO)
        fail(AGAA_ERROR_UNSUPPORTED, "AgaaMeasurement::lanes cannot run: " + choice.reason);
    view.lanes = choice.lanes;
    view.notes.push_back("lanes: " + choice.reason);
}

void checkTierOptions(const ResolvedView& view, const Technique& technique) {
    const AgaaConfig& config = view.config;
    const bool buffered = config.flags & AGAA_CONFIG_BUFFERED;
    require(
        view.aggregation.glossWeight == 0 || view.knowsMaterials(), AGAA_ERROR_UNSUPPORTED,
        "AgaaAggregation::glossWeight needs the tier ids, fragments or gbuffer, which know materials when they group "
        "samples.");
    require(view.aggregation.litShadows == 0 || (view.knowsMaterials() && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaAggregation::litShadows needs the tier fragments, or ids or gbuffer without AGAA_CONFIG_BUFFERED, "
            "which know "
            "materials and shadows in one pass.");
    require(
        !(view.aggregation.litShadows & view.footprintShadows), AGAA_ERROR_UNSUPPORTED,
        "AgaaAggregation::litShadows looks shadows up at samples, and AgaaShadowFunction::footprints for all samples "
        "of an event at once.");
    require(!needsEachNormal(view) || (view.knowsMaterials() && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::ndf needs the tier fragments, or ids or gbuffer without AGAA_CONFIG_BUFFERED for elliptic "
            "lobes, or AGAA_DIFFUSE_SGGX, of a layout with folded roughness, whose aggregates in memory cannot have "
            "them.");
    require(!view.storesDepth() || (technique.groupsSamples && view.sumsFragments()), AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::flags: AGAA_MEASURE_STORED_DEPTH needs \"agaa\" with the tier post-depth-atomics or "
            "per-sample, whose fragments add to the sums of aggregates.");
    require(view.measurement.diffuseFilter != AGAA_DIFFUSE_SGGX || !view.aggregation.litShadows, AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::diffuseFilter: AGAA_DIFFUSE_SGGX excludes AgaaAggregation::litShadows.");
    const uint32_t shown = view.measurement.debugView;
    const bool showsAggregates =
        shown == AGAA_DEBUG_VIEW_AGGREGATES || shown == AGAA_DEBUG_VIEW_CLUSTERS || shown == AGAA_DEBUG_VIEW_WIDENED;
    require(!showsAggregates || technique.maxAggregates, AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows aggregates, of which this technique makes none.");
    require(shown != AGAA_DEBUG_VIEW_WIDENED || !view.layout.foldsRoughness(), AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows widened lobes, which a layout with folded roughness cannot tell.");
    require(shown != AGAA_DEBUG_VIEW_PRIMITIVES || (view.countsPrimitives() && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaMeasurement::debugView shows primitives, which only the tiers fragments, and ids without "
            "AGAA_CONFIG_BUFFERED, count.");
}

} // namespace

void setSurfaceDefaults(ViewSettings& view, float cosine, float distance, float material) {
    const auto set = [](float& value, float otherwise) { value = value > 0 ? value : otherwise; };
    set(view.config.surfaceCosine, cosine);
    set(view.config.surfaceDistance, distance);
    set(view.config.surfaceMaterial, material);
}

ResolvedView resolveForDevice(const ViewSettings& settings, const AgaaDeviceCaps& caps, TechniqueTable table) {
    ResolvedView view(settings);
    const Technique& technique = *view.technique;
    stripUnusedFeatures(view, technique);
    checkFacts(view, technique);
    chooseVisibilityTier(view, technique, caps);
    chooseGenerationTier(view, caps, table);
    chooseViewLanes(view, caps);
    checkTierOptions(view, technique);
    require(!view.hasCounters() || caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_ERROR_UNSUPPORTED,
            "AGAA_CONFIG_COUNTERS needs atomics in fragment shaders, which the device has not.");
    // Eight taps at n = 8 include every sample of the pixel, so that visibility is exact. At higher n eight of an
    // aggregate's samples still span it.
    if (view.config.shadowTaps == 0)
        view.config.shadowTaps = 8;
    if (technique.resolve)
        technique.resolve(view);
    return view;
}

} // namespace agaa
