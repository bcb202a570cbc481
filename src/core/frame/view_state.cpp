#include "core/frame/view_state.h"

#include "core/base/error.h"
#include "core/plan/planner.h"
#include "core/view/facts.h"

#include <algorithm>

namespace agaa {

ViewState::ViewState(AgaaContext_T& context, Plan framePlan)
    : owner(context), plan(std::move(framePlan)), sequence(context.framesInFlight), ran_(context.framesInFlight) {
    require(plan.runnable, AGAA_ERROR_UNSUPPORTED,
            "this plan is a model that can be priced but not run.");
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

std::optional<CounterBuffer> ViewState::feedback(const AgaaFrame& frame) const {
    const bool isAsked = std::any_of(plan.feedback.begin(), plan.feedback.end(),
                                     [](uint32_t counter) { return counter != noCounter; });
    const FrameSequence::Slot* newest = isAsked ? sequence.newest(frame.completedFrame) : nullptr;
    if (!newest)
        return std::nullopt;
    return readCounters(sequence.indexOf(*newest));
}

} // namespace agaa
