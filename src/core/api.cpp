// The part of the C ABI that needs no graphics API.
#include "core/aggregate_glsl.h"
#include "core/checked.h"
#include "core/glsl_text.h"
#include "core/handles.h"
#include "core/layout.h"
#include "core/names.h"
#include "core/planner.h"
#include "core/presets.h"
#include "core/technique.h"
#include "core/tiers.h"
#include "core/validate.h"

#include <algorithm>
#include <cstring>

using namespace agaa;

namespace {

AgaaDeviceCaps capsOrIdeal(const AgaaDeviceCaps* caps) {
    if (!caps)
        return idealDevice();
    const AgaaDeviceCaps known = checkStruct(caps, AGAA_STRUCTURE_TYPE_DEVICE_CAPS, "AgaaDeviceCaps");
    require(known.reserved == 0, AGAA_ERROR_INVALID_ARGUMENT, "AgaaDeviceCaps::reserved must be 0.");
    return known;
}

AgaaSurface surfaceOf(const Resource& resource) {
    AgaaSurface surface{};
    std::strncpy(surface.name, resource.name.c_str(), sizeof surface.name - 1);
    std::strncpy(surface.format, formatName(resource.format), sizeof surface.format - 1);
    surface.width = resource.width;
    surface.height = resource.height;
    surface.samples = resource.samples;
    surface.layers = resource.layers;
    surface.bytes = checkedMultiply(resource.bytes, resource.copies);
    surface.isPerPixel = resource.isPerPixel();
    surface.firstPass = resource.firstPass;
    surface.lastPass = resource.lastPass;
    return surface;
}

// Two-call convention for text.
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

const char* AGAA_CALL agaaResultString(AgaaResult result) {
    switch (result) {
#define AGAA_RESULT_CASE(name, value, text)                                                        \
    case value:                                                                                    \
        return text;
        AGAA_RESULT_LIST(AGAA_RESULT_CASE)
#undef AGAA_RESULT_CASE
    default:
        return "unknown result";
    }
}

const char* AGAA_CALL agaaResultName(AgaaResult result) {
    switch (result) {
#define AGAA_RESULT_CASE(name, value, text)                                                        \
    case value:                                                                                    \
        return #name;
        AGAA_RESULT_LIST(AGAA_RESULT_CASE)
#undef AGAA_RESULT_CASE
    default:
        return "unknown result";
    }
}

uint32_t AGAA_CALL agaaGetVersion(void) { return AGAA_HEADER_VERSION; }

const char* AGAA_CALL agaaTierName(uint32_t tier) { return tierName(tier); }

const char* AGAA_CALL agaaStageName(uint32_t stage) { return stageName(stage); }

AgaaResult AGAA_CALL agaaTierFromName(const char* name, uint32_t* outTier) {
    return name && outTier && tierFromName(name, *outTier) ? AGAA_OK : AGAA_ERROR_INVALID_ARGUMENT;
}

AgaaResult AGAA_CALL agaaGetBuiltinLayout(const char* name, AgaaLayout* outLayout) {
    return guarded(Log(), "agaaGetBuiltinLayout", [&]() -> AgaaResult {
        require(name && outLayout, AGAA_ERROR_INVALID_ARGUMENT, "a pointer is null.");
        *outLayout = builtinLayout(name);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaApplyPreset(const char* name, AgaaConfig* config, AgaaAggregation* aggregation) {
    return guarded(Log(), "agaaApplyPreset", [&]() -> AgaaResult {
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkHeader(config, AGAA_STRUCTURE_TYPE_CONFIG, sizeof *config, "AgaaConfig", settingsTypes());
        checkHeader(aggregation, AGAA_STRUCTURE_TYPE_AGGREGATION, sizeof *aggregation, "AgaaAggregation", settingsTypes());
        if (!applyPreset(name, *config, *aggregation))
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("no preset is called \"%.64s\".", name));
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaEnumerateTechniques(uint32_t* count, const char** names) {
    return guarded(Log(), "agaaEnumerateTechniques", [&] {
        std::vector<const char*> list;
        for (const Technique* technique : techniques())
            list.push_back(technique->name);
        return writeArray(list, count, names);
    });
}

AgaaResult AGAA_CALL agaaQueryCapabilities(const AgaaDeviceCaps* caps, uint32_t* count,
                                           AgaaCapability* capabilities) {
    return guarded(Log(), "agaaQueryCapabilities", [&] {
        return writeArray(listCapabilities(capsOrIdeal(caps)), count, capabilities);
    });
}

AgaaResult AGAA_CALL agaaQueryMemory(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                     const AgaaLog* log, AgaaMemoryReport* outReport,
                                     uint32_t* surfaceCount, AgaaSurface* surfaces) {
    return guarded(checkedLog(log), "agaaQueryMemory", [&]() -> AgaaResult {
        const Plan plan = makePlan(resolveView(view), capsOrIdeal(caps), 2);
        if (outReport)
            checkStruct(outReport, AGAA_STRUCTURE_TYPE_MEMORY_REPORT, "AgaaMemoryReport");
        if (surfaceCount) {
            std::vector<AgaaSurface> list;
            for (const Resource& resource : plan.resources)
                if (!resource.isHosts())
                    list.push_back(surfaceOf(resource));
            writeArray(list, surfaceCount, surfaces);
        }
        if (outReport) {
            outReport->totalBytes = plan.totalBytes();
            outReport->constantBytes = plan.constantBytes();
            outReport->peakBytes = plan.peakBytes();
            outReport->bytesPerPixel = plan.bytesPerPixel();
            outReport->bytesPerAggregate = plan.bytesPerAggregate;
        }
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaQueryTarget(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                     AgaaTarget* outTarget) {
    return guarded(checkedLog(log), "agaaQueryTarget", [&]() -> AgaaResult {
        const ViewSettings settings = resolveView(view);
        checkStruct(outTarget, AGAA_STRUCTURE_TYPE_TARGET, "AgaaTarget");
        const Plan plan = makePlan(settings, capsOrIdeal(caps), 2);
        const uint64_t width = uint64_t(plan.width) * plan.scaleX, height = uint64_t(plan.height) * plan.scaleY;
        if (std::max(width, height) > capsOrIdeal(caps).maxImageSize)
            fail(AGAA_ERROR_TOO_LARGE, format("the target would be %llux%llu texels; the device allows %u.",
                                              static_cast<unsigned long long>(width),
                                              static_cast<unsigned long long>(height), capsOrIdeal(caps).maxImageSize));
        outTarget->width = uint32_t(width);
        outTarget->height = uint32_t(height);
        outTarget->samples = plan.hwSamples;
        outTarget->scaleX = plan.scaleX;
        outTarget->scaleY = plan.scaleY;
        outTarget->geometryPasses = plan.geometryPasses();
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaPlanToJson(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                    const AgaaLog* log, size_t* size, char* text) {
    return guarded(checkedLog(log), "agaaPlanToJson", [&]() -> AgaaResult {
        return writeText(planToJson(makePlan(resolveView(view), capsOrIdeal(caps), 2)), size, text);
    });
}

AgaaResult AGAA_CALL agaaGetAggregateGlsl(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                          size_t* size, char* text) {
    return guarded(checkedLog(log), "agaaGetAggregateGlsl", [&]() -> AgaaResult {
        return writeText(aggregateGlsl(makePlan(resolveView(view), capsOrIdeal(caps), 2)), size, text);
    });
}

AgaaResult AGAA_CALL agaaGetCoverageGlsl(const AgaaLog* log, size_t* size, char* text) {
    return guarded(checkedLog(log), "agaaGetCoverageGlsl", [&]() -> AgaaResult {
        return writeText(coverageGlsl(), size, text);
    });
}

AgaaResult AGAA_CALL agaaGetFrameStatistics(AgaaView view, uint64_t completedFrame,
                                            AgaaFrameStatistics* outStatistics) {
    return guarded(logOf(view), "agaaGetFrameStatistics", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        checkStruct(outStatistics, AGAA_STRUCTURE_TYPE_FRAME_STATISTICS, "AgaaFrameStatistics");
        return view->statistics(completedFrame, *outStatistics);
    });
}

AgaaResult AGAA_CALL agaaValidateFrame(AgaaView view, uint64_t completedFrame,
                                       AgaaFrameValidation* outValidation) {
    return guarded(logOf(view), "agaaValidateFrame", [&]() -> AgaaResult {
        require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
        checkStruct(outValidation, AGAA_STRUCTURE_TYPE_FRAME_VALIDATION, "AgaaFrameValidation");
        return view->validation(completedFrame, *outValidation);
    });
}

void AGAA_CALL agaaDestroyView(AgaaView view) {
    if (view)
        destroy(HostAllocator(view->owner.allocator), view);
}

void AGAA_CALL agaaDestroyContext(AgaaContext context) {
    if (!context)
        return;
    const Log log = context->log;
    guarded(log, "agaaDestroyContext", [&]() -> AgaaResult {
        require(context->viewCount == 0, AGAA_ERROR_WRONG_ORDER, "views of the context still exist; it was kept.");
        destroy(HostAllocator(context->allocator), context);
        return AGAA_OK;
    });
}

} // extern "C"
