// agaaObserve, agaaChooseSettings and agaaApplyChoice: results and errors.
#include "cases.h"
#include "goal_parts.h"
#include "structs.h"
#include "wrong_views.h"

#include <cstring>
#include <limits>

namespace agaa::conformance {

GoalParts::GoalParts(const Functions& sdk) : ViewParts(sdk, nullptr) {
    sdk.agaaInitGoal(&goal, sizeof goal);
    for (AgaaMeasuredSettings& settings : measured)
        sdk.agaaInitMeasuredSettings(&settings, sizeof settings);
    sdk.agaaInitObservation(&observation, sizeof observation);
    sdk.agaaInitChoice(&current, sizeof current);
    sdk.agaaInitChoice(&choice, sizeof choice);
    sdk.agaaInitFrameStatistics(&statistics, sizeof statistics);
    setTechnique("ssaa", 8);
    goal.maxErrorShare = 0.25f;
    observation.technique = current.technique = "ssaa";
    observation.samples = current.samples = 8;
    observation.pixels = uint64_t(desc.width) * desc.height;
    measured[0].technique = "single";
    measured[1].technique = "ssaa";
    for (const uint32_t i : {0u, 1u}) {
        measured[i].samples = 1 + 7 * i;
        measured[i].pixels = observation.pixels;
        measured[i].errorShare = i == 0 ? 1.0f : 0.125f;
        measured[i].error = 0.001f * measured[i].errorShare;
        measured[i].geometryMilliseconds = 1;
        measured[i].shadingMilliseconds = float(measured[i].samples);
    }
}

namespace {

bool isSameChoice(const AgaaChoice& a, const AgaaChoice& b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool isSameObservation(const AgaaObservation& a, const AgaaObservation& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// ---- agaaObserve ---------------------------------------------------------------------------------

void testObserveNulls(Test& test) {
    GoalParts ideal(test.sdk), without(test.sdk);
    test.requireOk(ideal.observe(test, nullptr), "agaaObserve with log = null");
    test.requireOk(test.sdk.agaaObserve(without.get(), nullptr, nullptr, &without.statistics, &without.observation),
                   "agaaObserve with caps = null");
    test.check(isSameObservation(ideal.observation, without.observation),
               "agaaObserve differs for caps = null and an ideal device.");
    without.desc.width = 0;
    test.result(without.observe(test, nullptr), AGAA_ERROR_OUT_OF_RANGE,
                "agaaObserve with log = null and AgaaViewDesc::width = 0");
}

struct WrongStatistics {
    const char* what;
    AgaaResult expected;
    void (*corrupt)(GoalParts&);
};

void timeOne(GoalParts& parts, double milliseconds) {
    parts.statistics.passCount = 1;
    parts.statistics.passes[0].isTimed = 1;
    parts.statistics.passes[0].milliseconds = milliseconds;
}

const WrongStatistics wrongStatistics[] = {
    {"AgaaFrameStatistics::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.statistics.sType = 0; }},
    {"AgaaFrameStatistics::structSize = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.statistics.structSize = 0; }},
    {"AgaaObservation::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.observation.sType = 0; }},
    {"too many passes", AGAA_ERROR_OUT_OF_RANGE, [](GoalParts& p) { p.statistics.passCount = AGAA_MAX_PASSES + 1; }},
    {"a negative time", AGAA_ERROR_OUT_OF_RANGE, [](GoalParts& p) { timeOne(p, -0.001); }},
    {"an infinite time", AGAA_ERROR_OUT_OF_RANGE,
     [](GoalParts& p) { timeOne(p, std::numeric_limits<double>::infinity()); }},
    {"a time that is not a number", AGAA_ERROR_OUT_OF_RANGE,
     [](GoalParts& p) { timeOne(p, std::numeric_limits<double>::quiet_NaN()); }},
};

// Runs the rows of an error; AGAA_OK selects all rows.
void testWrongStatistics(Test& test, AgaaResult error) {
    for (const WrongStatistics& row : wrongStatistics) {
        if (error != AGAA_OK && row.expected != error)
            continue;
        GoalParts parts(test.sdk);
        row.corrupt(parts);
        const AgaaObservation before = parts.observation;
        LogRecorder log;
        expectRefused(test, parts.observe(test, log.get()), row.expected, log, "agaaObserve",
                      callWith("agaaObserve", row.what));
        test.check(isSameObservation(before, parts.observation), callWith("agaaObserve", row.what) + " writes.");
    }
}

void testObserveInvalid(Test& test) {
    GoalParts parts(test.sdk);
    LogRecorder log;
    expectRefused(test, test.sdk.agaaObserve(parts.get(), nullptr, log.get(), nullptr, &parts.observation),
                  AGAA_ERROR_INVALID_ARGUMENT, log, "agaaObserve", "agaaObserve with statistics = null");
    expectRefused(test, test.sdk.agaaObserve(parts.get(), nullptr, log.get(), &parts.statistics, nullptr),
                  AGAA_ERROR_INVALID_ARGUMENT, log, "agaaObserve", "agaaObserve with outObservation = null");
}

// Counts and times that the statistics lack keep their values if the settings are the same.
void testMerged(Test& test) {
    GoalParts parts(test.sdk);
    timeOne(parts, 3);
    parts.statistics.passes[0].stage = AGAA_STAGE_GENERATION;
    test.requireOk(parts.observe(test, nullptr), "agaaObserve of times");
    test.check(parts.observation.flags == AGAA_OBSERVED_TIMES && parts.observation.geometryMilliseconds == 3,
               "agaaObserve does not observe the time of a geometry pass.");
    parts.statistics.passCount = 0;
    const uint64_t samples = 8 * parts.observation.pixels;
    parts.statistics.counters.visible = parts.statistics.counters.shadingEvents = samples / 2;
    test.requireOk(parts.observe(test, nullptr), "agaaObserve of counts");
    test.check(parts.observation.flags == (AGAA_OBSERVED_TIMES | AGAA_OBSERVED_COUNTS) &&
                   parts.observation.geometryMilliseconds == 3 && parts.observation.coverage == 0.5f &&
                   parts.observation.eventsPerPixel == 4,
               "agaaObserve of counts loses the times of the same settings, or has other counts.");
    parts.setTechnique("single", 1);
    parts.statistics.counters.visible = parts.statistics.counters.shadingEvents = 0;
    test.requireOk(parts.observe(test, nullptr), "agaaObserve of other settings");
    test.check(parts.observation.flags == 0, "agaaObserve keeps the times of other settings.");
}

// ---- agaaChooseSettings --------------------------------------------------------------------------

void testChooseNulls(Test& test) {
    GoalParts ideal(test.sdk), nulls(test.sdk);
    test.sdk.agaaInitChoice(&ideal.current, sizeof ideal.current);
    test.sdk.agaaInitObservation(&ideal.observation, sizeof ideal.observation);
    test.requireOk(ideal.choose(test, nullptr), "agaaChooseSettings with log = null");
    test.requireOk(
        test.sdk.agaaChooseSettings(nulls.get(), nullptr, nullptr, &nulls.goal, nullptr, nullptr, &nulls.choice),
        "agaaChooseSettings with caps, observation and current = null");
    test.check(std::string(ideal.choice.reason) == nulls.choice.reason && nulls.choice.technique &&
                   nulls.choice.hasChanged == 1,
               "agaaChooseSettings differs for null and for initialised structs.");
    nulls.desc.width = 0;
    test.result(nulls.choose(test, nullptr), AGAA_ERROR_OUT_OF_RANGE,
                "agaaChooseSettings with log = null and AgaaViewDesc::width = 0");
}

struct WrongGoal {
    const char* what;
    AgaaResult expected;
    void (*corrupt)(GoalParts&);
};

const WrongGoal wrongGoals[] = {
    {"an unknown technique in current", AGAA_ERROR_INVALID_ARGUMENT,
     [](GoalParts& p) { p.current.technique = "ssaaa"; }},
    {"other samples in current", AGAA_ERROR_INVALID_ARGUMENT, [](GoalParts& p) { p.current.samples = 7; }},
    {"two functions that exclude each other", AGAA_ERROR_INVALID_ARGUMENT,
     [](GoalParts& p) {
         p.chain(p.fetch);
         p.chain(p.gbuffer);
     }},
    {"AgaaGoal::measured = null and a count", AGAA_ERROR_INVALID_ARGUMENT,
     [](GoalParts& p) { p.goal.measuredCount = 1; }},
    {"AgaaGoal::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.goal.sType = 0; }},
    {"AgaaObservation::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.observation.sType = 0; }},
    {"AgaaChoice::sType = 0 of current", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.current.sType = 0; }},
    {"AgaaChoice::sType = 0 of outChoice", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.choice.sType = 0; }},
    {"AgaaDeviceCaps::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.caps.sType = 0; }},
    {"AgaaGoal::maxErrorShare = 2", AGAA_ERROR_OUT_OF_RANGE, [](GoalParts& p) { p.goal.maxErrorShare = 2; }},
    {"AgaaViewDesc::height = 0", AGAA_ERROR_OUT_OF_RANGE, [](GoalParts& p) { p.desc.height = 0; }},
    {"a layout without attributes", AGAA_ERROR_LAYOUT,
     [](GoalParts& p) {
         p.layout.attributeCount = 0;
         p.useLayout();
     }},
    {"more draws than ids distinguish", AGAA_ERROR_TOO_LARGE,
     [](GoalParts& p) {
         p.chain(p.fetch);
         p.fetch.maxDraws = p.fetch.maxPrimitives = 0xFFFFFFFF;
     }},
    {"AgaaConfig::technique = \"mlaa\"", AGAA_ERROR_UNSUPPORTED, [](GoalParts& p) { p.config.technique = "mlaa"; }},
    {"a device that is too small for the view", AGAA_ERROR_UNSUPPORTED, [](GoalParts& p) { p.caps.maxImageSize = 1; }},
};

struct WrongMeasured {
    const char* what;
    AgaaResult expected;
    void (*corrupt)(AgaaGoal& goal, AgaaMeasuredSettings* m);
};

const WrongMeasured wrongMeasured[] = {
    {"other samples in AgaaGoal::measured", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].samples = 7; }},
    {"AgaaMeasuredSettings::technique = null", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].technique = nullptr; }},
    {"an unknown AgaaMeasuredSettings::preset", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].preset = "best"; }},
    {"a tier that the measured technique lacks", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].generationTier = AGAA_TIER_GBUFFER; }},
    {"measured settings that occur twice", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1] = m[0]; }},
    {"measured times without pixels", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].pixels = 0; }},
    {"times of some measured settings", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].geometryMilliseconds = m[1].shadingMilliseconds = 0; }},
    {"a measured error without AgaaMeasuredSettings::errorShare", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].errorShare = 0; }},
    {"AgaaGoal::maxError without AgaaMeasuredSettings::error", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal& goal, AgaaMeasuredSettings* m) {
         goal.maxError = 1;
         m[1].error = 0;
     }},
    {"AGAA_GOAL_PREDICT_OTHERS and measured times", AGAA_ERROR_INVALID_ARGUMENT,
     [](AgaaGoal& goal, AgaaMeasuredSettings*) { goal.flags = AGAA_GOAL_PREDICT_OTHERS; }},
    {"AgaaMeasuredSettings::sType = 0", AGAA_ERROR_STRUCT, [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].sType = 0; }},
    {"measured settings of other structSizes", AGAA_ERROR_STRUCT,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].structSize += 8; }},
    {"a measured error that is not a number", AGAA_ERROR_OUT_OF_RANGE,
     [](AgaaGoal&, AgaaMeasuredSettings* m) { m[1].errorShare = std::numeric_limits<float>::quiet_NaN(); }},
};

void expectGoalRefused(Test& test, GoalParts& parts, AgaaResult error, const char* what) {
    const AgaaChoice before = parts.choice;
    LogRecorder log;
    const std::string call = callWith("agaaChooseSettings", what);
    expectRefused(test, parts.choose(test, log.get()), error, log, "agaaChooseSettings", call);
    test.check(isSameChoice(before, parts.choice), call + " writes.");
}

// Runs the rows of an error; AGAA_OK selects all rows.
void testWrongGoals(Test& test, AgaaResult error) {
    for (const WrongGoal& row : wrongGoals) {
        if (error != AGAA_OK && row.expected != error)
            continue;
        GoalParts parts(test.sdk);
        row.corrupt(parts);
        expectGoalRefused(test, parts, row.expected, row.what);
    }
    for (const WrongMeasured& row : wrongMeasured) {
        if (error != AGAA_OK && row.expected != error)
            continue;
        GoalParts parts(test.sdk);
        parts.useMeasured();
        row.corrupt(parts.goal, parts.measured);
        expectGoalRefused(test, parts, row.expected, row.what);
    }
}

// Only measured settings are chosen, by their measured errors and times.
void testMeasured(Test& test) {
    GoalParts parts(test.sdk);
    parts.useMeasured();
    test.sdk.agaaInitObservation(&parts.observation, sizeof parts.observation);
    for (const float share : {1.0f, 0.125f}) {
        parts.goal.maxErrorShare = share;
        test.sdk.agaaInitChoice(&parts.current, sizeof parts.current);
        test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings with AgaaGoal::measured");
        const AgaaMeasuredSettings& expected = parts.measured[share < 1 ? 1 : 0];
        test.check(parts.choice.samples == expected.samples && parts.choice.errorShare == expected.errorShare &&
                       parts.choice.error == expected.error &&
                       parts.choice.milliseconds == expected.geometryMilliseconds + expected.shadingMilliseconds,
                   "agaaChooseSettings does not choose by AgaaGoal::measured: " + std::string(parts.choice.reason));
    }
    parts.goal.measuredCount = 0;
    test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings with AgaaGoal::measured and measuredCount = 0");
}

// Settings that are not measured are chosen, too, and their errors follow the measured ones.
void testPredictedOthers(Test& test) {
    float last = 0;
    for (const float measured : {0.01f, 0.3f}) {
        GoalParts parts(test.sdk);
        parts.useMeasured();
        parts.goal.flags = AGAA_GOAL_PREDICT_OTHERS;
        parts.goal.prefer = AGAA_PREFER_ERROR;
        parts.measured[1].errorShare = measured;
        for (AgaaMeasuredSettings& settings : parts.measured)
            settings.geometryMilliseconds = settings.shadingMilliseconds = 0;
        test.sdk.agaaInitChoice(&parts.current, sizeof parts.current);
        test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings with AGAA_GOAL_PREDICT_OTHERS");
        test.check(parts.choice.samples > 8, "AGAA_GOAL_PREDICT_OTHERS chooses among the measured settings only.");
        test.check(parts.choice.errorShare > last,
                   "AGAA_GOAL_PREDICT_OTHERS: the predicted error does not grow with the measured one.");
        last = parts.choice.errorShare;
    }
}

void testChooseInvalid(Test& test) {
    testWrongGoals(test, AGAA_ERROR_INVALID_ARGUMENT);
    GoalParts parts(test.sdk);
    LogRecorder log;
    expectRefused(
        test, test.sdk.agaaChooseSettings(parts.get(), nullptr, log.get(), nullptr, nullptr, nullptr, &parts.choice),
        AGAA_ERROR_INVALID_ARGUMENT, log, "agaaChooseSettings", "agaaChooseSettings with goal = null");
    expectRefused(test,
                  test.sdk.agaaChooseSettings(parts.get(), nullptr, log.get(), &parts.goal, nullptr, nullptr, nullptr),
                  AGAA_ERROR_INVALID_ARGUMENT, log, "agaaChooseSettings", "agaaChooseSettings with outChoice = null");
}

// ---- agaaApplyChoice -----------------------------------------------------------------------------

// The view of a choice has the bytes that the choice predicts.
void testApplied(Test& test) {
    for (const float share : {1.0f, 0.25f, 0.1f, 0.05f, 0.02f}) {
        GoalParts parts(test.sdk);
        parts.goal.maxErrorShare = share;
        test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings");
        test.requireOk(test.sdk.agaaApplyChoice(&parts.choice, &parts.config, &parts.aggregation, nullptr),
                       "agaaApplyChoice with measurement = null");
        AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
        test.requireOk(test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, &report, nullptr, nullptr),
                       std::string("agaaQueryMemory of the choice ") + parts.choice.reason);
        test.check(report.totalBytes == parts.choice.bytes,
                   "a choice has other bytes than agaaQueryMemory of its view.");
    }
}

const WrongGoal wrongChoices[] = {
    {"a choice that is not made", AGAA_ERROR_INVALID_ARGUMENT, [](GoalParts& p) { p.current.technique = nullptr; }},
    {"a choice of other samples", AGAA_ERROR_INVALID_ARGUMENT, [](GoalParts& p) { p.current.samples = 3; }},
    {"AgaaChoice::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.current.sType = 0; }},
    {"AgaaConfig::sType = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.config.sType = 0; }},
    {"AgaaAggregation::structSize = 0", AGAA_ERROR_STRUCT, [](GoalParts& p) { p.aggregation.structSize = 0; }},
    {"an unknown struct chained to AgaaConfig", AGAA_ERROR_UNKNOWN_STRUCT,
     [](GoalParts& p) { p.config.pNext = &p.caps; }},
};

void testWrongChoices(Test& test, AgaaResult error) {
    for (const WrongGoal& row : wrongChoices) {
        if (row.expected != error)
            continue;
        GoalParts parts(test.sdk);
        row.corrupt(parts);
        const AgaaConfig config = parts.config;
        const AgaaAggregation aggregation = parts.aggregation;
        const std::string call = callWith("agaaApplyChoice", row.what);
        test.result(test.sdk.agaaApplyChoice(&parts.current, &parts.config, &parts.aggregation, nullptr), error, call);
        test.check(std::memcmp(&config, &parts.config, sizeof config) == 0 &&
                       std::memcmp(&aggregation, &parts.aggregation, sizeof aggregation) == 0,
                   call + " fails and changes a struct.");
    }
}

void testApplyInvalid(Test& test) {
    testWrongChoices(test, AGAA_ERROR_INVALID_ARGUMENT);
    GoalParts parts(test.sdk);
    const AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT;
    test.result(test.sdk.agaaApplyChoice(nullptr, &parts.config, &parts.aggregation, nullptr), invalid,
                "agaaApplyChoice with choice = null");
    test.result(test.sdk.agaaApplyChoice(&parts.current, nullptr, &parts.aggregation, nullptr), invalid,
                "agaaApplyChoice with config = null");
    test.result(test.sdk.agaaApplyChoice(&parts.current, &parts.config, nullptr, nullptr), invalid,
                "agaaApplyChoice with aggregation = null");
}

} // namespace

void addGoalCases(Suite& suite) {
    suite.core("agaaObserve/caps.null", testObserveNulls);
    suite.core("agaaObserve/log.null", testObserveNulls);
    suite.core("agaaObserve/outObservation.unchanged", [](Test& test) { testWrongStatistics(test, AGAA_OK); });
    suite.core("agaaObserve/those_of.agaaQueryMemory", [](Test& test) {
        testWrongViews(test, nullptr, "agaaObserve", [&](const ViewParts& parts, LogRecorder& log) {
            GoalParts valid(test.sdk);
            return test.sdk.agaaObserve(parts.get(), &parts.caps, log.get(), &valid.statistics, &valid.observation);
        });
    });
    suite.core("agaaObserve/AGAA_ERROR_INVALID_ARGUMENT", testObserveInvalid);
    suite.core("agaaObserve/AGAA_ERROR_STRUCT", [](Test& test) { testWrongStatistics(test, AGAA_ERROR_STRUCT); });
    suite.core("agaaObserve/AGAA_ERROR_OUT_OF_RANGE",
               [](Test& test) { testWrongStatistics(test, AGAA_ERROR_OUT_OF_RANGE); });
    suite.core("agaaObserve/merged", testMerged);
    for (const char* parameter : {"caps", "log", "observation", "current"})
        suite.core(std::string("agaaChooseSettings/") + parameter + ".null", testChooseNulls);
    suite.core("agaaChooseSettings/measured", testMeasured);
    suite.core("agaaChooseSettings/predictedOthers", testPredictedOthers);
    suite.core("agaaChooseSettings/outChoice.unchanged", [](Test& test) { testWrongGoals(test, AGAA_OK); });
    suite.core("agaaChooseSettings/AGAA_ERROR_INVALID_ARGUMENT", testChooseInvalid);
    for (const auto& [name, error] : {std::pair<const char*, AgaaResult>{"STRUCT", AGAA_ERROR_STRUCT},
                                      {"OUT_OF_RANGE", AGAA_ERROR_OUT_OF_RANGE},
                                      {"LAYOUT", AGAA_ERROR_LAYOUT},
                                      {"TOO_LARGE", AGAA_ERROR_TOO_LARGE},
                                      {"UNSUPPORTED", AGAA_ERROR_UNSUPPORTED}})
        suite.core(std::string("agaaChooseSettings/AGAA_ERROR_") + name,
                   [error = error](Test& test) { testWrongGoals(test, error); });
    suite.core("agaaApplyChoice/measurement.null", testApplied);
    suite.core("agaaApplyChoice/AGAA_ERROR_INVALID_ARGUMENT", testApplyInvalid);
    suite.core("agaaApplyChoice/AGAA_ERROR_STRUCT", [](Test& test) { testWrongChoices(test, AGAA_ERROR_STRUCT); });
    suite.core("agaaApplyChoice/AGAA_ERROR_UNKNOWN_STRUCT",
               [](Test& test) { testWrongChoices(test, AGAA_ERROR_UNKNOWN_STRUCT); });
}

} // namespace agaa::conformance
