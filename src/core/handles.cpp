#include "core/handles.h"

#include "core/fact_report.h"
#include "core/facts.h"
#include "core/planner.h"
#include "core/structs.h"

#include <algorithm>

#include <cstdlib>
#include <cstring>

namespace agaa {

void* HostAllocator::allocate(size_t size, size_t alignment) const {
    void* memory = allocateCallback ? allocateCallback(user, size, alignment)
                                    : std::aligned_alloc(alignment, (size + alignment - 1) /
                                                                        alignment * alignment);
    require(memory, AGAA_ERROR_OUT_OF_MEMORY, "host memory could not be allocated.");
    return memory;
}

void HostAllocator::free(void* memory) const {
    if (freeCallback)
        freeCallback(user, memory);
    else
        std::free(memory);
}

static const char* backendName(Backend backend) {
    return backend == Backend::Vulkan ? "Vulkan" : "OpenGL";
}

void requireBackend(AgaaContext context, Backend backend) {
    require(context, AGAA_ERROR_INVALID_ARGUMENT, "the context is null.");
    if (context->backend != backend)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("the context is of %s, not of %s.", backendName(context->backend),
                    backendName(backend)));
}

void requireBackend(AgaaView view, Backend backend) {
    require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
    if (view->owner.backend != backend)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("the view is of %s, not of %s.", backendName(view->owner.backend),
                    backendName(backend)));
}

SizedView::SizedView(AgaaContext_T& context, Plan framePlan)
    : owner(context), plan(std::move(framePlan)), sequence(context.framesInFlight), ran_(context.framesInFlight) {
    require(plan.runnable, AGAA_ERROR_UNSUPPORTED,
            "this plan is a model that can be priced but not run.");
    ++owner.viewCount;
}

SizedView::~SizedView() { --owner.viewCount; }

void SizedView::addVariant(const Plan& variantPlan) {
    variants.add(variantPlan, [this](const Pass& pass, size_t index) { return compile(pass, index); });
}

void SizedView::prepare(const ViewSettings& settings, const AgaaSceneFacts& facts) {
    ViewSettings fewer = settings;
    fewer.variantFacts = computeFactsOf(facts, settings.facts);
    addVariant(makePlan(fewer, owner.caps, owner.framesInFlight));
}

const Variant& SizedView::variantOf(const AgaaFrame& frame) {
    chosen_ = sequence.begins(frame) ? &variants.smallest(computeFactsOf(*frame.facts, plan.facts)) : running_;
    return *chosen_;
}

void SizedView::recorded(const AgaaFrame& frame) {
    sequence.recorded(frame);
    running_ = chosen_;
    ran_[sequence.slotOf(frame)] = running_;
}

static AgaaCounters countersOf(const CounterBuffer& source) {
    AgaaCounters out{};
    const auto wide = [&](Counter counter) {
        return uint64_t(source.counts[counter][0]) | uint64_t(source.counts[counter][1]) << 32;
    };
#define AGAA_COUNTER(index, name, member) out.member = wide(name);
#define AGAA_COUNTER_MAX(index, name, member) out.member = wide(name);
#define AGAA_COUNTER_FACT(index, name, member, fact)
#include "shaders/passes/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
    return out;
}

std::optional<CounterBuffer> SizedView::feedback(const AgaaFrame& frame) const {
    const bool isAsked = std::any_of(plan.feedback.begin(), plan.feedback.end(),
                                     [](uint32_t counter) { return counter != noCounter; });
    const FrameSequence::Slot* newest = isAsked ? sequence.newest(frame.completedFrame) : nullptr;
    if (!newest)
        return std::nullopt;
    return readCounters(sequence.indexOf(*newest));
}

AgaaResult SizedView::statistics(uint64_t completedFrame, AgaaFrameStatistics& out) const {
    const FrameSequence::Slot* newest = sequence.newest(completedFrame);
    const MemoryUse memory = memoryUse();
    out.payloadBytes = memory.payload;
    out.driverBytes = memory.driver;
    out.peakBytes = memory.peak;
    out.geometryPasses = plan.geometryPasses();
    const CompileFigures figures = variants.figures();
    out.variantCount = figures.variants;
    out.compileMilliseconds = figures.milliseconds;
    out.compiledPipelines = figures.programs;
    out.cachedPipelines = figures.cached;
    if (!newest)
        return AGAA_NOT_READY;
    out.timeSource = AGAA_TIME_NONE;
    const uint32_t slot = sequence.indexOf(*newest);
    out.variantFlags = ran_[slot]->facts.flags;
    out.variantShadowMaps = ran_[slot]->facts.shadowMapCount;
    out.frameIndex = newest->frame;
    out.counters = plan.config.flags & AGAA_CONFIG_COUNTERS ? countersOf(readCounters(slot))
                                                            : AgaaCounters{};
    const std::vector<double> times = readPassTimes(slot);
    if (!times.empty())
        out.timeSource = timeSource();
    out.passCount = uint32_t(plan.passes.size()); // at most AGAA_MAX_PASSES: the planner refuses more
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        AgaaPassTime& time = out.passes[i];
        time = {};
        std::strncpy(time.name, plan.passes[i].name.c_str(), sizeof time.name - 1);
        time.stage = plan.passes[i].stage;
        time.isTimed = !times.empty();
        time.milliseconds = times.empty() ? 0 : times[i];
    }
    return AGAA_OK;
}

// A few fragments of slivers lie outside their primitives; a wrong camera displaces nearly all.
static bool isMisplaced(const AgaaFrameValidation& v) { return v.misplaced > v.visible / 100; }

// What was found and what usually causes it, the more basic mistake first.
static const char* explain(const AgaaFrameValidation& v, uint32_t geometryPasses) {
    if (v.visible == 0 && geometryPasses == 0)
        return "Nothing is visible: agaaHostSample says of no sample that it shows geometry. Usual causes: its "
               "resources are not those that were drawn, or were not readable by compute yet.";
    if (v.visible == 0)
        return "Nothing is visible: the first geometry pass drew nothing into the target. Usual causes: framebuffer, "
               "viewport or projection are not those of the pass, the depth test is not that of "
               "AgaaDrawState, or AGAA_VIEW_REVERSED_Z does not fit the projection.";
    if (isMisplaced(v))
        return "Fragments do not lie where AgaaFrame's camera puts AgaaSurfaceInput::position. Usual causes: "
               "AgaaFrame::projection is not the rasteriser's (direction of y, clip correction, "
               "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE), positions are not relative to the eye, or another viewport "
               "or view matrix was drawn with.";
    if (v.unannounced)
        return "Fragments have a draw or primitive that AgaaFetchFunction did not announce, and show the last that it "
               "did. Usual causes: more draws or instances than maxDraws, an object of more primitives than "
               "maxPrimitives, AgaaSurfaceInput::draw that does not start at 0, or AGAA_UNFETCHED without "
               "AGAA_FETCH_NOT_ALL_DRAWS.";
    if (v.uncovered && v.overlapping)
        return "Samples were missed and others written where they are not visible. Usual causes: the passes "
               "do not compute the same position (one expression and `invariant gl_Position` in both), or "
               "draw different objects, instances or animation states.";
    if (v.uncovered)
        return "Samples that the prepass shows were never written. Usual causes: an object is left out of "
               "the material pass, positions differ in the last bit (`invariant gl_Position`, one expression "
               "in both passes), the depth test is not EQUAL, cull modes differ, or an alpha mask is not "
               "computed from the same values in both passes.";
    if (v.overlapping)
        return "Samples were written twice or where nothing is visible. Usual causes: objects are drawn that "
               "the prepass left out with the depth test off, or an alpha mask differs between the passes.";
    if (geometryPasses == 0)
        return "Every sample that agaaHostSample shows was accumulated exactly once. Whether its depth fits AgaaFrame's "
               "camera cannot be told.";
    if (geometryPasses == 1)
        return "Every visible sample was written exactly once, by the only geometry pass: there is no other that "
               "it could disagree with. Its fragments lie where AgaaFrame's camera puts them.";
    return "Every visible sample was written exactly once. What this cannot show is a depth test other than "
           "EQUAL in the material pass: then the image differs from that of \"ssaa\".";
}

AgaaResult SizedView::validation(uint64_t completedFrame, AgaaFrameValidation& out) const {
    require(plan.config.flags & AGAA_CONFIG_COUNTERS, AGAA_ERROR_WRONG_ORDER,
            "the view was created without AGAA_CONFIG_COUNTERS.");
    const FrameSequence::Slot* newest = sequence.newest(completedFrame);
    if (!newest)
        return AGAA_NOT_READY;
    const CounterBuffer buffer = readCounters(sequence.indexOf(*newest));
    const AgaaCounters counters = countersOf(buffer);
    out.frameIndex = newest->frame;
    out.visible = counters.visible;
    out.once = counters.once;
    out.uncovered = counters.uncovered;
    out.overlapping = counters.overlapping;
    out.ties = counters.ties;
    out.misplaced = counters.misplaced;
    out.unannounced = counters.unannounced;
    out.invalidPixels = buffer.invalidPixels;
    out.isValid = out.visible != 0 && out.uncovered == 0 && out.overlapping == 0 && out.unannounced == 0 &&
                  !isMisplaced(out);
    out.pixelCount = std::min<uint32_t>(buffer.invalidPixels, AGAA_MAX_INVALID_PIXELS);
    for (uint32_t i = 0; i < AGAA_MAX_INVALID_PIXELS; ++i) {
        out.pixels[i] = {};
        if (i < out.pixelCount)
            std::memcpy(&out.pixels[i], buffer.pixels[i], sizeof buffer.pixels[i]);
    }
    std::strncpy(out.explanation, explain(out, plan.geometryPasses()), sizeof out.explanation - 1);
    out.explanation[sizeof out.explanation - 1] = 0;
    return AGAA_OK;
}

AgaaResult SizedView::facts(uint64_t completedFrame, AgaaFactReport& out) const {
    require(plan.config.flags & AGAA_CONFIG_CHECK_FACTS, AGAA_ERROR_WRONG_ORDER,
            "the view was created without AGAA_CONFIG_CHECK_FACTS.");
    const FrameSequence::Slot* newest = sequence.newest(completedFrame);
    if (!newest)
        return AGAA_NOT_READY;
    out = factReport(plan, *newest, readCounters(sequence.indexOf(*newest)));
    return AGAA_OK;
}

AgaaResult reportFacts(AgaaView_T& view, uint64_t completedFrame, AgaaFactReport& out) {
    const AgaaResult result = view.current->facts(completedFrame, out);
    const bool isNews = result == AGAA_OK && out.contradicted && !view.isToldOfFacts;
    if (isNews)
        view.owner.log.write(AGAA_SEVERITY_WARNING, AGAA_OK, out.explanation);
    view.isToldOfFacts = view.isToldOfFacts || isNews;
    return result;
}

void destroyView(AgaaView view) {
    const HostAllocator allocator = view->owner.allocator;
    destroy(allocator, view->current);
    destroy(allocator, view);
}

void resizeView(AgaaView_T& view, uint32_t width, uint32_t height) {
    require(width > 0 && height > 0, AGAA_ERROR_OUT_OF_RANGE,
            "the view would have no pixels: width and height must be at least 1.");
    ViewSettings settings = view.settings;
    settings.width = width;
    settings.height = height;
    SizedView* remade = view.current->remade(settings);
    try {
        for (const AgaaSceneFacts& facts : view.current->variants.facts())
            if (!isWithin(settings.facts, facts)) // it has that of the view's own
                remade->prepare(settings, facts);
    } catch (...) {
        destroy(view.owner.allocator, remade);
        throw;
    }
    remade->sequence.startAfter(view.current->sequence);
    destroy(view.owner.allocator, view.current);
    view.current = remade;
    view.settings.width = width;
    view.settings.height = height;
}

void prepareVariants(AgaaView_T& view, uint32_t count, const AgaaSceneFacts* first) {
    require(count == 0 || first, AGAA_ERROR_INVALID_ARGUMENT, "the facts pointer is null.");
    std::vector<AgaaSceneFacts> list;
    for (uint32_t i = 0; i < count; ++i) {
        list.push_back(checkFacts(elementOf(first, i)));
        requireEqualSizes(elementOf(first, i), first);
        checkWithin(list.back(), view.settings.facts, format("facts[%u]", i).c_str());
    }
    for (const AgaaSceneFacts& facts : list)
        view.current->prepare(view.settings, facts);
}

} // namespace agaa
