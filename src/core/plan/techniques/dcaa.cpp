// `dcaa`: the fragments of a pixel, with their coverage, are merged into a few surfaces that are shaded once each (Wang
// et al., "Decoupled Coverage Anti-Aliasing", I3D 2016). `sgbc`: likewise, but each sample keeps its depth, so that a
// surface has only the samples that show it (Kerzner and Salvi 2014).
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/depth_bounds.h"
#include "core/plan/techniques/fragment_lists.h"
#include "core/plan/techniques/generation_tiers.h"
#include "core/plan/techniques/techniques.h"
#include "core/view/lanes.h"

#include <algorithm>

namespace agaa {

namespace {

bool isExact(const ViewSettings& view) { return view.coverage.flags & AGAA_COVERAGE_EXACT; }

// A sample shows one fragment, so that exact coverage shades at most n fragments.
ShadingWork work(const ViewSettings& view) { return {isExact(view) ? view.samples : view.aggregates, view.samples}; }

bool carriesMaterials(const ResolvedView& view) { return view.generationTier == AGAA_TIER_MATERIAL_LISTS; }
bool mergesInTargets(const ResolvedView& view) { return view.generationTier == AGAA_TIER_RASTER_ORDER; }
bool mergesInOrder(const ResolvedView& view) {
    return view.generationTier == AGAA_TIER_FRAGMENT_INTERLOCK || mergesInTargets(view);
}

void setThresholds(ViewSettings& view) {
    setSurfaceDefaults(view, 0.98078528f, 1.0f, 1.0f); // the cosine of pi/16 (section 3.2)
}

void resolve(ResolvedView& view) {
    resolveBatches(view, !mergesInOrder(view));
    checkDepthPrepass(view, !mergesInOrder(view));
    require(!mergesInOrder(view) || !(view.coverage.flags & AGAA_COVERAGE_REVERSE_ORDER), AGAA_ERROR_UNSUPPORTED,
            "AGAA_COVERAGE_REVERSE_ORDER needs lists of all fragments.");
    if (!isExact(view))
        return setThresholds(view);
    if (mergesInOrder(view))
        fail(AGAA_ERROR_UNSUPPORTED,
             format("AGAA_COVERAGE_EXACT needs lists of all fragments, which the tier %s does not keep.",
                    tierName(view.generationTier)));
}

void resolveStreamed(ResolvedView& view) {
    require(!isExact(view) && !hasDepthPrepass(view), AGAA_ERROR_UNSUPPORTED,
            "\"sgbc\" keeps the depths of samples, so that it takes neither AGAA_COVERAGE_EXACT nor "
            "AGAA_COVERAGE_DEPTH_PREPASS.");
    resolveBatches(view, true);
    setThresholds(view);
}

Aggregation keptSurfaces(const PlanBuilder& b) {
    Aggregation surfaces;
    surfaces.layout = surfaceLayout(b.view());
    surfaces.packing = packMaterial(surfaces.layout);
    const uint32_t geometryWords = b.view().samples / 32 + AGAA_PLANE_WORDS;
    surfaces.spreadWords = b.view().config.ndf > AGAA_NDF_TOKSVIG ? AGAA_PACKED_SPREAD_WORDS : 0;
    surfaces.stride = geometryWords + surfaces.spreadWords + surfaces.packing.words;
    return surfaces;
}

// otherWords: payload of fragments that do not carry the words of a surface.
FragmentLists drawScene(PlanBuilder& b, const Aggregation& surfaces, uint32_t otherWords, uint64_t segment) {
    if (!carriesMaterials(b.view()))
        return drawFragments(b, otherWords, segment);
    const FragmentLists lists = drawFragments(b, surfaces.stride - b.view().samples / 32, segment);
    b.plan.passes[lists.firstPass].draw().fragmentContent = FragmentContent::Materials;
    setRecord(b.plan.passes[lists.firstPass], surfaces);
    return lists;
}

void readLists(PlanBuilder& b, const FragmentLists& lists, const Aggregation& surfaces, Pass& pass) {
    b.bindCommon(pass);
    if (carriesMaterials(b.view()))
        lists.bindAlone(b, pass);
    else
        lists.bind(b, pass);
    lists.dispatchTiles(b, pass);
    setRecord(pass, surfaces);
}

// Shades the visible part of each fragment. It is the reference for the merge rules.
void buildExact(PlanBuilder& b) {
    const Aggregation surfaces = keptSurfaces(b);
    const FragmentLists lists = drawScene(b, surfaces, AGAA_KEPT_PLANE_WORDS, drawSegment(b.view()));
    b.cullLightsWhereShaded();
    Pass& shade = b.compute("shade fragments", AGAA_STAGE_SHADING,
                            carriesMaterials(b.view()) ? "shade_carried" : "shade_fragments", AGAA_SEGMENT_SHADING);
    readLists(b, lists, surfaces, shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    lists.finish(b);
}

// Behind the surfaces, the buffer has the bounds of pixels, or the depths of samples.
ResourceId surfaceBuffer(PlanBuilder& b) {
    const uint64_t boundBytes = hasDepthPrepass(b.view()) ? 4 : 0;
    const uint64_t depthBytes = b.passConstants()[AGAA_STREAMS] ? 4 * b.view().samples : 0;
    return b.pixelBuffer("surfaces",
                         checkedMultiply(b.view().aggregates, b.plan.bytesPerAggregate) + boundBytes + depthBytes);
}

Pass& drawMerging(PlanBuilder& b, const Aggregation& surfaces) {
    Pass& pass = drawTriangles(b, AGAA_SEGMENT_PREPASS);
    pass.draw().fragmentContent = FragmentContent::Merged;
    pass.constants[AGAA_MERGE_RULE] = b.view().coverage.merge;
    setRecord(pass, surfaces);
    return pass;
}

ResourceId mergeInBuffer(PlanBuilder& b, const Aggregation& surfaces) {
    const ResourceId kept = surfaceBuffer(b);
    b.fill("clear surfaces", AGAA_STAGE_GENERATION, kept, AGAA_SEGMENT_PREPASS);
    Pass& draw = drawMerging(b, surfaces);
    draw.draw().extensions.push_back("ARB_fragment_shader_interlock");
    b.bind(draw, host_slot::Surfaces, BindingType::StorageBuffer, kept, true);
    return kept;
}

ResourceId mergeInTargets(PlanBuilder& b, const Aggregation& surfaces) {
    constexpr uint32_t words = 4; // per texel
    const uint32_t bytes = 4 * b.view().aggregates * surfaces.stride;
    if (bytes > 4 * words * maxFetchedTargets)
        fail(AGAA_ERROR_UNSUPPORTED, format("the tier raster-order keeps up to 128 bytes a pixel in attachments; %u "
                                            "surfaces of this layout take %u.",
                                            b.view().aggregates, bytes));
    const uint32_t attachments = (b.view().aggregates * surfaces.stride + words - 1) / words;
    const ResourceId kept = b.layeredImage("surfaces", Format::RGBA32U, attachments);
    Pass& pass = drawMerging(b, surfaces);
    pass.draw().colorTargets = {kept};
    pass.draw().state.colorAttachmentCount = attachments;
    pass.draw().state.readsAttachments = 1;
    pass.draw().clearsColor = true;
    return kept;
}

// Returns whether the surfaces are in shared memory while lists are merged.
bool mergesInSharedMemory(PlanBuilder& b) {
    constexpr uint32_t lanes = 64;
    const uint32_t words = b.view().samples / 32 + AGAA_SHARED_PLANE_WORDS;
    const uint32_t bytes = 4 * lanes * b.view().aggregates * words;
    const SurfaceMemory memory = chooseSurfaceMemory(b.caps(), bytes, b.view().measurement.lanes);
    if (!memory.canRun)
        fail(AGAA_ERROR_UNSUPPORTED, "AgaaMeasurement::lanes cannot run: " + memory.reason);
    b.note("lanes: " + memory.reason);
    return memory.isShared;
}

ResourceId mergeLists(PlanBuilder& b, const Aggregation& surfaces) {
    const FragmentLists lists = drawScene(b, surfaces, 0, AGAA_SEGMENT_PREPASS);
    const ResourceId kept = surfaceBuffer(b);
    // All passes of a repetition must be in one segment.
    Pass& merge = b.compute("merge fragments", AGAA_STAGE_GENERATION,
                            carriesMaterials(b.view()) ? "merge_carried" : "merge_fragments",
                            hasBatches(b.view()) ? AGAA_SEGMENT_PREPASS : AGAA_SEGMENT_GENERATION,
                            {{Switch::SharedSurfaces, mergesInSharedMemory(b)}});
    readLists(b, lists, surfaces, merge);
    merge.constants[AGAA_MERGE_RULE] = b.view().coverage.merge;
    b.bind(merge, slot::Surfaces, BindingType::StorageBuffer, kept, true);
    lists.finish(b);
    return kept;
}

void build(PlanBuilder& b) {
    b.passConstants()[AGAA_NORMALISES] = hasDepthPrepass(b.view());
    b.passConstants()[AGAA_REVERSE_ORDER] = (b.view().coverage.flags & AGAA_COVERAGE_REVERSE_ORDER) != 0;
    if (isExact(b.view()))
        return buildExact(b);
    const Aggregation surfaces = keptSurfaces(b);
    b.plan.bytesPerAggregate = 4 * surfaces.stride;
    const ResourceId kept = mergesInTargets(b.view()) ? mergeInTargets(b, surfaces)
                            : mergesInOrder(b.view()) ? mergeInBuffer(b, surfaces)
                                                      : mergeLists(b, surfaces);
    b.cullLightsWhereShaded();
    Pass& shade = b.compute("shade surfaces", AGAA_STAGE_SHADING, "shade_surfaces", AGAA_SEGMENT_SHADING,
                            {{Switch::InTargets, mergesInTargets(b.view())}});
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    if (mergesInTargets(b.view()))
        b.bind(shade, slot::SurfaceTargets, BindingType::Texture, kept);
    else
        b.bind(shade, slot::Surfaces, BindingType::StorageBuffer, kept);
    setRecord(shade, surfaces);
}

void buildStreamed(PlanBuilder& b) {
    b.passConstants()[AGAA_STREAMS] = 1;
    build(b);
}

constexpr const GenerationTier* listTiers[] = {&fragmentListsTier, &materialListsTier};
constexpr const GenerationTier* tiers[] = {&fragmentListsTier, &materialListsTier, &interlockTier, &rasterOrderTier};
constexpr const TechniqueSettings* settings[] = {&coverageSettings};

} // namespace

const Technique dcaaTechnique = {.name = "dcaa",
                                 .maxSamples = 0,
                                 .maxAggregates = 8,
                                 .tiers = tiers,
                                 .settings = settings,
                                 .build = build,
                                 .work = work,
                                 .resolve = resolve,
                                 .storesWidenedLobes = true,
                                 .keepsSpread = true,
                                 .facts = knownCoverageFacts};

const Technique sgbcTechnique = {.name = "sgbc",
                                 .maxSamples = 0,
                                 .maxAggregates = 8,
                                 .tiers = listTiers,
                                 .settings = settings,
                                 .build = buildStreamed,
                                 .work = work,
                                 .resolve = resolveStreamed,
                                 .storesWidenedLobes = true,
                                 .keepsSpread = true,
                                 .facts = knownCoverageFacts};

} // namespace agaa
