#include "core/plan/techniques/fragment_lists.h"

#include "core/base/arguments.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/plan/techniques/depth_bounds.h"
#include "core/plan/techniques/triangle_expansion.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>
#include <optional>
#include <utility>

namespace agaa {

bool hasBatches(const ViewSettings& view) { return view.coverage.maxBatches > 1; }

// Lists with materials need shaders of the host.
static bool expandsTriangles(const ResolvedView& view) {
    return view.maxTriangles > 0 && view.generationTier != AGAA_TIER_MATERIAL_LISTS;
}

uint64_t drawSegment(const ViewSettings& view) {
    return hasBatches(view) ? AGAA_SEGMENT_SHADING : AGAA_SEGMENT_PREPASS;
}

// The first draw counts, and limited tiles take three draws (src/shaders/coverage/fragment_layout.glsl).
constexpr uint32_t leastBatches = 4, usualBatches = 16;

void resolveBatches(ViewSettings& view, bool hasLists) {
    uint32_t& batches = view.coverage.maxBatches;
    if (!hasLists)
        batches = 1;
    else if (batches != 1)
        batches = batches ? std::max(batches, leastBatches) : usualBatches;
}

namespace {

// Hosts may chain the struct for all techniques. Other values of n have no coverage samples and no positions.
void readPositions(uint32_t samples, ViewSettings& view) {
    const float* positions = std::exchange(view.coverage.samplePositions, nullptr);
    if (!positions || (samples != 32 && samples != 64 && samples != 128))
        return;
    view.coveragePositions.assign(positions, positions + 2 * samples);
    for (const float place : view.coveragePositions)
        require(place >= 0 && place < 1, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaDecoupledCoverage::samplePositions holds a place outside the pixel, [0;1).");
}

void readCoverage(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaDecoupledCoverage> chained = readChained<AgaaDecoupledCoverage>(&config);
    if (!chained)
        return;
    const AgaaDecoupledCoverage& c = view.coverage = *chained;
    view.coverage.pNext = nullptr;
    checkRange(uint64_t(c.merge), 0, AGAA_MERGE_COLOR, "AgaaDecoupledCoverage::merge");
    checkRange(double(c.fragmentsPerPixel), 1.0, 256.0, "AgaaDecoupledCoverage::fragmentsPerPixel");
    checkRange(uint64_t(c.maxBatches), 0, 64, "AgaaDecoupledCoverage::maxBatches");
    checkReserved(c.reserved, "AgaaDecoupledCoverage::reserved");
    checkFlags(c.flags,
               AGAA_COVERAGE_EXACT | AGAA_COVERAGE_DRAW_ORDER | AGAA_COVERAGE_DEPTH_PREPASS |
                   AGAA_COVERAGE_REVERSE_ORDER,
               "AgaaDecoupledCoverage::flags");
    if (c.flags & AGAA_COVERAGE_REVERSE_ORDER)
        view.coverage.flags |= AGAA_COVERAGE_DRAW_ORDER;
    if (c.tableSize)
        checkRange(uint64_t(c.tableSize), 16, 1024, "AgaaDecoupledCoverage::tableSize");
    checkReserved(c.reservedTable, "AgaaDecoupledCoverage::reservedTable");
    readPositions(config.samples, view);
}

// The buffer of lists has counts, then words of each pixel, then the fragments
// (src/shaders/coverage/fragment_layout.glsl).
struct ListSizes {
    uint64_t heads; // words before the fragments
    uint64_t words; // of a fragment
};

ListSizes listSizes(const PlanBuilder& b) {
    const auto tiles = [](uint32_t pixels) { return (uint64_t(pixels) + 7) / 8; };
    const uint64_t pixels = uint64_t(b.view().width) * b.view().height;
    const uint64_t wordsOfPixels = checkedMultiply(pixels, AGAA_LIST_PIXEL_WORDS + (hasBatches(b.view()) ? 1 : 0));
    const uint64_t wordsOfTiles = hasBatches(b.view()) ? tiles(b.view().width) * tiles(b.view().height) : 0;
    return {checkedAdd(AGAA_LIST_HEADS + wordsOfTiles, wordsOfPixels),
            AGAA_FRAGMENT_MASK_AT + b.view().samples / 32 + b.plan.payloadWords};
}

ResourceId makeLists(PlanBuilder& b, const ListSizes& sizes) {
    const uint64_t pixels = uint64_t(b.view().width) * b.view().height;
    const double wanted = double(pixels) * double(b.view().coverage.fragmentsPerPixel);
    const uint64_t maxWords = b.caps().maxStorageRange / 4;
    const uint64_t forFragments = maxWords > sizes.heads ? maxWords - sizes.heads : 0;
    const uint64_t maxFragments = std::min<uint64_t>(forFragments / sizes.words, 0x7FFFFFFF / sizes.words);
    b.plan.fragmentCapacity = uint64_t(std::min(std::max(wanted, 65536.0), double(maxFragments)));
    if (b.plan.fragmentCapacity < pixels)
        fail(AGAA_ERROR_TOO_LARGE,
             format("lists of fragments need room for a fragment a pixel; one storage buffer of the device "
                    "has room for %llu, and the view has %llu pixels.",
                    static_cast<unsigned long long>(b.plan.fragmentCapacity), static_cast<unsigned long long>(pixels)));
    if (double(b.plan.fragmentCapacity) < wanted)
        b.note(format("lists: room for %.1f fragments a pixel, because one storage buffer of the device holds no more.",
                      double(b.plan.fragmentCapacity) / double(pixels)));
    const uint64_t words = sizes.heads + checkedMultiply(b.plan.fragmentCapacity, sizes.words);
    return b.itemBuffer("fragments", words, 4);
}

} // namespace

namespace {

// Adds a table with the coverage masks of half-planes, for sample positions that the host sets.
ResourceId makeCoverageTable(PlanBuilder& b, uint64_t segment) {
    constexpr uint32_t usualSize = 128; // the paper names none
    const uint32_t size = b.view().coverage.tableSize ? b.view().coverage.tableSize : usualSize;
    require(b.view().coveragePositions.size() == 2 * b.view().samples, AGAA_ERROR_INTERNAL,
            "positions of coverage samples are of another number of samples.");
    b.passConstants()[AGAA_TABLE_SIZE] = size;
    const ResourceId table = b.squareImage("coverage-table", Format::RGBA32U, size);
    Pass& fill = b.compute("fill coverage table", AGAA_STAGE_GENERATION, "coverage_table", segment);
    fill.compute().dispatch = {.kind = DispatchKind::Items, .items = uint64_t(size) * size};
    b.bind(fill, slot::Frame, BindingType::UniformBuffer, b.frameConstants(segment));
    b.bind(fill, slot::CoverageTableOut, BindingType::StorageImage, table, true);
    b.note(format("coverage: by a table of %u x %u half-planes, because the host says where the samples lie.", size,
                  size));
    return table;
}

// Adds a pass of one workgroup that decides which fragments a draw of the scene processes.
void addBatchPass(PlanBuilder& b, const char* name, const char* shader, const FragmentLists& lists) {
    Pass& pass = b.compute(name, AGAA_STAGE_GENERATION, shader, b.plan.passes[lists.firstPass].segment);
    b.bindCommon(pass);
    lists.bindAlone(b, pass);
    pass.compute().dispatch = oneGroup;
}

} // namespace

Pass& drawTriangles(PlanBuilder& b, uint64_t segment) {
    const ResourceId table = b.view().coveragePositions.empty() ? noResource : makeCoverageTable(b, segment);
    Pass& pass = b.hostDraw("fragments", AGAA_STAGE_GENERATION, AGAA_DRAW_PASS_FRAGMENTS, segment);
    b.bindCommon(pass);
    if (table != noResource)
        b.bind(pass, host_slot::CoverageTable, BindingType::Texture, table);
    pass.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
    pass.draw().state.vertexPulling = b.view().vertexPulling;
    pass.draw().expansionText =
        b.view().vertexPulling ? "#include \"host/pulled_hull.glsl\"" : "#include \"host/triangle_hull.glsl\"";
    if (b.view().vertexPulling)
        b.note("triangles: vertex shaders of the host expand them (AGAA_VIEW_VERTEX_PULLING).");
    return pass;
}

namespace {

// Adds passes that append the fragments of all triangles to the lists.
void expandIntoLists(PlanBuilder& b, FragmentLists& lists, uint64_t segment) {
    const ResourceId table = b.view().coveragePositions.empty() ? noResource : makeCoverageTable(b, segment);
    TriangleExpansion expansion{.stage = AGAA_STAGE_GENERATION, .segment = segment};
    expansion.defines = format("#define AGAA_COVERS_TARGET 0\n#define AGAA_PAYLOAD_WORDS %uu\n"
                               "#define AGAA_HAS_BATCHES %d\n#define AGAA_DRAW_ORDER %d\n"
                               "#define AGAA_HAS_DEPTH_PREPASS 0\n#define AGAA_COVERS_BY_TABLE %d\n",
                               b.plan.payloadWords, hasBatches(b.view()),
                               (b.view().coverage.flags & AGAA_COVERAGE_DRAW_ORDER) != 0, table != noResource);
    expansion.bind = [&b, &lists](Pass& pass) { lists.bindAlone(b, pass); };
    expansion.bindFragments = [&b, table](Pass& pass) {
        if (table != noResource)
            b.bind(pass, slot::CoverageTable, BindingType::Texture, table);
    };
    expansion.count(b);
    lists.firstPass = uint32_t(b.plan.passes.size());
    expansion.expand(b, dispatchOf(lists.buffer, AGAA_LIST_TRIANGLE_GROUPS));
}

} // namespace

FragmentLists drawFragments(PlanBuilder& b, uint32_t payloadWords, uint64_t segment) {
    b.plan.payloadWords = payloadWords;
    const ResourceId depth = drawDepthPrepass(b);
    const ListSizes sizes = listSizes(b);
    FragmentLists lists{makeLists(b, sizes)};
    b.fill("clear lists", AGAA_STAGE_GENERATION, lists.buffer, segment).fill().bytes = 4 * sizes.heads;
    boundDepths(b, depth, lists.buffer, segment);
    if (expandsTriangles(b.view())) {
        expandIntoLists(b, lists, segment);
    } else {
        Pass& pass = drawTriangles(b, segment);
        lists.firstPass = uint32_t(b.plan.passes.size() - 1);
        b.bind(pass, host_slot::Fragments, BindingType::StorageBuffer, lists.buffer, true);
    }
    if (hasBatches(b.view()))
        addBatchPass(b, "divide tiles", "divide_tiles", lists);
    return lists;
}

void FragmentLists::finish(PlanBuilder& b) const {
    if (hasBatches(b.view())) {
        addBatchPass(b, "next batch", "next_batch", *this);
        b.plan.repeats.push_back({firstPass, uint32_t(b.plan.passes.size() - 1), b.view().coverage.maxBatches, buffer,
                                  4 * AGAA_LIST_FINISHED});
    }
    b.readListCounts(buffer);
}

void FragmentLists::dispatchTiles(const PlanBuilder& b, Pass& pass) const {
    if (hasBatches(b.view()))
        pass.compute().dispatch = dispatchOf(buffer, AGAA_LIST_TILE_GROUPS);
}

void FragmentLists::bind(PlanBuilder& b, Pass& pass) const {
    b.bindHostFetch(pass);
    pass.compute().defines += format("#define AGAA_PAYLOAD_WORDS %uu\n", b.plan.payloadWords);
    bindAlone(b, pass);
}

void FragmentLists::bindAlone(PlanBuilder& b, Pass& pass) const {
    b.bind(pass, slot::Fragments, BindingType::StorageBuffer, buffer, true);
}

const TechniqueSettings coverageSettings = {.sType = AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE, .read = readCoverage};

} // namespace agaa
