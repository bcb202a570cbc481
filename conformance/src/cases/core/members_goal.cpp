// Members of AgaaGoal, AgaaObservation and AgaaChoice.
#include "cases.h"
#include "goal_parts.h"
#include "members.h"
#include "structs.h"

namespace agaa::conformance {

namespace {

struct Member {
    const char* promise;
    std::string name; // AgaaGoal::maxError
    std::function<void(GoalParts&, double)> set;
    std::vector<double> accepted, refused;
};

void testMember(Test& test, const Member& member) {
    for (const double value : member.accepted) {
        GoalParts parts(test.sdk);
        member.set(parts, value);
        test.requireOk(parts.choose(test, nullptr),
                       "agaaChooseSettings with " + member.name + " = " + numberText(value));
    }
    for (const double value : member.refused) {
        GoalParts parts(test.sdk);
        member.set(parts, value);
        LogRecorder log;
        expectRefused(test, parts.choose(test, log.get()), AGAA_ERROR_OUT_OF_RANGE, log, "agaaChooseSettings",
                      "agaaChooseSettings with " + member.name + " = " + numberText(value), member.name);
    }
}

void add(Suite& suite, const Member& member) {
    suite.core(member.promise, [member](Test& test) { testMember(test, member); });
}

void addGoal(Suite& suite) {
    const double largest = std::numeric_limits<float>::max();
    add(suite, {"AgaaGoal.maxErrorShare/range",
                "AgaaGoal::maxErrorShare",
                [](GoalParts& p, double x) { p.goal.maxErrorShare = float(x); },
                {0, above(0), 1},
                notNumbers({-1, above(1)})});
    add(suite, {"AgaaGoal.maxError/range",
                "AgaaGoal::maxError",
                [](GoalParts& p, double x) { p.goal.maxError = float(x); },
                {0, above(0), largest},
                notNumbers({-1, below(0)})});
    add(suite, {"AgaaGoal.sceneShare/range",
                "AgaaGoal::sceneShare",
                [](GoalParts& p, double x) { p.goal.sceneShare = float(x); },
                {0, 0.5, 1},
                notNumbers({-1, above(1)})});
    add(suite, {"AgaaGoal.maxMilliseconds/range",
                "AgaaGoal::maxMilliseconds",
                [](GoalParts& p, double x) { p.goal.maxMilliseconds = float(x); },
                {0, above(0), largest},
                notNumbers({-1, below(0)})});
    add(suite, {"AgaaGoal.prefer/enum",
                "AgaaGoal::prefer",
                [](GoalParts& p, double x) { p.goal.prefer = whole(x); },
                {AGAA_PREFER_TIME, AGAA_PREFER_ERROR},
                largeNumbers({})});
    add(suite, {"AgaaGoal.reserved/zero",
                "AgaaGoal::reserved",
                [](GoalParts& p, double x) { p.goal.reserved = whole(x); },
                {0},
                largeNumbers({})});
    add(suite, {"AgaaGoal.reservedMeasured/zero",
                "AgaaGoal::reservedMeasured",
                [](GoalParts& p, double x) { p.goal.reservedMeasured = whole(x); },
                {0},
                largeNumbers({})});
    add(suite, {"AgaaGoal.flags/flags",
                "AgaaGoal::flags",
                [](GoalParts& p, double x) { p.goal.flags = uint64_t(x); },
                {0, double(AGAA_GOAL_ONE_GEOMETRY_PASS), double(AGAA_GOAL_PREDICT_OTHERS)},
                {double(UINT64_C(1) << 62), double(UINT64_C(1) << 63)}});
}

void addMeasured(Suite& suite) {
    add(suite, {"AgaaMeasuredSettings.reserved/zero",
                "AgaaGoal::measured[1].reserved",
                [](GoalParts& p, double x) {
                    p.useMeasured();
                    p.measured[1].reserved = whole(x);
                },
                {0},
                largeNumbers({})});
    struct Number {
        const char* name;
        float AgaaMeasuredSettings::*member;
        double least; // smallest value that other members allow
    };
    for (const Number& n : {Number{"errorShare", &AgaaMeasuredSettings::errorShare, above(0)},
                            {"error", &AgaaMeasuredSettings::error, 0},
                            {"geometryMilliseconds", &AgaaMeasuredSettings::geometryMilliseconds, 0},
                            {"shadingMilliseconds", &AgaaMeasuredSettings::shadingMilliseconds, 0}}) {
        const std::string promise = std::string("AgaaMeasuredSettings.") + n.name + "/range";
        const Member member = {"",
                               std::string("AgaaGoal::measured[1].") + n.name,
                               [n](GoalParts& p, double x) {
                                   p.useMeasured();
                                   p.measured[1].*n.member = float(x);
                               },
                               {n.least, 1, 1e9},
                               notNumbers({-1, above(1e9f)})};
        suite.core(promise, [member](Test& test) { testMember(test, member); });
    }
}

void addObservation(Suite& suite) {
    add(suite, {"AgaaObservation.flags/flags",
                "AgaaObservation::flags",
                [](GoalParts& p, double x) { p.observation.flags = uint64_t(x); },
                {0, double(AGAA_OBSERVED_COUNTS), double(AGAA_OBSERVED_TIMES)},
                {double(UINT64_C(1) << 62)}});
    add(suite, {"AgaaObservation.samples/range",
                "AgaaObservation::samples",
                [](GoalParts& p, double x) { p.observation.samples = whole(x); },
                {0, 1, 128},
                largeNumbers({129})});
    add(suite, {"AgaaObservation.aggregates/range",
                "AgaaObservation::aggregates",
                [](GoalParts& p, double x) { p.observation.aggregates = whole(x); },
                {0, 1, 8},
                largeNumbers({9})});
    add(suite, {"AgaaObservation.generationTier/enum",
                "AgaaObservation::generationTier",
                [](GoalParts& p, double x) { p.observation.generationTier = whole(x); },
                {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER},
                largeNumbers({})});
    add(suite, {"AgaaObservation.reserved/zero",
                "AgaaObservation::reserved",
                [](GoalParts& p, double x) { p.observation.reserved = whole(x); },
                {0},
                largeNumbers({})});
    struct Number {
        const char* name;
        float AgaaObservation::*member;
        float largest;
    };
    for (const Number& n : {Number{"coverage", &AgaaObservation::coverage, 1},
                            {"eventsPerPixel", &AgaaObservation::eventsPerPixel, 1e6f},
                            {"lightsPerEvent", &AgaaObservation::lightsPerEvent, 1e6f},
                            {"shadowTapsPerEvent", &AgaaObservation::shadowTapsPerEvent, 1e6f},
                            {"geometryMilliseconds", &AgaaObservation::geometryMilliseconds, 1e9f},
                            {"shadingMilliseconds", &AgaaObservation::shadingMilliseconds, 1e9f}}) {
        const std::string promise = std::string("AgaaObservation.") + n.name + "/range";
        const Member member = {"",
                               std::string("AgaaObservation::") + n.name,
                               [n](GoalParts& p, double x) {
                                   p.observation.flags = AGAA_OBSERVED_COUNTS | AGAA_OBSERVED_TIMES;
                                   p.observation.*n.member = float(x);
                               },
                               {0, above(0), n.largest},
                               notNumbers({-1, above(n.largest)})};
        suite.core(promise, [member](Test& test) { testMember(test, member); });
    }
}

// Tests strings that no frame and no choice has.
void testUnknown(Test& test) {
    GoalParts parts(test.sdk);
    parts.observation.technique = parts.observation.preset = nullptr;
    parts.current.technique = parts.current.preset = nullptr;
    parts.useMeasured();
    parts.measured[0].preset = nullptr;
    test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings with null for techniques and presets");
    test.check(parts.choice.hasChanged == 1, "a choice without a current one has not changed.");
}

// Tests each number of AgaaChoice::memory.
void testMemory(Test& test) {
    for (uint32_t i = 0; i < AGAA_CHOICE_MEMORY; i += 7)
        testMember(test, {"",
                          "AgaaChoice::memory",
                          [i](GoalParts& p, double x) { p.current.memory[i] = float(x); },
                          {0, 1},
                          notNumbers({-1})});
}

// Tests the members of choices for goals that can and that cannot be met.
void testDescriptions(Test& test) {
    for (const float share : {0.5f, 0.1f, 1e-6f})
        for (const uint64_t bytes : {UINT64_C(0), UINT64_C(1)}) {
            GoalParts parts(test.sdk);
            parts.goal.maxErrorShare = share;
            parts.goal.maxBytes = bytes;
            test.requireOk(parts.choose(test, nullptr), "agaaChooseSettings");
            const AgaaChoice& c = parts.choice;
            const uint32_t expected =
                (c.errorShare > share ? AGAA_LIMIT_ERROR_SHARE : 0u) | (bytes ? AGAA_LIMIT_BYTES : 0u);
            test.check(c.missedLimits == expected,
                       "AgaaChoice::missedLimits is not of the limits that the choice misses.");
            test.check(share > 1e-5f || c.missedLimits & AGAA_LIMIT_ERROR_SHARE,
                       "an error that nothing has is reached.");
            test.check(std::string(test.sdk.agaaTierName(c.generationTier)) != "unknown",
                       "a choice has an unknown tier.");
        }
}

} // namespace

void addGoalMemberCases(Suite& suite) {
    addGoal(suite);
    addMeasured(suite);
    addObservation(suite);
    suite.core("AgaaMeasuredSettings.preset/null", testUnknown);
    suite.core("AgaaObservation.technique/null", testUnknown);
    suite.core("AgaaObservation.preset/null", testUnknown);
    suite.core("AgaaChoice.technique/null", testUnknown);
    suite.core("AgaaChoice.preset/null", testUnknown);
    suite.core("AgaaChoice.memory/range", testMemory);
    suite.core("AgaaChoice.missedLimits/flags", testDescriptions);
    suite.core("AgaaChoice.generationTier/enum", testDescriptions);
}

} // namespace agaa::conformance
