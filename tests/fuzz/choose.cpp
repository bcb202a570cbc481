// Target choose: sequences of agaaChooseSettings, agaaObserve and agaaApplyChoice with any goals and observations. The
// memory of a choice is what the last call returned, or words that no call returns.
#include "api_inputs.h"

#include <cmath>

namespace fuzz {

namespace {

struct Row {
    const char* technique;
    uint32_t samples, aggregates;
};
constexpr Row rows[] = {{"single", 1, 0}, {"fxaa", 1, 0}, {"ssaa", 4, 0}, {"ssaa", 8, 0},
                        {"agaa", 8, 2},   {"sbaa", 8, 2}, {"agaa", 8, 1}, {"simple_complex", 4, 0}};

float anyNumber(Choices& choices, float highest) {
    return choices.oneIn(60) ? choices.number() : highest * float(choices.below(256)) / 255;
}

AgaaMeasuredSettings anyMeasured(Choices& choices, Memory& memory, bool isTimed) {
    AgaaMeasuredSettings measured = AGAA_MEASURED_SETTINGS_INIT;
    const Row& row = choices.of(rows);
    measured.technique = anyName(choices, memory, {row.technique});
    measured.samples = choices.oneIn(40) ? choices.word() : row.samples;
    measured.aggregates = choices.oneIn(40) ? choices.word() : row.aggregates;
    if (row.aggregates > 0)
        measured.generationTier = choices.oneIn(40) ? choices.word() : uint32_t(AGAA_TIER_GBUFFER);
    measured.errorShare = anyNumber(choices, 1);
    measured.error = anyNumber(choices, 0.01f);
    if (isTimed) {
        measured.pixels = 1 + choices.below(8 << 20);
        measured.geometryMilliseconds = anyNumber(choices, 20);
        measured.shadingMilliseconds = anyNumber(choices, 20);
    }
    return measured;
}

AgaaGoal* anyGoal(Choices& choices, Memory& memory) {
    AgaaGoal goal = AGAA_GOAL_INIT;
    if (choices.oneIn(2))
        goal.maxErrorShare = anyNumber(choices, 1);
    if (choices.oneIn(3))
        goal.maxError = anyNumber(choices, 0.01f);
    if (choices.oneIn(3))
        goal.maxMilliseconds = anyNumber(choices, 30);
    if (choices.oneIn(4))
        goal.maxBytes = choices.oneIn(4) ? choices.bits() : choices.below(UINT64_C(1) << 32);
    goal.sceneShare = anyNumber(choices, 1);
    goal.prefer = uint32_t(choices.below(choices.oneIn(50) ? 4 : 2));
    goal.flags = choices.oneIn(50) ? choices.bits() : choices.below(4);
    if (choices.oneIn(4)) {
        const bool isTimed = choices.oneIn(2);
        std::vector<AgaaMeasuredSettings> list(1 + choices.below(4));
        for (AgaaMeasuredSettings& measured : list)
            measured = anyMeasured(choices, memory, isTimed);
        goal.measured = reinterpret_cast<const AgaaMeasuredSettings*>(
            memory.text({reinterpret_cast<const char*>(list.data()), list.size() * sizeof list[0]}));
        goal.measuredCount = uint32_t(choices.oneIn(50) ? 0 : list.size());
    }
    return memory.copy(goal, 0, 0, 1);
}

AgaaObservation* anyObservation(Choices& choices, Memory& memory) {
    AgaaObservation observation = AGAA_OBSERVATION_INIT;
    const Row& row = choices.of(rows);
    observation.flags = choices.oneIn(50) ? choices.bits() : choices.below(4);
    observation.technique = anyName(choices, memory, {row.technique});
    observation.samples = choices.oneIn(40) ? choices.word() : row.samples;
    observation.aggregates = choices.oneIn(40) ? choices.word() : row.aggregates;
    observation.generationTier = row.aggregates > 0 ? AGAA_TIER_GBUFFER : AGAA_TIER_AUTO;
    observation.pixels = choices.oneIn(20) ? choices.bits() : choices.below(8 << 20);
    observation.coverage = anyNumber(choices, 1);
    observation.eventsPerPixel = anyNumber(choices, 8);
    observation.lightsPerEvent = anyNumber(choices, 64);
    observation.shadowTapsPerEvent = anyNumber(choices, 16);
    observation.geometryMilliseconds = anyNumber(choices, 20);
    observation.shadingMilliseconds = anyNumber(choices, 20);
    return memory.copy(observation, 0, 0, 1);
}

AgaaFrameStatistics* anyStatistics(Choices& choices, Memory& memory) {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    statistics.timeSource = uint32_t(choices.below(3));
    statistics.passCount = choices.oneIn(30) ? choices.word() : uint32_t(choices.below(AGAA_MAX_PASSES + 1));
    for (AgaaPassTime& pass : statistics.passes) {
        pass.stage = uint32_t(choices.below(7));
        pass.isTimed = uint32_t(choices.below(2));
        pass.milliseconds = anyNumber(choices, 20);
    }
    statistics.counters.visible = choices.oneIn(20) ? choices.bits() : choices.below(1 << 24);
    statistics.counters.shadingEvents = choices.oneIn(20) ? choices.bits() : choices.below(1 << 24);
    statistics.counters.lightEvaluations = choices.oneIn(20) ? choices.bits() : choices.below(1 << 28);
    statistics.counters.shadowTaps = choices.oneIn(20) ? choices.bits() : choices.below(1 << 28);
    return memory.copy(statistics, 0, 0, 1);
}

void checkChoice(const AgaaChoice& choice) {
    for (const auto& [name, value] : {std::pair("a share of the error", choice.errorShare),
                                      {"a median share of the error", choice.errorShareMedian},
                                      {"a worst share of the error", choice.errorShareWorst},
                                      {"an error", choice.error},
                                      {"milliseconds", choice.milliseconds}})
        if (!std::isfinite(value) || value < 0)
            report("agaaChooseSettings predicts " + std::string(name) + ": " + std::to_string(value));
    for (const float value : choice.memory)
        if (!std::isfinite(value) || value < 0)
            report("agaaChooseSettings remembers " + std::to_string(value));
    if (!choice.technique || std::memchr(choice.reason, 0, sizeof choice.reason) == nullptr)
        report("agaaChooseSettings returns a choice without a technique or without the end of its reason");
    else
        checkLine("agaaChooseSettings", choice.reason);
}

} // namespace

void runChoose(Choices& choices) {
    ViewInput input(choices);
    AgaaChoice choice = AGAA_CHOICE_INIT;
    AgaaObservation observed = AGAA_OBSERVATION_INIT;
    bool hasChoice = false;
    for (uint64_t calls = 1 + choices.below(4); calls > 0; --calls) {
        Messages messages;
        const AgaaObservation* observation = nullptr;
        if (choices.oneIn(2)) {
            const AgaaObservation before = observed;
            const AgaaResult result =
                agaaObserve(input.view, input.caps, &messages.log, anyStatistics(choices, input.memory), &observed);
            checkResult("agaaObserve", result, messages, std::memcmp(&observed, &before, sizeof before) != 0);
            observation = result == AGAA_OK ? &observed : nullptr;
        } else if (choices.oneIn(2)) {
            observation = anyObservation(choices, input.memory);
        }
        if (choices.oneIn(30)) {
            choice.memory[choices.below(AGAA_CHOICE_MEMORY)] = choices.number();
            choice.technique = anyName(choices, input.memory, {choices.of(rows).technique});
            hasChoice = true;
        }
        Messages chooseMessages;
        const AgaaChoice before = choice;
        const AgaaResult result =
            agaaChooseSettings(input.view, input.caps, &chooseMessages.log, anyGoal(choices, input.memory), observation,
                               hasChoice || choices.oneIn(2) ? &choice : nullptr, &choice);
        checkResult("agaaChooseSettings", result, chooseMessages, std::memcmp(&choice, &before, sizeof choice) != 0);
        if (result != AGAA_OK)
            continue;
        hasChoice = true;
        checkChoice(choice);
        // The view keeps its settings, because its arrays have as many elements as its samples.
        AgaaConfig config = AGAA_CONFIG_INIT;
        AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
        AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
        if (agaaApplyChoice(&choice, &config, &aggregation, &measurement) != AGAA_OK)
            report("agaaApplyChoice refuses a choice of agaaChooseSettings");
    }
}

} // namespace fuzz
