// `adaptive`: a G-buffer at n samples. One sample of each pixel is shaded, and further ones if geometry or shading
// differ (Hollaender et al., "Adaptive Supersampling for Deferred Anti-Aliasing", JCGT 2013).
#include "core/base/arguments.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/plan/sample_order.h"
#include "core/plan/techniques/gbuffer.h"
#include "core/plan/techniques/generation_tiers.h"
#include "core/plan/techniques/sample_ids.h"
#include "core/plan/techniques/techniques.h"
#include "core/view/lanes.h"
#include "shaders/tables/choice_words.inc"

#include <bit>

namespace agaa {

namespace {

void readAdaptive(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaAdaptiveSampling> chained = readChained<AgaaAdaptiveSampling>(&config);
    if (!chained)
        return;
    const AgaaAdaptiveSampling& a = view.adaptive = *chained;
    view.adaptive.pNext = nullptr;
    checkFlags(a.flags,
               AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING | AGAA_ADAPTIVE_PRINTED_METRIC | AGAA_ADAPTIVE_IN_ORDER |
                   AGAA_ADAPTIVE_EQUAL_WEIGHTS | AGAA_ADAPTIVE_LOOP | AGAA_ADAPTIVE_DEVICE_PATTERN |
                   AGAA_ADAPTIVE_BUCKETS | AGAA_ADAPTIVE_SORTED | AGAA_ADAPTIVE_TILE_MAXIMUM |
                   AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS | AGAA_ADAPTIVE_BACKGROUND | AGAA_ADAPTIVE_LIGHTS,
               "AgaaAdaptiveSampling::flags");
    checkRange(double(a.depthScale), 0.0, 1e12, "AgaaAdaptiveSampling::depthScale");
    checkRange(double(a.normalScale), 0.0, 1e6, "AgaaAdaptiveSampling::normalScale");
    checkRange(double(a.shadingScale), 0.0, 1e6, "AgaaAdaptiveSampling::shadingScale");
    checkRange(double(a.shadingThreshold), 0.0, 1.0, "AgaaAdaptiveSampling::shadingThreshold");
    checkRange(double(a.shadingMinimum), 0.0, 1.0, "AgaaAdaptiveSampling::shadingMinimum");
    checkRange(double(a.glossWeight), 0.0, 16.0, "AgaaAdaptiveSampling::glossWeight");
    checkRange(double(a.targetEvents), 0.0, 32.0, "AgaaAdaptiveSampling::targetEvents");
    checkRange(double(a.countMemory), 0.0, double(0.99f), "AgaaAdaptiveSampling::countMemory");
    checkReserved(a.reserved, "AgaaAdaptiveSampling::reserved");
}

bool has(const ViewSettings& view, uint64_t flag) { return view.adaptive.flags & flag; }
// Returns whether a pass estimates the light of samples, and others read it.
bool estimatesLight(const ViewSettings& view) {
    return has(view, AGAA_ADAPTIVE_LIGHTS) && !has(view, AGAA_ADAPTIVE_PRINTED_METRIC) &&
           has(view, AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING);
}

// Sets the constants of all passes that are added later.
void setAdaptiveConstants(PlanBuilder& b) {
    const AgaaAdaptiveSampling& a = b.view().adaptive;
    Constants& c = b.passConstants();
    c[AGAA_ADAPTIVE_FLAGS] = uint32_t(estimatesLight(b.view()) ? a.flags : a.flags & ~AGAA_ADAPTIVE_LIGHTS);
    const auto set = [&](Constant constant, float value) {
        c[constant] = value > 0 ? std::bit_cast<uint32_t>(value) : 0;
    };
    set(AGAA_GLOSS_WEIGHT, a.glossWeight);
    set(AGAA_DEPTH_SCALE, a.depthScale);
    set(AGAA_NORMAL_SCALE, a.normalScale);
    set(AGAA_SHADING_SCALE, a.shadingScale);
    set(AGAA_SHADING_THRESHOLD, a.shadingThreshold);
    set(AGAA_SHADING_MINIMUM, a.shadingMinimum);
    set(AGAA_TARGET_EVENTS, a.targetEvents);
    set(AGAA_COUNT_MEMORY, a.countMemory);
    const std::vector<uint32_t> order = sampleOrder(positionsOf(b.plan));
    for (size_t j = 0; j < order.size(); ++j)
        c[AGAA_ORDER0 + j / 4] |= order[j] << 8 * (j % 4);
}

bool hasTarget(const ViewSettings& view) { return view.adaptive.targetEvents > 0; }

// Adds the buffer of sums, choices and lists. All passes write to it.
ResourceId choiceBuffer(PlanBuilder& b) {
    const bool remembers = b.view().adaptive.countMemory > 0;
    const uint64_t words = 2 + (remembers ? 1 : 0) + (has(b.view(), AGAA_ADAPTIVE_SORTED) ? 2 : 0) +
                           (estimatesLight(b.view()) ? (b.view().samples + 3) / 4 : 0);
    const ResourceId choices = b.pixelBuffer("sample-choices", 4 * words);
    Resource& buffer = b.plan.resources[choices];
    buffer.bytes = checkedAdd(buffer.bytes, 4 * AGAA_SUM_WORDS);
    buffer.isPersistent = remembers;
    return choices;
}

// Returns the pass that counts the samples that geometry demands.
uint32_t countingPass(const ViewSettings& view) {
    if (!has(view, AGAA_ADAPTIVE_GEOMETRY) || has(view, AGAA_ADAPTIVE_PRINTED_METRIC))
        return AGAA_FOUND_WITH_FIRST;
    const bool limitsShading = hasTarget(view) && has(view, AGAA_ADAPTIVE_SHADING);
    const bool changesCounts = has(view, AGAA_ADAPTIVE_BUCKETS | AGAA_ADAPTIVE_SORTED | AGAA_ADAPTIVE_TILE_MAXIMUM) ||
                               view.adaptive.countMemory > 0;
    return limitsShading || changesCounts ? AGAA_FOUND_BETWEEN : AGAA_FOUND_WITH_FURTHER;
}

struct Adaptive {
    GBuffer gbuffer;
    std::optional<Ids> ids; // replaces the G-buffer
    ResourceId firstSamples = noResource, choices = noResource;

    void bindSamples(PlanBuilder& b, Pass& pass) const {
        if (!ids)
            return gbuffer.bind(b, pass);
        ids->bind(b, pass);
        setFields(pass.constants, AGAA_SOURCE_DIFFUSE_R,
                  packGBuffer(b.view().layout).fields); // for the precision of features
    }

    void bindDepth(PlanBuilder& b, Pass& pass) const {
        if (!ids)
            return gbuffer.bindDepth(b, pass);
        b.bind(pass, slot::Depth, BindingType::Texture, ids->prepass.depth);
    }
};

void bindChoices(PlanBuilder& b, Pass& pass, const Adaptive& a) {
    b.bind(pass, slot::Choices, BindingType::StorageBuffer, a.choices, true);
}

// Adds a pass that reads samples and chooses some.
Pass& addChoice(PlanBuilder& b, const char* name, const char* shader, const Adaptive& a) {
    Pass& pass = b.compute(name, AGAA_STAGE_SHADING, shader, AGAA_SEGMENT_SHADING);
    a.bindSamples(b, pass);
    bindChoices(b, pass, a);
    return pass;
}

Pass& addShading(PlanBuilder& b, const char* name, const char* shader, const Adaptive& a) {
    Pass& pass = addChoice(b, name, shader, a);
    b.bindCommon(pass);
    b.bindLighting(pass);
    return pass;
}

// Adds a pass over counts. reads: it reads the image of first samples.
Pass& addNumbers(PlanBuilder& b, const char* name, const char* shader, const Adaptive& a, bool reads = false) {
    Pass& pass = b.compute(name, AGAA_STAGE_SHADING, shader, AGAA_SEGMENT_SHADING);
    b.bind(pass, slot::Frame, BindingType::UniformBuffer, b.frameConstants(AGAA_SEGMENT_SHADING));
    bindChoices(b, pass, a);
    if (reads)
        b.bind(pass, slot::FirstSamples, BindingType::Texture, a.firstSamples);
    return pass;
}

const Dispatch once = {.kind = DispatchKind::Items, .items = 1};

// Returns a dispatch with one lane per pixel of a list. list: its index among the sums.
Dispatch listed(const Adaptive& a, uint32_t list) {
    return {.kind = DispatchKind::Indirect, .arguments = a.choices, .argumentsOffset = 4 * (list + 1)};
}

// Sets the lanes of a pass that is compiled with the view and has no permutations of lanes.
void setLanes(const PlanBuilder& b, Pass& pass) {
    pass.compute().fullSubgroups = b.view().lanes == AGAA_LANES_SAMPLE_SUBGROUP;
    pass.compute().defines += format("#define AGAA_SAMPLE_LANES %d\n#define AGAA_SUBGROUPS %d\n",
                                     hasSampleLanes(b.view().lanes), pass.compute().fullSubgroups);
}

void addLightEstimate(PlanBuilder& b, const Adaptive& a) {
    Pass& lights = addChoice(b, "estimate light", "light_samples", a);
    b.bind(lights, slot::Frame, BindingType::UniformBuffer, b.frameConstants(AGAA_SEGMENT_SHADING));
    b.bindLights(lights);
}

// Adds passes that find the limit of differences at which the target is met.
void addLimit(PlanBuilder& b, const Adaptive& a) {
    Pass& demand = addChoice(b, "count demanded samples", "sample_demand", a);
    b.bindCommon(demand);
    addNumbers(b, "find limit", "sample_limit", a).compute().dispatch = once;
}

// Adds passes that count the samples that geometry demands, and find from which demand on shading adds more.
void addCounts(PlanBuilder& b, const Adaptive& a) {
    Pass& counts = addChoice(b, "count samples", "count_samples", a);
    b.bindCommon(counts);
    counts.compute().dispatch = listed(a, AGAA_COMPLEX_PIXELS_AT);
    if (hasTarget(b.view())) {
        addNumbers(b, "count shading's demand", "shading_demand", a, true);
        addNumbers(b, "find shading's limit", "shading_limit", a).compute().dispatch = once;
    }
}

// Adds passes that list the pixels with further samples.
void addList(PlanBuilder& b, const Adaptive& a) {
    Pass& list = b.compute("list further samples", AGAA_STAGE_SHADING, "list_further", AGAA_SEGMENT_SHADING);
    b.bindCommon(list);
    bindChoices(b, list, a);
    b.bind(list, slot::FirstSamples, BindingType::Texture, a.firstSamples);
    b.bindOutput(list);
    if (has(b.view(), AGAA_ADAPTIVE_SORTED)) {
        addNumbers(b, "place counts", "place_counts", a).compute().dispatch = once;
        addNumbers(b, "place pixels", "place_pixels", a).compute().dispatch = listed(a, AGAA_FURTHER_AT);
    }
}

// Rejects options that shade more samples than the differences demand.
void checkTarget(const ViewSettings& view) {
    constexpr uint64_t excluded =
        AGAA_ADAPTIVE_PRINTED_METRIC | AGAA_ADAPTIVE_IN_ORDER | AGAA_ADAPTIVE_BUCKETS | AGAA_ADAPTIVE_TILE_MAXIMUM;
    require(!hasTarget(view) ||
                (has(view, AGAA_ADAPTIVE_GEOMETRY) && !has(view, excluded) && view.adaptive.countMemory == 0),
            AGAA_ERROR_UNSUPPORTED,
            "AgaaAdaptiveSampling::targetEvents needs AGAA_ADAPTIVE_GEOMETRY, and neither countMemory nor the flags "
            "PRINTED_METRIC, IN_ORDER, BUCKETS and TILE_MAXIMUM, by which more samples are shaded.");
}

void resolve(ResolvedView& view) {
    setSurfaceDefaults(view, 0.95f, 1.5f, 0.08f);
    checkTarget(view);
    const uint64_t pixels = checkedMultiply(view.width, view.height);
    if (has(view, AGAA_ADAPTIVE_SORTED) && pixels > 1u << AGAA_RANK_BITS)
        fail(AGAA_ERROR_TOO_LARGE, format("AGAA_ADAPTIVE_SORTED sorts at most %u pixels.", 1u << AGAA_RANK_BITS));
}

void build(PlanBuilder& b) {
    setAdaptiveConstants(b);
    Adaptive a;
    if (b.view().generationTier == AGAA_TIER_IDS)
        a.ids = drawIds(b);
    else
        a.gbuffer = makeGBuffer(b);
    b.bindSceneSamples = [&b, a](Pass& pass) { a.bindSamples(b, pass); };
    a.firstSamples = b.image("first-samples", Format::RGBA16F, false);
    a.choices = choiceBuffer(b);
    b.fill("clear sums", AGAA_STAGE_SHADING, a.choices, AGAA_SEGMENT_SHADING).fill().bytes = 4 * AGAA_SUM_WORDS;
    const uint32_t found = b.passConstants()[AGAA_COUNTS_FOUND] = countingPass(b.view());
    b.cullLights([&](Pass& pass) { a.bindDepth(b, pass); });
    if (estimatesLight(b.view()))
        addLightEstimate(b, a);
    if (hasTarget(b.view()))
        addLimit(b, a);
    Pass& first = addShading(b, "shade first samples", "shade_first", a);
    b.bindOutput(first, a.firstSamples);
    if (a.ids) // from a G-buffer it keeps no values of samples
        setLanes(b, first);
    if (found == AGAA_FOUND_BETWEEN)
        addCounts(b, a);
    addList(b, a);
    Pass& further = addShading(b, "shade further samples", "shade_further", a);
    b.bind(further, slot::FirstSamples, BindingType::Texture, a.firstSamples);
    b.bindOutput(further);
    further.compute().dispatch = listed(a, AGAA_FURTHER_AT);
}

} // namespace

// A host's G-buffer has the device's sample pattern, unless the host sets the positions.
static bool prefersOrderedGrid(const ViewSettings& view) {
    return !view.hostGBuffer && !(view.adaptive.flags & AGAA_ADAPTIVE_DEVICE_PATTERN);
}

static ShadingWork work(const ViewSettings& view) {
    return {view.samples, view.adaptive.flags & AGAA_ADAPTIVE_EQUAL_WEIGHTS ? 1 : view.samples};
}

static const TechniqueSettings adaptiveSettings = {.sType = AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING,
                                                   .read = readAdaptive};
static constexpr const GenerationTier* tiers[] = {&sampleIdsTier, &sampleGBufferTier};
static constexpr const TechniqueSettings* settings[] = {&adaptiveSettings};
const Technique adaptiveTechnique = {.name = "adaptive",
                                     .maxSamples = 32,
                                     .comparesSamples = true,
                                     .tiers = tiers,
                                     .settings = settings,
                                     .build = build,
                                     .work = work,
                                     .resolve = resolve,
                                     .prefersOrderedGrid = prefersOrderedGrid};

} // namespace agaa
