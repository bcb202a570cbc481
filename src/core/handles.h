// What handles point to. Backends derive from these; the parts that need no graphics API are here.
#pragma once

#include "core/api_guard.h"
#include "core/frame_sequence.h"
#include "core/gpu_layout.h"
#include "core/plan.h"

#include <optional>
#include <vector>

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

// Bytes of a view's surfaces as created.
struct MemoryUse {
    uint64_t payload = 0; // per-pixel surfaces
    uint64_t driver = 0;  // what the driver asked for; 0: it does not tell
    uint64_t peak = 0;    // what was allocated
};

} // namespace agaa

struct AgaaContext_T {
    AgaaContext_T(agaa::Backend kind, const AgaaLog* hostLog, const agaa::HostAllocator& memory,
                  uint32_t frames)
        : backend(kind), log(hostLog), allocator(memory), framesInFlight(frames) {}
    virtual ~AgaaContext_T() = default;
    AgaaContext_T(const AgaaContext_T&) = delete;
    AgaaContext_T& operator=(const AgaaContext_T&) = delete;

    const agaa::Backend backend;
    agaa::Log log;
    agaa::HostAllocator allocator;
    uint32_t framesInFlight;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT; // less what the host did not enable
    uint32_t viewCount = 0;
};

struct AgaaView_T {
    AgaaView_T(AgaaContext_T& context, agaa::Plan framePlan);
    virtual ~AgaaView_T();
    AgaaView_T(const AgaaView_T&) = delete;
    AgaaView_T& operator=(const AgaaView_T&) = delete;

    AgaaResult statistics(uint64_t completedFrame, AgaaFrameStatistics& out) const;
    AgaaResult validation(uint64_t completedFrame, AgaaFrameValidation& out) const;

    // Of the device's frame in this slot, which has finished.
    virtual agaa::MemoryUse memoryUse() const = 0;
    virtual agaa::CounterBuffer readCounters(uint32_t slot) const = 0;
    // Milliseconds of each pass; empty where they are not measured.
    virtual std::vector<double> readPassTimes(uint32_t slot) const = 0;
    virtual AgaaTimeSource timeSource() const = 0;

    // Of the newest finished frame, where the plan's frame constants hold counters of it and there is one.
    std::optional<agaa::CounterBuffer> feedback(const AgaaFrame& frame) const;

    AgaaContext_T& owner;
    const agaa::Plan plan;
    agaa::FrameSequence sequence;
};

namespace agaa {

// Objects behind handles live in the host's memory.
template <typename T, typename... Arguments>
T* construct(const HostAllocator& allocator, Arguments&&... arguments) {
    void* memory = allocator.allocate(sizeof(T), alignof(T));
    try {
        return new (memory) T(std::forward<Arguments>(arguments)...);
    } catch (...) {
        allocator.free(memory);
        throw;
    }
}

template <typename T>
void destroy(const HostAllocator& allocator, T* object) {
    void* memory = dynamic_cast<void*>(object);
    object->~T();
    allocator.free(memory);
}

inline Log logOf(AgaaContext context) { return context ? context->log : Log(); }
inline Log logOf(AgaaView view) { return view ? view->owner.log : Log(); }

// Refuses null and handles of another backend.
void requireBackend(AgaaContext context, Backend backend);
void requireBackend(AgaaView view, Backend backend);

} // namespace agaa
