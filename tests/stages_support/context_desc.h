// The description of a context with that of the device chained to it, which stays chained when it is copied.
#pragma once

#include "agaa_sdk.h"

namespace agaa::test {

// Device: AgaaVkDeviceDesc or AgaaGlDeviceDesc.
template <class Device> struct ContextDesc : AgaaContextDesc {
    Device device;

    explicit ContextDesc(const Device& initial) : AgaaContextDesc AGAA_CONTEXT_DESC_INIT, device(initial) {
        pNext = &device;
    }
    ContextDesc(const ContextDesc& other) : AgaaContextDesc(other), device(other.device) { pNext = &device; }
    ContextDesc& operator=(const ContextDesc& other) {
        AgaaContextDesc::operator=(other);
        device = other.device;
        pNext = &device;
        return *this;
    }
};

} // namespace agaa::test
