// What handles point to. Backends derive from these; the parts that need no graphics API are here.
#pragma once

#include "core/api_guard.h"
#include "core/frame_sequence.h"
#include "core/gpu_layout.h"
#include "core/plan.h"
#include "core/variants.h"

#include <optional>
#include <type_traits>
#include <vector>

namespace agaa {

struct StructRow;

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
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT; // less what the host did not enable
    uint32_t viewCount = 0;
};

namespace agaa {

// A view at one size.
class SizedView {
public:
    SizedView(AgaaContext_T& context, Plan framePlan);
    virtual ~SizedView();
    SizedView(const SizedView&) = delete;
    SizedView& operator=(const SizedView&) = delete;

    AgaaResult statistics(uint64_t completedFrame, AgaaFrameStatistics& out) const;
    AgaaResult validation(uint64_t completedFrame, AgaaFrameValidation& out) const;
    AgaaResult facts(uint64_t completedFrame, AgaaFactReport& out) const;

    // What hosts chain to AgaaDrawPass and AgaaSurface for what is the graphics API's own.
    virtual const StructRow& drawPassRow() const = 0;
    virtual const StructRow& surfaceRow() const = 0;
    // native: a struct of that row, or null.
    virtual void describePass(size_t pass, AgaaDrawPass& out, void* native) const = 0;
    virtual void describeSurface(ResourceId id, void* native) const = 0;

    // Of the device's frame in this slot, which has finished.
    virtual MemoryUse memoryUse() const = 0;
    virtual CounterBuffer readCounters(uint32_t slot) const = 0;
    // Milliseconds of each pass; empty where they are not measured.
    virtual std::vector<double> readPassTimes(uint32_t slot) const = 0;
    virtual AgaaTimeSource timeSource() const = 0;

    // Of the newest finished frame, where the plan's frame constants hold counters of it and there is one.
    std::optional<CounterBuffer> feedback(const AgaaFrame& frame) const;

    // The same with other settings, in the host's memory.
    virtual SizedView* remade(const ViewSettings& settings) const = 0;

    // Adds a variant. settings: those of the view. facts: within its own.
    virtual void prepare(const ViewSettings& settings, const AgaaSceneFacts& facts);
    // That of the frame, which has its facts: the same in all its segments.
    const Variant& variantOf(const AgaaFrame& frame);

    AgaaContext_T& owner;
    const Plan plan; // of all effects; its variants differ in programs alone
    FrameSequence sequence;
    Variants variants{plan};

protected:
    // A compute pass, which has the bindings of plan.passes[index].
    virtual Compiled compile(const Pass& pass, size_t index) = 0;
    void addVariant(const Plan& variantPlan);
    void recorded(const AgaaFrame& frame); // with its variant

private:
    const Variant* chosen_ = nullptr;    // of the frame that is recorded now
    const Variant* running_ = nullptr;   // of the frame whose segments are recorded
    std::vector<const Variant*> ran_;    // by slot
};

} // namespace agaa

// What a host's handle leads to: views are made anew when they are resized.
struct AgaaView_T {
    AgaaView_T(AgaaContext_T& context, agaa::ViewSettings viewSettings, agaa::SizedView* view)
        : owner(context), settings(std::move(viewSettings)), current(view) {}

    AgaaContext_T& owner;
    agaa::ViewSettings settings; // as the host described them
    agaa::SizedView* current;    // never null
    bool isToldOfFacts = false;  // the log knows of a contradiction
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
    void* memory = object;
    if constexpr (std::is_polymorphic_v<T>)
        memory = dynamic_cast<void*>(object);
    object->~T();
    allocator.free(memory);
}

// Creates a view and its handle. arguments: of T, after the context.
template <class T, class Context, typename... Arguments>
AgaaView createView(Context& context, ViewSettings settings, Arguments&&... arguments) {
    T* view = construct<T>(context.allocator, context, std::forward<Arguments>(arguments)...);
    try {
        return construct<AgaaView_T>(context.allocator, context, std::move(settings), view);
    } catch (...) {
        destroy(context.allocator, static_cast<SizedView*>(view));
        throw;
    }
}
void destroyView(AgaaView view);
// Tells the log of the view's first contradiction.
AgaaResult reportFacts(AgaaView_T& view, uint64_t completedFrame, AgaaFactReport& out);
// Leaves the view as it was where it fails.
void resizeView(AgaaView_T& view, uint32_t width, uint32_t height);
// Compiles variants; elements that are not valid compile nothing.
void prepareVariants(AgaaView_T& view, uint32_t count, const AgaaSceneFacts* facts);

inline Log logOf(AgaaContext context) { return context ? context->log : Log(); }
inline Log logOf(AgaaView view) { return view ? view->owner.log : Log(); }

// Refuses null and handles of another backend.
void requireBackend(AgaaContext context, Backend backend);
void requireBackend(AgaaView view, Backend backend);

} // namespace agaa
