// A view at one size: its plan, the frames recorded of it and its variants. Backends derive from it.
#pragma once

#include "core/frame/context.h"
#include "core/frame/frame_sequence.h"
#include "core/frame/host_pass.h"
#include "core/frame/variants.h"
#include "core/plan/gpu_layout.h"
#include "core/plan/plan.h"
#include "core/plan/sample_patterns.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace agaa {

struct StructRow;

// The memory of a view's surfaces as created, in bytes.
struct MemoryUse {
    uint64_t payload = 0; // per-pixel surfaces
    uint64_t driver = 0;  // required by the driver; 0: unknown
    uint64_t peak = 0;    // allocated
};

// A view at one size. It is replaced when the view is resized.
class ViewState {
public:
    ViewState(AgaaContext_T& context, Plan framePlan);
    virtual ~ViewState();
    ViewState(const ViewState&) = delete;
    ViewState& operator=(const ViewState&) = delete;

    // Return the rows of the structs of the graphics API that hosts chain to AgaaDrawPass and AgaaSurface.
    virtual const StructRow& drawPassRow() const = 0;
    virtual const StructRow& surfaceRow() const = 0;
    // native: a struct of that row. describePass() is called for host passes only.
    virtual void describePass(size_t pass, void* native) const = 0;
    virtual void describeSurface(ResourceId id, void* native) const = 0;

    virtual MemoryUse memoryUse() const = 0;
    // Throws Error if the device is known to be lost.
    virtual void requireDevice() const {}
    // Returns the newest completely recorded frame up to completedFrame, or null if there is none, or if the device
    // did not execute it because the host discarded its commands.
    const FrameSequence::Slot* finished(uint64_t completedFrame) const;
    // Returns the counters of the frame in this slot, which must have finished; 0 if the plan has no counters.
    CounterBuffer readCounters(uint32_t slot) const;
    // Returns the passes that the device reached last, also if it is lost. The plan must have breadcrumbs.
    BreadcrumbBuffer readBreadcrumbs() const;
    // Returns the milliseconds of each pass of the frame in this slot; empty if they are not measured.
    virtual std::vector<double> readPassTimes(uint32_t slot) const = 0;
    virtual AgaaTimeSource timeSource() const = 0;

    // Returns the variant that the frame in this slot used.
    const Variant& variantIn(uint32_t slot) const { return *ran_[slot]; }

    // Returns the counters of the newest frame, or nothing if it was discarded or the plan does not read them.
    std::optional<CounterBuffer> feedback(const AgaaFrame& frame) const;

    // Creates the state for other settings, in the host's memory.
    virtual ViewState* recreate(const ViewSettings& settings) const = 0;

    // Adds a variant. settings: the view's. facts: within the facts of the view.
    virtual void prepare(const ViewSettings& settings, const AgaaSceneFacts& facts);
    // Returns the variant of this frame, which is the same for all its segments. frame.facts must be set.
    const Variant& variantOf(const AgaaFrame& frame);

    AgaaContext_T& owner;
    const Plan plan; // with all effects; variants differ in the programs of compute passes only
    const std::vector<Step> steps;
    FrameSequence sequence;
    Variants variants{plan};
    SamplePositions positions{};      // set by the backend's constructor
    std::vector<HostPass> hostPasses; // by pass; set by the backend's constructor

protected:
    // Compiles a compute pass, which has the bindings of plan.passes[index].
    virtual Compiled compile(const Pass& pass, size_t index) = 0;
    // Returns memory for the contents of an upload buffer, until endUpload(). The memory may be write-combined: the
    // caller writes each byte at most once and reads none.
    virtual std::byte* beginUpload(ResourceId buffer, uint32_t slot) = 0;
    // Ends the upload of this buffer. bytes: the number of bytes that were written, from the beginning.
    virtual void endUpload(ResourceId buffer, uint32_t slot, uint64_t bytes) = 0;
    // Returns the memory of Plan::breadcrumbs, which the device may be writing.
    virtual const std::byte* mappedBreadcrumbs() const = 0;
    // Copies the bytes from offset on out of a buffer that the CPU can read.
    virtual void readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const = 0;

    // Checks the frame against the view and against the frames before it. Sets frame.facts to `facts`, which receives
    // the frame's own facts or those of the view.
    void checkFrame(AgaaFrame& frame, AgaaSceneFacts& facts) const;
    // Writes the upload buffers that the frame's segments read.
    void uploadFrame(const AgaaFrame& frame, uint32_t slot);
    // Logs a warning, once, if the newest finished frame lost fragments.
    void reportLostFragments(const AgaaFrame& frame);

    // Returns whether the device executed the frame of the slot, which must have finished. Plans without stamps cannot
    // tell: the result is true.
    bool wasExecuted(const FrameSequence::Slot& slot) const;

    void addVariant(const Plan& variantPlan);
    void recorded(const AgaaFrame& frame); // remembers its variant

private:
    const Variant* chosen_ = nullptr;  // of the frame that is being recorded
    const Variant* running_ = nullptr; // of the frame that was recorded last
    std::vector<const Variant*> ran_;  // by slot
    bool hasReportedLost_ = false;
};

} // namespace agaa
