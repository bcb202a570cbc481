// What the backends' parts of the C ABI have in common: their structs name the same things alike.
#pragma once

#include "core/handles.h"
#include "core/validate.h"

namespace agaa {

template <class Desc>
Log logOfDesc(const Desc* desc) {
    return desc && desc->structSize == sizeof *desc ? checkedLog(desc->log) : Log();
}

// name: of the struct, for the log.
template <class Desc>
void checkContextCommons(const Desc& desc, const char* name) {
    checkRange(uint64_t(desc.framesInFlight), 1, 8, format("%s::framesInFlight", name).c_str());
    if (!desc.allocate != !desc.free)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s has only one of allocate and free.", name));
    if (desc.log)
        checkStruct(desc.log, AGAA_STRUCTURE_TYPE_LOG, "AgaaLog");
}

template <class Context, class Desc>
AgaaResult createContext(const char* function, uint32_t headerVersion, const Desc* desc,
                         AgaaContext* outContext, void (*check)(const Desc*)) {
    return guarded(logOfDesc(desc), function, [&]() -> AgaaResult {
        checkHeaderVersion(headerVersion);
        require(outContext, AGAA_ERROR_INVALID_ARGUMENT, "the context pointer is null.");
        check(desc);
        const HostAllocator allocator{desc->allocate, desc->free, desc->allocateUser};
        *outContext = construct<Context>(allocator, *desc);
        return AGAA_OK;
    });
}

inline AgaaResult writeContextCaps(const char* function, AgaaContext context, Backend backend,
                                   AgaaDeviceCaps* outCaps) {
    return guarded(logOf(context), function, [&]() -> AgaaResult {
        requireBackend(context, backend);
        checkStruct(outCaps, AGAA_STRUCTURE_TYPE_DEVICE_CAPS, "AgaaDeviceCaps");
        *outCaps = context->caps;
        return AGAA_OK;
    });
}

// describe(index of the plan's pass, out) fills what is the backend's own.
template <class DrawPass, class Describe>
AgaaResult writeDrawPasses(const Plan& plan, uint32_t* count, DrawPass* passes, uint32_t sType,
                           const char* name, const Describe& describe) {
    require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
    const uint32_t available = plan.geometryPasses();
    if (passes) {
        require(*count >= available, AGAA_ERROR_BUFFER_TOO_SMALL,
                "the array is too small for the draw passes.");
        for (uint32_t i = 0; i < available; ++i)
            checkStruct(&passes[i], sType, name);
        for (size_t i = 0; i < plan.passes.size(); ++i) {
            const Pass& pass = plan.passes[i];
            if (pass.kind != PassKind::HostDraw)
                continue;
            DrawPass& out = *passes++;
            out.pass = pass.drawPass;
            out.stage = pass.stage;
            out.name = pass.name.c_str();
            out.width = pass.width;
            out.height = pass.height;
            out.scaleX = plan.scaleX;
            out.scaleY = plan.scaleY;
            out.state = pass.drawState;
            describe(i, out);
        }
    }
    *count = available;
    return AGAA_OK;
}

template <class Surface>
void describeSurface(const Plan& plan, ResourceId id, Surface& out) {
    const Resource& resource = plan.resources[id];
    out.bytes = resource.bytes;
    out.width = resource.width;
    out.height = resource.height;
    out.samples = resource.samples;
    out.scaleX = resource.width / plan.width;
    out.scaleY = resource.height / plan.height;
    out.reserved = 0;
}

} // namespace agaa
