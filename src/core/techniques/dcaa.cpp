// `dcaa`: all fragments of a pixel with their coverage, merged into a few surfaces that are shaded once each (Wang et al.,
// "Decoupled Coverage Anti-Aliasing", I3D 2016).
#include "core/checked.h"
#include "core/error.h"
#include "core/structs.h"
#include "core/techniques/aggregation.h"
#include "core/techniques/generation_tiers.h"
#include "core/techniques/techniques.h"
#include "core/validate.h"

#include <algorithm>
#include <optional>

namespace agaa {

namespace {

void readCoverage(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaDecoupledCoverage> chained = readChained<AgaaDecoupledCoverage>(&config);
    if (!chained)
        return;
    const AgaaDecoupledCoverage& c = view.coverage = *chained;
    view.coverage.pNext = nullptr;
    checkRange(uint64_t(c.merge), 0, AGAA_MERGE_NONE, "AgaaDecoupledCoverage::merge");
    checkRange(double(c.fragmentsPerPixel), 1.0, 256.0, "AgaaDecoupledCoverage::fragmentsPerPixel");
    checkRange(uint64_t(c.maxBatches), 1, 16, "AgaaDecoupledCoverage::maxBatches");
    checkReserved(c.reserved, "AgaaDecoupledCoverage::reserved");
    checkFlags(c.flags, AGAA_COVERAGE_EXACT, "AgaaDecoupledCoverage::flags");
}

// Words of the buffer of lists: its counts, then the first fragment of each pixel, then the fragments
// (src/shaders/passes/fragment_layout.glsl).
struct ListSizes {
    uint64_t heads, words; // before the fragments; of a fragment
};
constexpr uint64_t countWords = 16, goesOnWord = 3;

bool isExact(const PlanBuilder& b) { return b.plan.coverage.flags & AGAA_COVERAGE_EXACT; }
uint32_t planeWords(const PlanBuilder& b) { return isExact(b) ? 3 : 0; }
bool hasBatches(const PlanBuilder& b) { return b.plan.coverage.maxBatches > 1; }

ListSizes listSizes(const PlanBuilder& b) {
    const auto tiles = [](uint32_t pixels) { return (uint64_t(pixels) + 7) / 8; };
    const uint64_t words = hasBatches(b) ? tiles(b.plan.width) * tiles(b.plan.height) : 0;
    return {countWords + uint64_t(b.plan.width) * b.plan.height + words, 2 + b.plan.samples / 32 + planeWords(b)};
}

ResourceId fragmentLists(PlanBuilder& b) {
    const ListSizes sizes = listSizes(b);
    const uint64_t pixels = uint64_t(b.plan.width) * b.plan.height;
    const double wanted = double(pixels) * double(b.plan.coverage.fragmentsPerPixel);
    const uint64_t most = b.caps().maxStorageRange / 4;
    const uint64_t room = std::min<uint64_t>(most > sizes.heads ? (most - sizes.heads) / sizes.words : 0, 0x7FFFFFFF / sizes.words);
    b.plan.poolRecords = std::min<uint64_t>(std::max<uint64_t>(uint64_t(wanted), 65536), room);
    if (b.plan.poolRecords < pixels)
        fail(AGAA_ERROR_TOO_LARGE, format("lists of fragments need room for a fragment a pixel; one storage buffer of the device "
                                          "has room for %llu, and the view has %llu pixels.",
                                          static_cast<unsigned long long>(b.plan.poolRecords),
                                          static_cast<unsigned long long>(pixels)));
    if (double(b.plan.poolRecords) < wanted)
        b.note(format("lists: room for %.1f fragments a pixel, because one storage buffer of the device holds no more.",
                      double(b.plan.poolRecords) / double(pixels)));
    const uint64_t words = sizes.heads + checkedMultiply(b.plan.poolRecords, sizes.words);
    return b.itemBuffer("fragments", words, 4);
}

// A surface keeps the mean over its fragments at the precision that samples have.
Layout surfaceLayout(Layout layout) {
    for (AgaaLayoutAttribute& attribute : layout.attributes) {
        attribute.encoding = AGAA_ENCODING_UNORM;
        attribute.aggregateBits = std::max(attribute.sampleBits, 6u);
    }
    layout.customs.clear(); // nothing reads them: agaaGetAggregateGlsl() is for "agaa"
    return layout;
}

// A group that decides what a draw of the scene is for.
void addBatchPass(PlanBuilder& b, const char* name, const char* shader, ResourceId fragments) {
    Pass& pass = b.compute(name, AGAA_STAGE_GENERATION, shader, AGAA_SEGMENT_PREPASS);
    b.bindCommon(pass);
    b.bind(pass, slot::Fragments, BindingType::StorageBuffer, fragments, true);
    pass.dispatch = {.kind = DispatchKind::Items, .items = 1};
}

ResourceId drawFragments(PlanBuilder& b) {
    const ResourceId fragments = fragmentLists(b);
    b.fill("clear lists", AGAA_STAGE_GENERATION, fragments, AGAA_SEGMENT_PREPASS).fillBytes = 4 * listSizes(b).heads;
    Pass& draw = b.hostDraw("fragments", AGAA_STAGE_GENERATION, AGAA_DRAW_PASS_FRAGMENTS, AGAA_SEGMENT_PREPASS);
    b.bindCommon(draw);
    draw.drawState.depthCompare = AGAA_COMPARE_ALWAYS;
    draw.geometryText = "#include \"host/triangle_hull.glsl\"";
    b.bind(draw, host_slot::Fragments, BindingType::StorageBuffer, fragments, true);
    return fragments;
}

void bindFragments(PlanBuilder& b, Pass& pass, ResourceId fragments) {
    b.bindHostFetch(pass);
    pass.defines += format("#define AGAA_PLANE_WORDS %uu\n", planeWords(b));
    b.bind(pass, slot::Fragments, BindingType::StorageBuffer, fragments, true);
}

// What shows of each fragment is shaded: the reference of the merging ways.
void buildExact(PlanBuilder& b) {
    require(!hasBatches(b), AGAA_ERROR_UNSUPPORTED,
            "AgaaDecoupledCoverage::maxBatches is for lists that are merged; AGAA_COVERAGE_EXACT needs all fragments at once.");
    const ResourceId fragments = drawFragments(b);
    Pass& shade = b.compute("shade fragments", AGAA_STAGE_SHADING, "shade_fragments", AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    bindFragments(b, shade, fragments);
    b.bindLighting(shade);
    b.bindOutput(shade);
    b.copyCounters();
}

void build(PlanBuilder& b) {
    if (isExact(b))
        return buildExact(b);
    b.defaultSurface(0.98078528f, 1.0f, 1.0f); // the cosine of pi/16 (section 3.2)
    Aggregation surfaces;
    surfaces.layout = surfaceLayout(b.plan.layout);
    surfaces.packing = packMaterial(surfaces.layout);
    const uint32_t geometryWords = b.plan.samples / 32 + 3; // of src/shaders/passes/covered_surface.glsl
    surfaces.stride = geometryWords + surfaces.packing.words;
    b.plan.bytesPerAggregate = 4 * surfaces.stride;

    const ResourceId fragments = drawFragments(b);
    const auto firstOfBatch = uint32_t(b.plan.passes.size() - 1);
    if (hasBatches(b))
        addBatchPass(b, "divide tiles", "divide_tiles", fragments);
    const ResourceId kept = b.pixelBuffer("surfaces", checkedMultiply(b.plan.aggregates, b.plan.bytesPerAggregate));
    // A repetition lies in one segment.
    Pass& merge = b.compute("merge fragments", AGAA_STAGE_GENERATION, "merge_fragments",
                            hasBatches(b) ? AGAA_SEGMENT_PREPASS : AGAA_SEGMENT_GENERATION);
    b.bindCommon(merge);
    bindFragments(b, merge, fragments);
    merge.defines += format("#define AGAA_MERGE_RULE %uu\n", b.plan.coverage.merge);
    b.bind(merge, slot::Aggregates, BindingType::StorageBuffer, kept, true);
    setRecord(merge, surfaces);
    if (hasBatches(b)) {
        addBatchPass(b, "next batch", "next_batch", fragments);
        b.plan.repeats.push_back({firstOfBatch, uint32_t(b.plan.passes.size() - 1), b.plan.coverage.maxBatches, fragments,
                                  4 * goesOnWord});
    }

    Pass& shade = b.compute("shade surfaces", AGAA_STAGE_SHADING, "shade_surfaces", AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    b.bind(shade, slot::Aggregates, BindingType::StorageBuffer, kept);
    setRecord(shade, surfaces);
    b.copyCounters();
}

constexpr TechniqueSettings coverageSettings = {AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE, readCoverage};
constexpr const GenerationTier* tiers[] = {&fragmentListsTier};
constexpr const TechniqueSettings* settings[] = {&coverageSettings};

} // namespace

const Technique dcaaTechnique = {"dcaa", 128, true, 8, false, tiers, settings, build};

} // namespace agaa
