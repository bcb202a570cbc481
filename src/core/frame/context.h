// The part of a context that needs no graphics API.
#pragma once

#include "agaa_sdk.h"
#include "core/base/log.h"

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace agaa {

enum class Backend { Vulkan, OpenGL };

// Host memory for the objects behind handles.
struct HostAllocator {
    AgaaAllocateCallback allocateCallback = nullptr;
    AgaaFreeCallback freeCallback = nullptr;
    void* user = nullptr;

    void* allocate(size_t size, size_t alignment) const;
    void free(void* memory) const;
};

} // namespace agaa

struct AgaaContext_T {
    AgaaContext_T(agaa::Backend kind, const AgaaContextDesc& desc)
        : backend(kind), log(desc.log), allocator{desc.allocate, desc.free, desc.allocateUser},
          framesInFlight(desc.framesInFlight) {}
    virtual ~AgaaContext_T() = default;
    AgaaContext_T(const AgaaContext_T&) = delete;
    AgaaContext_T& operator=(const AgaaContext_T&) = delete;

    const agaa::Backend backend;
    agaa::Log log;
    agaa::HostAllocator allocator;
    uint32_t framesInFlight;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT; // without features that the host did not enable
    uint32_t viewCount = 0;
};

namespace agaa {

// Create and destroy the objects behind handles, in the host's memory.
template <typename T, typename... Arguments> T* construct(const HostAllocator& allocator, Arguments&&... arguments) {
    void* memory = allocator.allocate(sizeof(T), alignof(T));
    try {
        return new (memory) T(std::forward<Arguments>(arguments)...);
    } catch (...) {
        allocator.free(memory);
        throw;
    }
}

template <typename T> void destroy(const HostAllocator& allocator, T* object) {
    void* memory = object;
    if constexpr (std::is_polymorphic_v<T>)
        memory = dynamic_cast<void*>(object);
    object->~T();
    allocator.free(memory);
}

} // namespace agaa
