// A view at one size: its plan, the frames recorded of it and its variants. Backends derive from it.
#pragma once

#include "core/frame/context.h"
#include "core/frame/frame_sequence.h"
#include "core/frame/variants.h"
#include "core/plan/gpu_layout.h"
#include "core/plan/plan.h"

#include <optional>
#include <vector>

namespace agaa {

struct StructRow;

// Bytes of a view's surfaces as created.
struct MemoryUse {
    uint64_t payload = 0; // per-pixel surfaces
    uint64_t driver = 0;  // what the driver asked for; 0: it does not tell
    uint64_t peak = 0;    // what was allocated
};

// A view at one size.
class ViewState {
public:
    ViewState(AgaaContext_T& context, Plan framePlan);
    virtual ~ViewState();
    ViewState(const ViewState&) = delete;
    ViewState& operator=(const ViewState&) = delete;

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

    // The variant that the frame in this slot ran with.
    const Variant& variantIn(uint32_t slot) const { return *ran_[slot]; }

    // Of the newest finished frame, where the plan's frame constants hold counters of it and there is one.
    std::optional<CounterBuffer> feedback(const AgaaFrame& frame) const;

    // The same with other settings, in the host's memory.
    virtual ViewState* recreate(const ViewSettings& settings) const = 0;

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
