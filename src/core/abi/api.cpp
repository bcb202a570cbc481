// The part of the C ABI that needs no graphics API.
#include "core/abi/api_guard.h"
#include "core/abi/draw_passes.h"
#include "core/abi/handles.h"
#include "core/abi/tuning_inputs.h"
#include "core/base/arguments.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/structs.h"
#include "core/frame/temporal.h"
#include "core/glsl/aggregate_glsl.h"
#include "core/glsl/glsl_text.h"
#include "core/plan/planner.h"
#include "core/plan/surfaces.h"
#include "core/reports/breadcrumbs.h"
#include "core/reports/frame_statistics.h"
#include "core/reports/frame_validation.h"
#include "core/reports/prices.h"
#include "core/tuning/goals.h"
#include "core/tuning/observations.h"
#include "core/view/layout.h"
#include "core/view/presets.h"
#include "core/view/technique.h"
#include "core/view/tiers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

using namespace agaa;

namespace {

AgaaDeviceCaps capsOrIdeal(const AgaaDeviceCaps* caps) {
    if (!caps)
        return idealDevice();
    const AgaaDeviceCaps known = readStruct(caps);
    if (known.subgroupSize != 0 && (known.subgroupSize > 128 || !std::has_single_bit(known.subgroupSize)))
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaDeviceCaps::subgroupSize is %u; it is 0 or a power of two up to 128.", known.subgroupSize));
    // No device has targets of more than 64 samples.
    if (known.sampleCounts > 0x7F)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaDeviceCaps::sampleCounts is 0x%x; it has bits up to 6.", known.sampleCounts));
    checkFlags(known.flags,
               AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                   AGAA_DEVICE_DYNAMIC_RENDERING | AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_NV_MIXED_SAMPLES |
                   AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8 | AGAA_DEVICE_NO_ALIASING | AGAA_DEVICE_SOFTWARE |
                   AGAA_DEVICE_GEOMETRY_SHADERS | AGAA_DEVICE_CONDITIONAL_RENDERING | AGAA_DEVICE_FRAGMENT_INTERLOCK |
                   AGAA_DEVICE_FRAMEBUFFER_FETCH | AGAA_DEVICE_SAMPLE_LOCATIONS | AGAA_DEVICE_NV_MULTICAST,
               "AgaaDeviceCaps::flags");
    return known;
}

std::vector<const char*> namesOf(uint32_t kind) {
    switch (kind) {
    case AGAA_NAMES_TECHNIQUES: {
        std::vector<const char*> names;
        for (const Technique* technique : techniques())
            names.push_back(technique->name);
        return names;
    }
    case AGAA_NAMES_TIERS:
        return tierNames();
    case AGAA_NAMES_STAGES:
        return stageNames();
    case AGAA_NAMES_LAYOUTS:
        return layoutNames();
    case AGAA_NAMES_PRESETS:
        return presetNames();
    }
    fail(AGAA_ERROR_INVALID_ARGUMENT, format("%u is not an AgaaNameKind.", kind));
}

// Writes text by the two-call convention.
AgaaResult writeText(const std::string& source, size_t* size, char* text) {
    require(size, AGAA_ERROR_INVALID_ARGUMENT, "the size pointer is null.");
    if (text) {
        require(*size > source.size(), AGAA_ERROR_BUFFER_TOO_SMALL, "the text buffer is too small.");
        std::memcpy(text, source.c_str(), source.size() + 1);
    }
    *size = source.size() + 1;
    return AGAA_OK;
}

} // namespace

extern "C" {

uint32_t AGAA_CALL agaaGetVersion(void) { return AGAA_HEADER_VERSION; }

const char* AGAA_CALL agaaTierName(uint32_t tier) { return tierName(tier); }

const char* AGAA_CALL agaaStageName(uint32_t stage) { return stageName(stage); }

AgaaResult AGAA_CALL agaaTierFromName(const char* name, uint32_t* outTier) {
    return name && outTier && tierFromName(name, *outTier) ? AGAA_OK : AGAA_ERROR_INVALID_ARGUMENT;
}

AgaaResult AGAA_CALL agaaGetNames(uint32_t kind, uint32_t* count, const char** names) {
    return guarded(Log(), "agaaGetNames", [&] { return writeArray(namesOf(kind), count, names); });
}

AgaaResult AGAA_CALL agaaGetJitter(uint64_t index, uint32_t count, float outJitter[2]) {
    return guarded(Log(), "agaaGetJitter", [&]() -> AgaaResult {
        require(outJitter, AGAA_ERROR_INVALID_ARGUMENT, "outJitter is null.");
        checkRange(uint64_t(count), 1, 1024, "count");
        const std::array<float, 2> jitter = jitterOf(index % count, count);
        std::ranges::copy(jitter, outJitter);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGetBuiltinLayout(const char* name, AgaaLayout* outLayout) {
    return guarded(Log(), "agaaGetBuiltinLayout", [&]() -> AgaaResult {
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkOutput(outLayout);
        writeStruct(outLayout, builtinLayout(name));
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaApplyPreset(const char* name, AgaaConfig* config, AgaaAggregation* aggregation,
                                     AgaaMeasurement* measurement) {
    return guarded(Log(), "agaaApplyPreset", [&]() -> AgaaResult {
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkOutput(config, configChain(techniques()));
        checkOutput(aggregation, configChain(techniques()));
        if (measurement)
            checkOutput(measurement, configChain(techniques()));
        applyPreset(name, *config, *aggregation, measurement);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaQueryCapabilities(const AgaaDeviceCaps* caps, uint32_t* count, AgaaCapability* capabilities) {
    return guarded(Log(), "agaaQueryCapabilities", [&] {
        return writeStructs(listCapabilities(techniques(), capsOrIdeal(caps)), count, capabilities);
    });
}

AgaaResult AGAA_CALL agaaQueryMemory(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                     AgaaMemoryReport* outReport, uint32_t* surfaceCount, AgaaSurface* surfaces) {
    return guarded(log, "agaaQueryMemory", [&]() -> AgaaResult {
        require(surfaceCount || !surfaces, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
        const Plan plan = makePlan(resolveView(view, techniques()), capsOrIdeal(caps), 2);
        AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
        if (outReport) {
            checkOutput(outReport);
            report.totalBytes = plan.totalBytes();
            report.constantBytes = plan.constantBytes();
            report.peakBytes = plan.peakBytes();
            report.bytesPerPixel = plan.bytesPerPixel();
            report.bytesPerAggregate = plan.bytesPerAggregate;
        }
        // Nothing fails after the first output is written.
        if (surfaceCount) {
            std::vector<AgaaSurface> list;
            for (ResourceId id = 0; id < plan.resources.size(); ++id)
                if (!plan.resources[id].isImported())
                    list.push_back(describeSurface(plan, id));
            writeStructs(list, surfaceCount, surfaces);
        }
        if (outReport)
            writeStruct(outReport, report);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaQueryTarget(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                     AgaaTarget* outTarget) {
    return guarded(log, "agaaQueryTarget", [&]() -> AgaaResult {
        const ViewSettings settings = resolveView(view, techniques());
        checkOutput(outTarget);
        const Plan plan = makePlan(settings, capsOrIdeal(caps), 2); // throws for targets larger than maxImageSize
        AgaaTarget target = AGAA_TARGET_INIT;
        target.width = plan.view.width * plan.view.scaleX;
        target.height = plan.view.height * plan.view.scaleY * plan.view.layers;
        target.samples = plan.view.hwSamples;
        target.scaleX = plan.view.scaleX;
        target.scaleY = plan.view.scaleY;
        target.geometryPasses = plan.geometryPasses();
        target.layers = plan.view.layers;
        writeStruct(outTarget, target);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaQueryPrices(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                     uint32_t* count, AgaaPrice* prices) {
    return guarded(log, "agaaQueryPrices", [&]() -> AgaaResult {
        require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
        return writeStructs(listPrices(resolveView(view, techniques()), capsOrIdeal(caps), 2), count, prices);
    });
}

AgaaResult AGAA_CALL agaaObserve(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                 const AgaaFrameStatistics* statistics, AgaaObservation* outObservation) {
    return guarded(log, "agaaObserve", [&]() -> AgaaResult {
        const ViewSettings settings = resolveView(view, techniques());
        const Plan plan = makePlan(settings, capsOrIdeal(caps), 2);
        const AgaaObservation previous = readStruct(outObservation);
        writeStruct(outObservation, observe(observedSettings(settings, plan), readStruct(statistics), previous));
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaChooseSettings(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                        const AgaaGoal* goal, const AgaaObservation* observation,
                                        const AgaaChoice* current, AgaaChoice* outChoice) {
    return guarded(log, "agaaChooseSettings", [&]() -> AgaaResult {
        const ViewSettings settings = resolveView(view, techniques());
        const AgaaDeviceCaps device = capsOrIdeal(caps);
        const AgaaGoal known = readStruct(goal);
        const AgaaObservation seen = observation ? readStruct(observation) : AgaaObservation AGAA_OBSERVATION_INIT;
        const AgaaChoice last = current ? readStruct(current) : AgaaChoice AGAA_CHOICE_INIT;
        checkOutput(outChoice);
        writeStruct(outChoice, chooseSettings(tunedView(settings, device), known, seen, last));
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaApplyChoice(const AgaaChoice* choice, AgaaConfig* config, AgaaAggregation* aggregation,
                                     AgaaMeasurement* measurement) {
    return guarded(Log(), "agaaApplyChoice", [&]() -> AgaaResult {
        const AgaaChoice known = readStruct(choice);
        checkOutput(config, configChain(techniques()));
        checkOutput(aggregation, configChain(techniques()));
        if (measurement)
            checkOutput(measurement, configChain(techniques()));
        applyChoice(known, *config, *aggregation, measurement);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaPlanToJson(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                    size_t* size, char* text) {
    return guarded(log, "agaaPlanToJson", [&]() -> AgaaResult {
        return writeText(planToJson(makePlan(resolveView(view, techniques()), capsOrIdeal(caps), 2)), size, text);
    });
}

AgaaResult AGAA_CALL agaaGetAggregateGlsl(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                          size_t* size, char* text) {
    return guarded(log, "agaaGetAggregateGlsl", [&]() -> AgaaResult {
        return writeText(aggregateGlsl(makePlan(resolveView(view, techniques()), capsOrIdeal(caps), 2)), size, text);
    });
}

AgaaResult AGAA_CALL agaaGetCoverageGlsl(const AgaaLog* log, size_t* size, char* text) {
    return guarded(log, "agaaGetCoverageGlsl", [&]() -> AgaaResult { return writeText(coverageGlsl(), size, text); });
}

AgaaResult AGAA_CALL agaaGetDrawPasses(AgaaView view, uint32_t* count, AgaaDrawPass* passes) {
    return guarded(logOf(view), "agaaGetDrawPasses", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        return writeDrawPasses(*view->current, count, passes);
    });
}

AgaaResult AGAA_CALL agaaGetGlslResources(AgaaView view, uint32_t pass, uint32_t* count, AgaaGlslResource* resources) {
    return guarded(logOf(view), "agaaGetGlslResources", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        return writeGlslResources(*view->current, pass, count, resources);
    });
}

AgaaResult AGAA_CALL agaaGetSurface(AgaaView view, const char* name, AgaaSurface* outSurface) {
    return guarded(logOf(view), "agaaGetSurface", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkOutput(outSurface, {view->current->surfaceRow().sType});
        void* native = nativePart(outSurface, view->current->surfaceRow());
        const ResourceId id = view->current->plan.surface(name);
        const AgaaSurface surface = describeSurface(view->current->plan, id);
        if (native)
            view->current->describeSurface(id, native);
        writeStruct(outSurface, surface);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaResizeView(AgaaView view, uint32_t width, uint32_t height) {
    return guarded(logOf(view), "agaaResizeView", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        resizeView(*view, width, height);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaPrepareVariants(AgaaView view, uint32_t count, const AgaaSceneFacts* facts) {
    return guarded(logOf(view), "agaaPrepareVariants", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        prepareVariants(*view, count, facts);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGetFrameStatistics(AgaaView view, uint64_t completedFrame,
                                            AgaaFrameStatistics* outStatistics) {
    return guarded(logOf(view), "agaaGetFrameStatistics", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        AgaaFrameStatistics statistics = readStruct(outStatistics);
        const AgaaResult result = frameStatistics(*view->current, completedFrame, statistics);
        writeStruct(outStatistics, statistics);
        return result;
    });
}

AgaaResult AGAA_CALL agaaGetFactReport(AgaaView view, uint64_t completedFrame, AgaaFactReport* outReport) {
    return guarded(logOf(view), "agaaGetFactReport", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        AgaaFactReport report = readStruct(outReport);
        const AgaaResult result = reportFacts(*view, completedFrame, report);
        writeStruct(outReport, report);
        return result;
    });
}

AgaaResult AGAA_CALL agaaGetBreadcrumbs(AgaaView view, AgaaBreadcrumbs* outBreadcrumbs) {
    return guarded(logOf(view), "agaaGetBreadcrumbs", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        AgaaBreadcrumbs out = readStruct(outBreadcrumbs);
        const AgaaResult result = breadcrumbs(*view->current, out);
        writeStruct(outBreadcrumbs, out);
        return result;
    });
}

AgaaResult AGAA_CALL agaaValidateFrame(AgaaView view, uint64_t completedFrame, AgaaFrameValidation* outValidation) {
    return guarded(logOf(view), "agaaValidateFrame", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        AgaaFrameValidation validation = readStruct(outValidation);
        const AgaaResult result = frameValidation(*view->current, completedFrame, validation);
        writeStruct(outValidation, validation);
        return result;
    });
}

void AGAA_CALL agaaDestroyView(AgaaView view) {
    if (view)
        destroyView(view);
}

AgaaResult AGAA_CALL agaaDestroyContext(AgaaContext context) {
    if (!context)
        return AGAA_OK;
    const Log log = context->log;
    return guarded(log, "agaaDestroyContext", [&]() -> AgaaResult {
        require(context->viewCount == 0, AGAA_ERROR_WRONG_ORDER, "views of the context still exist; it was kept.");
        destroy(HostAllocator(context->allocator), context);
        return AGAA_OK;
    });
}

} // extern "C"
