#include "core/frame/view_state.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "core/frame/frame_data.h"
#include "core/plan/planner.h"
#include "core/view/facts.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>
#include <cstring>

namespace agaa {

ViewState::ViewState(AgaaContext_T& context, Plan framePlan)
    : owner(context), plan(std::move(framePlan)), steps(plan.steps()), sequence(context.framesInFlight),
      ran_(context.framesInFlight) {
    require(plan.runnable, AGAA_ERROR_UNSUPPORTED, "this plan is a model that can be priced but not run.");
    ++owner.viewCount;
}

ViewState::~ViewState() { --owner.viewCount; }

void ViewState::addVariant(const Plan& variantPlan) {
    variants.add(variantPlan, [this](const Pass& pass, size_t index) { return compile(pass, index); });
}

void ViewState::prepare(const ViewSettings& settings, const AgaaSceneFacts& facts) {
    ViewSettings fewer = settings;
    fewer.variantFacts = computeFactsOf(facts, settings.facts);
    addVariant(makePlan(fewer, owner.caps, owner.framesInFlight));
}

const Variant& ViewState::variantOf(const AgaaFrame& frame) {
    chosen_ = sequence.begins(frame) ? &variants.smallest(computeFactsOf(*frame.facts, plan.view.facts)) : running_;
    return *chosen_;
}

void ViewState::recorded(const AgaaFrame& frame) {
    sequence.recorded(frame);
    running_ = chosen_;
    ran_[sequence.slotOf(frame)] = running_;
}

CounterBuffer ViewState::readCounters(uint32_t slot) const {
    CounterBuffer counters{};
    if (plan.view.hasCounters())
        readBuffer(plan.stamps, slot, 0, std::as_writable_bytes(std::span(&counters, 1)));
    return counters;
}

BreadcrumbBuffer ViewState::readBreadcrumbs() const {
    BreadcrumbBuffer breadcrumbs{};
    std::memcpy(&breadcrumbs, mappedBreadcrumbs(), sizeof breadcrumbs);
    return breadcrumbs;
}

bool ViewState::wasExecuted(const FrameSequence::Slot& slot) const {
    if (plan.stamps == noResource)
        return true;
    uint32_t stamp = 0;
    readBuffer(plan.stamps, sequence.indexOf(slot), plan.stampOffset, std::as_writable_bytes(std::span(&stamp, 1)));
    return stamp == stampOf(slot.frame);
}

const FrameSequence::Slot* ViewState::finished(uint64_t completedFrame) const {
    const FrameSequence::Slot* newest = sequence.newest(completedFrame);
    if (!newest)
        return nullptr;
    requireDevice();
    return wasExecuted(*newest) ? newest : nullptr;
}

void ViewState::checkFrame(AgaaFrame& frame, AgaaSceneFacts& facts) const {
    facts = factsOf(frame, plan);
    frame.facts = &facts;
    agaa::checkFrame(frame, plan);
    const FrameExtent extent = extentOf(frame, plan);
    frame.width = extent.width;
    frame.height = extent.height;
    const uint32_t most = owner.caps.maxImageSize; // of the output
    checkRange(uint64_t(frame.outputX) + frame.width, 1, most, "AgaaFrame::outputX + width");
    checkRange(uint64_t(frame.outputY) + frame.height, 1, most, "AgaaFrame::outputY + height");
    sequence.check(frame);
}

void ViewState::reportLostFragments(const AgaaFrame& frame) {
    if (plan.listCounts == noResource || hasReportedLost_ || !sequence.begins(frame))
        return;
    const FrameSequence::Slot* newest = sequence.newest(frame.completedFrame);
    if (!newest || !wasExecuted(*newest))
        return;
    uint32_t lost = 0;
    readBuffer(plan.listCounts, sequence.indexOf(*newest), 4 * AGAA_LIST_LOST,
               std::as_writable_bytes(std::span(&lost, 1)));
    if (lost == 0)
        return;
    hasReportedLost_ = true;
    owner.log.write(
        AGAA_SEVERITY_WARNING, AGAA_OK,
        format("frame %llu lost %u fragments, because lists with room for %llu and %u draws of the scene do "
               "not suffice; raise AgaaDecoupledCoverage::fragmentsPerPixel or maxBatches.",
               static_cast<unsigned long long>(newest->frame), lost,
               static_cast<unsigned long long>(plan.fragmentCapacity), plan.view.coverage.maxBatches));
}

void ViewState::uploadFrame(const AgaaFrame& frame, uint32_t slot) {
    reportLostFragments(frame);
    const std::optional<CounterBuffer> newest = feedback(frame);
    for (ResourceId id = 0; id < plan.resources.size(); ++id) {
        const Resource& resource = plan.resources[id];
        if (resource.content == UploadContent::None || !(resource.segments & frame.segments))
            continue;
        const uint64_t bytes = writeUpload(plan, resource.content, frame, positions, newest ? &*newest : nullptr,
                                           sequence.turnOf(frame), beginUpload(id, slot));
        endUpload(id, slot, bytes);
    }
}

std::optional<CounterBuffer> ViewState::feedback(const AgaaFrame& frame) const {
    const bool isAsked =
        std::any_of(plan.feedback.begin(), plan.feedback.end(), [](uint32_t counter) { return counter != noCounter; });
    const FrameSequence::Slot* newest = isAsked ? sequence.newest(frame.completedFrame) : nullptr;
    if (!newest || !wasExecuted(*newest))
        return std::nullopt;
    return readCounters(sequence.indexOf(*newest));
}

} // namespace agaa
