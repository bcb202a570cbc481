// Images, times and counters of a session, and the settings that a goal chooses by them.
#include "session_view.h"

#include "cli/planned_view.h"

namespace viewer {

using namespace harness;

OptionSet RenderSession::chosenOptions(const ViewRequest& request) {
    if (!request.goal.isOn)
        return request.a;
    const std::unique_ptr<View> view = prepare(request.a);
    const AgaaFetchFunction fetch = anyFetch(view->arguments.plan.unfetchedEvery == 0, false);
    AgaaViewDesc desc = viewOf(view->configuration, view->settings.facts, fetch, view->settings.reversedZ,
                               view->arguments.device.clipZFromMinusOne);
    desc.pNext = &fetch;
    const AgaaGoal goal = goalOf(request.goal.limits());
    Sdk sdk;
    sdk.check(agaaChooseSettings(&desc, &view->renderer->caps(), sdk.log(), &goal, &observation_, &choice_, &choice_));
    observation_ = AGAA_OBSERVATION_INIT;
    state_.chosen = optionsOf(choice_);
    state_.reason = choice_.reason;
    return withChoice(request.a, state_.chosen);
}

void RenderSession::renderImage(View& view, ViewResult& result) {
    RenderSettings settings = view.settings;
    if (request_->motionFrame) {
        settings.firstFrame = *request_->motionFrame;
        settings.frames = 1;
        settings.warmup = 0;
    }
    result.figures = Figures();
    const RenderResult rendered = view.renderer->render(settings);
    const AgaaFrameStatistics& last = rendered.statistics.back();
    Figures& figures = result.figures;
    figures.frameMs = rendered.frameMs.back();
    figures.memory = rendered.memory;
    figures.plan = rendered.plan;
    figures.payloadBytes = last.payloadBytes;
    figures.driverBytes = last.driverBytes;
    figures.peakBytes = last.peakBytes;
    figures.geometryPasses = last.geometryPasses;
    figures.factReport = rendered.facts ? rendered.facts->explanation : "";
    result.image = std::make_shared<const Image>(shownImage(rendered.image, settings.config));
    result.error.reset();
    areErrorsPending_ = state_.reference != nullptr;
    if (&view == a_.get())
        ++state_.frames;
}

void RenderSession::measure(View& view, ViewResult& result, uint64_t flag, uint32_t warmup) {
    RenderSettings settings = view.settings;
    settings.config.flags |= flag;
    settings.frames = 1;
    settings.warmup = warmup;
    const RenderResult rendered = view.renderer->render(settings);
    const AgaaFrameStatistics& last = rendered.statistics.back();
    if (flag == AGAA_CONFIG_COUNTERS) {
        result.figures.counters = last.counters;
    } else {
        result.figures.passes.clear();
        for (uint32_t i = 0; i < last.passCount; ++i)
            if (last.passes[i].isTimed)
                result.figures.passes.push_back(
                    {last.passes[i].name, agaaStageName(last.passes[i].stage), last.passes[i].milliseconds});
        ++result.figures.timedFrames;
        result.figures.frameMs = rendered.frameMs.back(); // the frame of the image compiled pipelines
    }
    if (&view == a_.get() && request_->goal.isOn)
        observe(last);
}

bool RenderSession::measureNext(View& view, ViewResult& result) {
    Figures& figures = result.figures;
    if (!figures.counters) {
        measure(view, result, AGAA_CONFIG_COUNTERS, 0);
        return true;
    }
    if (figures.timedFrames >= request_->measuredFrames)
        return false;
    measure(view, result, AGAA_CONFIG_TIMESTAMPS, figures.timedFrames == 0 ? 1 : 0); // the first compiles pipelines
    if (&view == a_.get())
        ++state_.frames;
    // Times of frames may change the choice of a goal. The library waits for 16 of them.
    if (&view == a_.get() && request_->goal.isOn && figures.timedFrames % 16 == 0)
        begin(ViewRequest(*request_));
    return true;
}

void RenderSession::observe(const AgaaFrameStatistics& statistics) {
    const AgaaFetchFunction fetch = anyFetch(a_->arguments.plan.unfetchedEvery == 0, false);
    const AgaaViewDesc desc = viewOf(a_->configuration, a_->settings.facts, fetch, a_->settings.reversedZ,
                                     a_->arguments.device.clipZFromMinusOne);
    Sdk sdk;
    sdk.check(agaaObserve(&desc, &a_->renderer->caps(), sdk.log(), &statistics, &observation_));
}

} // namespace viewer
