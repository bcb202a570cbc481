// Helpers that the ABI functions of both backends share.
#pragma once

#include "core/abi/api_guard.h"
#include "core/abi/handles.h"
#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/structs.h"

namespace agaa {

inline Log logOfDesc(const AgaaContextDesc* desc) {
    const bool valid = desc && desc->sType == AGAA_STRUCTURE_TYPE_CONTEXT_DESC &&
                       desc->structSize >= StructOf<AgaaContextDesc>::row.firstSize;
    return valid ? checkedLog(desc->log) : Log();
}

inline AgaaContextDesc readContextDesc(const AgaaContextDesc* pointer, const std::vector<uint32_t>& chain) {
    const AgaaContextDesc desc = readStruct(pointer, chain);
    checkRange(uint64_t(desc.framesInFlight), 1, 8, "AgaaContextDesc::framesInFlight");
    checkReserved(desc.reserved, "AgaaContextDesc::reserved");
    require(!desc.allocate == !desc.free, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaContextDesc has only one of allocate and free.");
    if (desc.log)
        readStruct(desc.log);
    return desc;
}

// Returns the chained description of the device. Throws Error if there is none.
template <class DeviceDesc> DeviceDesc readDeviceDesc(const AgaaContextDesc& desc) {
    const std::optional<DeviceDesc> device = readChained<DeviceDesc>(&desc);
    if (!device)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("no %s is chained to AgaaContextDesc.", StructOf<DeviceDesc>::row.name));
    return *device;
}

inline AgaaResult writeContextCaps(const char* function, AgaaContext context, Backend backend,
                                   AgaaDeviceCaps* outCaps) {
    return guarded(logOf(context), function, [&]() -> AgaaResult {
        requireBackend(context, backend);
        checkOutput(outCaps);
        writeStruct(outCaps, context->caps);
        return AGAA_OK;
    });
}

} // namespace agaa
