// choose: settings for a limit of the error, the time or the memory.
#include "cli/commands.h"
#include "cli/measured_file.h"
#include "cli/planned_view.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace harness {

using nlohmann::json;

AgaaGoal goalOf(const ChooseArguments& arguments) {
    AgaaGoal goal = AGAA_GOAL_INIT;
    goal.maxErrorShare = arguments.maxError;
    goal.maxError = arguments.maxMse;
    goal.sceneShare = arguments.sceneShare;
    goal.maxMilliseconds = arguments.maxMs;
    goal.maxBytes = arguments.maxBytes;
    if (arguments.prefer != "time" && arguments.prefer != "error")
        throw BadArgument("--prefer is \"" + arguments.prefer + "\"; it can be time or error.");
    goal.prefer = arguments.prefer == "time" ? AGAA_PREFER_TIME : AGAA_PREFER_ERROR;
    goal.flags = arguments.oneGeometryPass ? AGAA_GOAL_ONE_GEOMETRY_PASS : 0;
    if (arguments.predictOthers)
        goal.flags |= AGAA_GOAL_PREDICT_OTHERS;
    return goal;
}

std::vector<std::string> optionsOf(const AgaaChoice& choice) {
    std::vector<std::string> options;
    const auto add = [&](const char* name, const std::string& value) {
        options.push_back(name);
        options.push_back(value);
    };
    if (choice.preset) {
        add("--preset", choice.preset);
    } else {
        add("--technique", choice.technique);
        if (choice.aggregates)
            add("--aggregates", std::to_string(choice.aggregates));
    }
    add("--samples", std::to_string(choice.samples));
    if (choice.generationTier != AGAA_TIER_AUTO)
        add("--tier", std::string("generation=") + agaaTierName(choice.generationTier));
    return options;
}

namespace {

// Reads times and counts from different frames, because counting makes frames slower.
AgaaObservation observe(Renderer& renderer, RenderSettings settings, AgaaViewDesc view, TechniqueConfig& config) {
    AgaaObservation observation = AGAA_OBSERVATION_INIT;
    Sdk sdk;
    settings.warmup = 1;
    settings.frames = 3;
    for (const uint64_t flag : {AGAA_CONFIG_COUNTERS, AGAA_CONFIG_TIMESTAMPS}) {
        settings.config.flags = config.flags = flag;
        for (const AgaaFrameStatistics& frame : renderer.render(settings).statistics)
            sdk.check(agaaObserve(&view, &renderer.caps(), sdk.log(), &frame, &observation));
    }
    config.flags = 0;
    return observation;
}

json limitsJson(uint32_t missed) {
    json names = json::array();
    for (const auto& [bit, name] : {std::pair{AGAA_LIMIT_ERROR_SHARE, "max-error"},
                                    {AGAA_LIMIT_ERROR, "max-mse"},
                                    {AGAA_LIMIT_MILLISECONDS, "max-ms"},
                                    {AGAA_LIMIT_BYTES, "max-bytes"}})
        if (missed & bit)
            names.push_back(name);
    return names;
}

json observationJson(const AgaaObservation& o) {
    return {{"technique", o.technique},
            {"coverage", o.coverage},
            {"eventsPerPixel", o.eventsPerPixel},
            {"lightsPerEvent", o.lightsPerEvent},
            {"shadowTapsPerEvent", o.shadowTapsPerEvent},
            {"geometryMs", o.geometryMilliseconds},
            {"shadingMs", o.shadingMilliseconds}};
}

json choiceJson(const AgaaChoice& choice) {
    return {{"technique", choice.technique},
            {"preset", choice.preset ? json(choice.preset) : json()},
            {"samples", choice.samples},
            {"aggregates", choice.aggregates},
            {"tier", choice.generationTier ? json(agaaTierName(choice.generationTier)) : json()},
            {"options", optionsOf(choice)},
            {"errorShare", choice.errorShare},
            {"errorShareMedian", choice.errorShareMedian},
            {"errorShareWorst", choice.errorShareWorst},
            {"error", choice.error},
            {"milliseconds", choice.milliseconds},
            {"hasTimes", choice.hasTimes != 0},
            {"bytes", choice.bytes},
            {"missedLimits", limitsJson(choice.missedLimits)},
            {"leftOut", choice.leftOut},
            {"reason", choice.reason}};
}

} // namespace

void runChoose(const RenderArguments& arguments, const ChooseArguments& chosen, bool sceneGiven, bool asJson) {
    Configuration configuration(arguments.plan);
    AgaaGoal goal = goalOf(chosen);
    std::optional<MeasuredFile> measured;
    if (!chosen.measured.empty()) {
        measured.emplace(chosen.measured);
        goal.measured = measured->settings().data();
        goal.measuredCount = uint32_t(measured->settings().size());
    }
    if (chosen.predictOthers && chosen.measured.empty())
        throw BadArgument("--predict-others needs --measured: it predicts from measured errors.");
    if (chosen.observe && !sceneGiven)
        throw BadArgument("--observe needs a --scene.");
    RenderArguments rendered = arguments;
    if (chosen.observe && rendered.device.backend.empty())
        rendered.device.backend = "vk";
    AgaaSceneFacts facts = plannedFacts(arguments, sceneGiven);
    const AgaaFetchFunction fetch = anyFetch(arguments.plan.unfetchedEvery == 0, false);
    std::optional<AgaaDeviceCaps> caps;
    AgaaObservation observation = AGAA_OBSERVATION_INIT;
    if (chosen.observe) {
        const Scene scene = loadSceneArgument(arguments.scene);
        const RenderSettings settings = renderSettings(rendered, configuration, scene);
        facts = settings.facts;
        const auto renderer = makeRenderer(rendered.device);
        renderer->load(scene);
        caps = renderer->caps();
        const AgaaViewDesc observed =
            viewOf(configuration, facts, fetch, arguments.plan.reversedZ, arguments.device.clipZFromMinusOne);
        observation = observe(*renderer, settings, observed, configuration.config);
    } else {
        caps = planningDevice(configuration, arguments.device);
    }
    AgaaViewDesc view =
        viewOf(configuration, facts, fetch, arguments.plan.reversedZ, arguments.device.clipZFromMinusOne);
    view.pNext = chosen.noFetch ? nullptr : &fetch;
    AgaaChoice choice = AGAA_CHOICE_INIT;
    Sdk sdk;
    sdk.check(agaaChooseSettings(&view, caps ? &*caps : nullptr, sdk.log(), &goal, &observation, nullptr, &choice));
    json out = choiceJson(choice);
    if (chosen.observe)
        out["observation"] = observationJson(observation);
    if (asJson)
        std::cout << out.dump(2) << '\n';
    else
        std::printf("%s\n", choice.reason);
}

} // namespace harness
