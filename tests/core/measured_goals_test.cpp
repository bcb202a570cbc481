// Settings for goals by what a host measured in its own scene: its errors and times decide, and observed times scale
// them.
#include "goal_host.h"

#include "core/tuning/cost_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

using namespace agaa;
using namespace agaa::test;

namespace {

AgaaMeasuredSettings measuredOf(const ChoiceRow& row, float errorShare, float geometry = 0, float shading = 0) {
    AgaaMeasuredSettings m = AGAA_MEASURED_SETTINGS_INIT;
    m.technique = row.technique;
    m.preset = *row.preset ? row.preset : nullptr;
    m.samples = row.samples;
    m.aggregates = row.aggregates;
    m.generationTier = row.tier;
    m.errorShare = errorShare;
    m.error = errorShare * 0.01f;
    m.geometryMilliseconds = geometry;
    m.shadingMilliseconds = shading;
    m.pixels = 1280 * 720;
    return m;
}

const ChoiceRow& rowNamed(const char* technique, uint32_t samples) {
    const ChoiceRow* row = findRow(technique, samples, 0, nullptr, AGAA_TIER_AUTO);
    if (!row)
        throw std::logic_error("no row");
    return *row;
}

// A host that measured some settings.
struct MeasuringHost : Host {
    std::vector<AgaaMeasuredSettings> measured;

    AgaaResult chooseMeasured(const AgaaObservation* observation = nullptr) {
        goal.measured = measured.data();
        goal.measuredCount = uint32_t(measured.size());
        return choose(observation);
    }
    AgaaChoice freshMeasured(const AgaaObservation* observation = nullptr) {
        choice = AGAA_CHOICE_INIT;
        EXPECT_EQ(chooseMeasured(observation), AGAA_OK) << message;
        return choice;
    }
};

bool isOf(const AgaaChoice& choice, const ChoiceRow& row) { return rowOf(choice) == &row; }

// It measured three settings: errors 1, 0.2 and 0.1, and times of their own.
struct HostOfThree : MeasuringHost {
    HostOfThree() {
        measured = {measuredOf(rowNamed("single", 1), 1, 1, 2), measuredOf(rowNamed("ssaa", 4), 0.2f, 2, 8),
                    measuredOf(rowNamed("ssaa", 8), 0.1f, 4, 16)};
    }
};

AgaaObservation timedFrame(const ChoiceRow& row, float geometry, float shading) {
    AgaaObservation o = AGAA_OBSERVATION_INIT;
    o.flags = AGAA_OBSERVED_TIMES;
    o.technique = row.technique;
    o.samples = row.samples;
    o.pixels = 1280 * 720;
    o.geometryMilliseconds = geometry;
    o.shadingMilliseconds = shading;
    return o;
}

// ---- errors --------------------------------------------------------------------------------------

TEST(MeasuredGoals, MeasuredErrorsMakeAChoiceThatTheTableWouldNotMake) {
    MeasuringHost host;
    host.goal.maxErrorShare = 0.15f;
    const AgaaChoice table = host.fresh();
    ASSERT_EQ(table.missedLimits, 0u) << table.reason;
    const ChoiceRow& own = rowNamed("ssaa", 32);
    ASSERT_FALSE(isOf(table, own));
    for (const ChoiceRow& row : choiceRows()) // the scene misses the limit with all settings but one
        host.measured.push_back(measuredOf(row, &row == &own ? 0.1f : 0.5f));
    const AgaaChoice choice = host.freshMeasured();
    EXPECT_TRUE(isOf(choice, own)) << choice.reason;
    EXPECT_EQ(choice.missedLimits, 0u);
    host.choice = table; // which misses the limit in this scene
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK) << host.message;
    EXPECT_TRUE(isOf(host.choice, own)) << host.choice.reason;
}

TEST(MeasuredGoals, ErrorsAreTheMeasuredOnesWhateverTheSceneShare) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.25f;
    for (const float share : {0.0f, 0.5f, 1.0f}) {
        host.goal.sceneShare = share;
        const AgaaChoice choice = host.freshMeasured();
        EXPECT_TRUE(isOf(choice, rowNamed("ssaa", 4))) << choice.reason;
        for (const float error : {choice.errorShare, choice.errorShareMedian, choice.errorShareWorst})
            EXPECT_EQ(error, 0.2f);
        EXPECT_EQ(choice.error, 0.2f * 0.01f);
        EXPECT_NE(std::string(choice.reason).find("Measured: error 0.2 of single's."), std::string::npos)
            << choice.reason;
    }
    host.goal.maxErrorShare = 0;
    host.goal.maxError = 0.0015f;
    EXPECT_TRUE(isOf(host.freshMeasured(), rowNamed("ssaa", 8))) << host.choice.reason;
    host.goal.maxError = 1e-5f;
    EXPECT_EQ(host.freshMeasured().missedLimits, AGAA_LIMIT_ERROR) << host.choice.reason;
}

TEST(MeasuredGoals, OnlyNamedSettingsAreCandidates) {
    HostOfThree host;
    for (const AgaaPreference preference : {AGAA_PREFER_TIME, AGAA_PREFER_ERROR})
        for (const float limit : {1.0f, 0.2f, 0.1f, 0.01f}) {
            host.goal.prefer = preference;
            host.goal.maxErrorShare = limit;
            const AgaaChoice choice = host.freshMeasured();
            EXPECT_TRUE(isOf(choice, rowNamed("single", 1)) || isOf(choice, rowNamed("ssaa", 4)) ||
                        isOf(choice, rowNamed("ssaa", 8)))
                << choice.reason;
            EXPECT_EQ(choice.leftOut, 0u) << choice.reason;
        }
    host.choice = AGAA_CHOICE_INIT;
    host.choice.technique = "ssaa"; // the current choice is not among them
    host.choice.samples = 32;
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK) << host.message;
    EXPECT_EQ(host.choice.hasChanged, 1u);
    EXPECT_TRUE(isOf(host.choice, rowNamed("ssaa", 8))) << host.choice.reason;
}

TEST(MeasuredGoals, NamedSettingsThatCannotBePlannedAreLeftOut) {
    HostOfThree host;
    const ChoiceRow* byId = findRow("agaa", 8, 2, nullptr, AGAA_TIER_IDS);
    ASSERT_TRUE(byId);
    host.measured.push_back(measuredOf(*byId, 0.01f, 1, 1));
    EXPECT_EQ(host.freshMeasured().leftOut, 0u);
    host.view.pNext = nullptr; // nothing fetches materials by id
    EXPECT_EQ(host.freshMeasured().leftOut, 1u) << host.choice.reason;
    EXPECT_FALSE(isOf(host.choice, *byId));
    host.measured = {host.measured.back()};
    EXPECT_EQ(host.chooseMeasured(), AGAA_ERROR_UNSUPPORTED);
}

// ---- times ---------------------------------------------------------------------------------------

TEST(MeasuredGoals, MeasuredTimesDecide) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.5f;
    EXPECT_TRUE(isOf(host.freshMeasured(), rowNamed("ssaa", 4)));
    EXPECT_EQ(host.choice.milliseconds, 10.0f);
    EXPECT_EQ(std::string(host.choice.reason).find("table's device"), std::string::npos) << host.choice.reason;
    host.measured[1].shadingMilliseconds = 100; // against the order of the table
    EXPECT_TRUE(isOf(host.freshMeasured(), rowNamed("ssaa", 8)));
    EXPECT_EQ(host.choice.milliseconds, 20.0f);
    for (AgaaMeasuredSettings& m : host.measured)
        m.pixels /= 4; // of another size: shading takes four times as long, geometry as one size lets assume
    EXPECT_EQ(host.freshMeasured().milliseconds, 72.0f);
}

TEST(MeasuredGoals, ObservedTimesScaleMeasuredOnes) {
    HostOfThree host;
    const AgaaObservation slow = timedFrame(rowNamed("single", 1), 1 * 2, 2 * 3);
    host.goal.maxErrorShare = 0.5f;
    const AgaaChoice other = host.freshMeasured(&slow);
    EXPECT_TRUE(isOf(other, rowNamed("ssaa", 4)));
    EXPECT_EQ(other.hasTimes, 1u);
    EXPECT_FLOAT_EQ(other.milliseconds, 2 * 2 + 8 * 3);
    for (int frame = 0; frame < 200; ++frame) { // settings that run are predicted by their own
        const AgaaObservation own = timedFrame(rowNamed("ssaa", 4), 2 * 2, 8 * 4);
        ASSERT_EQ(host.chooseMeasured(&own), AGAA_OK);
        EXPECT_EQ(host.choice.hasChanged, 0u) << host.choice.reason;
    }
    EXPECT_NEAR(host.choice.milliseconds, 2 * 2 + 8 * 4, 1e-3);
}

TEST(MeasuredGoals, WithoutTimesTheTablePredictsThem) {
    HostOfThree host;
    for (AgaaMeasuredSettings& m : host.measured) {
        m.geometryMilliseconds = m.shadingMilliseconds = 0;
        m.pixels = 0;
    }
    host.goal.maxErrorShare = 0.5f;
    const FrameTimes table = predictTimes(rowNamed("ssaa", 4), usualTerms(host.facts), 1280 * 720);
    EXPECT_FLOAT_EQ(host.freshMeasured().milliseconds, float(table.geometry + table.shading));
    EXPECT_NE(std::string(host.choice.reason).find("on the table's device"), std::string::npos) << host.choice.reason;
    const FrameTimes single = predictTimes(rowNamed("single", 1), usualTerms(host.facts), 1280 * 720);
    host.measured.erase(host.measured.begin()); // observed settings need not be named
    const AgaaObservation frame =
        timedFrame(rowNamed("single", 1), float(single.geometry / 8), float(single.shading / 8));
    EXPECT_FLOAT_EQ(host.freshMeasured(&frame).milliseconds, float(table.geometry + table.shading) / 8);
}

TEST(MeasuredGoals, TimesOfSettingsThatWereNotMeasuredAreNotUsed) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.5f;
    const AgaaObservation frame = timedFrame(rowNamed("ssaa", 32), 100, 100);
    EXPECT_EQ(host.freshMeasured(&frame).hasTimes, 0u);
    EXPECT_EQ(host.choice.milliseconds, 10.0f);
}

// What was observed is kept by other predicted times.
TEST(MeasuredGoals, ObservedTimesAreForgottenWhenMeasuredTimesChange) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.5f;
    const AgaaObservation frame =
        timedFrame(rowNamed("single", 1), 0.01f, 0.01f); // much faster than the table's device
    EXPECT_EQ(host.fresh(&frame).hasTimes, 1u);
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK) << host.message;
    EXPECT_EQ(host.choice.hasTimes, 0u);
    EXPECT_EQ(host.choice.milliseconds, 10.0f) << host.choice.reason;
    const AgaaObservation half = timedFrame(rowNamed("single", 1), 0.5f, 1);
    ASSERT_EQ(host.chooseMeasured(&half), AGAA_OK);
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK); // the same: they stay
    EXPECT_EQ(host.choice.hasTimes, 1u);
    EXPECT_EQ(host.choice.milliseconds, 5.0f);
    host.measured[2].shadingMilliseconds *= 2;
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK);
    EXPECT_EQ(host.choice.hasTimes, 0u);
    EXPECT_EQ(host.choice.milliseconds, 10.0f);
    ASSERT_EQ(host.chooseMeasured(&half), AGAA_OK);
    host.goal.measuredCount = 0;
    ASSERT_EQ(host.choose(), AGAA_OK);
    EXPECT_EQ(host.choice.hasTimes, 0u);
}

// Of hosts that time whole frames.
TEST(MeasuredGoals, TimesOfOnePartAreScaledAsAWhole) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.5f;
    for (AgaaMeasuredSettings& m : host.measured) {
        m.shadingMilliseconds += m.geometryMilliseconds;
        m.geometryMilliseconds = 0;
    }
    const AgaaObservation frame = timedFrame(rowNamed("single", 1), 3, 3); // twice as long
    EXPECT_FLOAT_EQ(host.freshMeasured(&frame).milliseconds, 20.0f);
}

// Two settings whose times lie 5 % apart, and frames that spread by 20 %.
TEST(MeasuredGoals, ChoicesSettleUnderNoise) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.5f;
    host.measured[1].shadingMilliseconds = 9;
    host.measured[2].geometryMilliseconds = 2.5f;
    host.measured[2].shadingMilliseconds = 9;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> noise(0.8f, 1.2f);
    ASSERT_EQ(host.chooseMeasured(), AGAA_OK);
    for (int frame = 0; frame < 600; ++frame) {
        const AgaaMeasuredSettings& m = host.measured[host.choice.samples == 4 ? 1 : 2];
        const AgaaObservation o =
            timedFrame(rowNamed("ssaa", host.choice.samples), m.geometryMilliseconds * noise(random),
                       m.shadingMilliseconds * noise(random));
        ASSERT_EQ(host.chooseMeasured(&o), AGAA_OK);
        EXPECT_EQ(host.choice.hasChanged, 0u) << frame << ": " << host.choice.reason;
    }
    EXPECT_NEAR(host.choice.milliseconds, 11, 1);
}

// ---- sizes ---------------------------------------------------------------------------------------

// A scene whose geometry takes milliseconds for vertices, and for each million pixels.
struct Scene {
    double vertices, pixels, shading;
    AgaaObservation frame(uint64_t count, double factor = 1) const {
        AgaaObservation o =
            timedFrame(rowNamed("single", 1), float(factor * (vertices + pixels * double(count) * 1e-6)),
                       float(factor * shading * double(count) * 1e-6));
        o.pixels = count;
        return o;
    }
    double milliseconds(uint64_t count) const { return vertices + (pixels + shading) * double(count) * 1e-6; }
};

// A host that runs "single" alone, at any size.
struct ResizedHost : MeasuringHost {
    ResizedHost() { measured = {measuredOf(rowNamed("single", 1), 1)}; }

    double predict(uint32_t width, uint32_t height) {
        const AgaaChoice kept = choice;
        view.width = width;
        view.height = height;
        EXPECT_EQ(chooseMeasured(), AGAA_OK) << message;
        const double milliseconds = choice.milliseconds;
        choice = kept;
        return milliseconds;
    }
    void observe(const AgaaObservation& frame) { ASSERT_EQ(chooseMeasured(&frame), AGAA_OK) << message; }
};

// One size does not tell how geometry grows: it takes between as long and 16 times as long with 16 times the pixels.
TEST(GoalSizes, OneSizePredictsOthersWithinTheRootOfTheirRatio) {
    for (const Scene& scene : {Scene{5, 0, 1}, {0, 10, 1}, {3, 3, 1}}) {
        ResizedHost host;
        for (int i = 0; i < 40; ++i)
            host.observe(scene.frame(960 * 540));
        EXPECT_NEAR(host.predict(960, 540), scene.milliseconds(960 * 540), 1e-3);
        const double shading = scene.shading * 3840 * 2160 * 1e-6;
        const double ratio = (host.predict(3840, 2160) - shading) / (scene.milliseconds(3840 * 2160) - shading);
        std::printf("%g ms of vertices: geometry is predicted %.2f times as long\n", scene.vertices, ratio);
        EXPECT_LE(ratio, 4.01);
        EXPECT_GE(ratio, 1 / 4.01);
        const double less = (host.predict(240, 135) - scene.shading * 240 * 135 * 1e-6) /
                            (scene.milliseconds(240 * 135) - scene.shading * 240 * 135 * 1e-6);
        EXPECT_LE(less, 4.01);
        EXPECT_GE(less, 1 / 4.01);
    }
}

// Two sizes tell both parts, under noise and whatever came last.
TEST(GoalSizes, TwoSizesPredictAllOthers) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 5), noise(0.9, 1.1);
    double worst = 1;
    for (int run = 0; run < 100; ++run) {
        const Scene scene = {part(random), part(random), 0.5 + part(random)};
        ResizedHost host;
        for (int i = 0; i < 24; ++i)
            host.observe(scene.frame(960 * 540, noise(random)));
        for (int i = 0; i < 8; ++i)
            host.observe(scene.frame(1920 * 1080, noise(random)));
        for (const auto& [width, height] : {std::pair{3840u, 2160u}, {1280u, 720u}, {640u, 360u}}) {
            const double ratio = host.predict(width, height) / scene.milliseconds(uint64_t(width) * height);
            worst = std::max({worst, ratio, 1 / ratio});
        }
    }
    std::printf("the worst prediction is %.2f times off\n", worst);
    EXPECT_LE(worst, 1.3);
}

// Two sizes of one row show the parts also for rows that did not run, and after the size stays for long.
TEST(GoalSizes, OtherSettingsAndLaterFramesKeepTheParts) {
    const Scene scene = {5, 0, 1};
    ResizedHost host;
    for (int i = 0; i < 20; ++i)
        host.observe(scene.frame(960 * 540));
    for (int i = 0; i < 200; ++i)
        host.observe(scene.frame(1920 * 1080));
    EXPECT_NEAR(host.predict(3840, 2160), scene.milliseconds(3840 * 2160), 0.5);
    host.measured = {measuredOf(rowNamed("ssaa", 4), 1)};
    const double small = host.predict(960, 540), large = host.predict(1920, 1080), largest = host.predict(3840, 2160);
    EXPECT_NEAR((largest - large) / (large - small), 4, 0.1) << "a line over pixels";
    EXPECT_LT(largest, 10 * small) << "vertices take as long at all sizes";
}

// Sizes change by some percent in each frame, as with a dynamic resolution.
TEST(GoalSizes, ChangingSizesStayStable) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> scale(0.95, 1.05), noise(0.8, 1.2);
    const Scene scene = {2, 1, 1};
    ResizedHost host;
    for (int frame = 0; frame < 400; ++frame) {
        host.observe(scene.frame(uint64_t(scale(random) * 1920 * 1080), noise(random)));
        if (frame > 32) {
            EXPECT_NEAR(host.predict(1920, 1080) / scene.milliseconds(1920 * 1080), 1, 0.25);
        }
    }
}

TEST(GoalSizes, MeasuredTimesAreThoseOfTheirSize) {
    HostOfThree host;
    for (AgaaMeasuredSettings& m : host.measured)
        m.pixels = 1280 * 720 / 16;
    host.goal.maxErrorShare = 0.15f; // "ssaa" with n = 8: 4 ms and 16 ms
    EXPECT_FLOAT_EQ(host.freshMeasured().milliseconds, 4 * 4 + 16 * 16) << host.choice.reason;
}

// A device that cannot tell times reports none, rather than frames of no time.
TEST(GoalSizes, FramesOfNoTimeAreNotLearned) {
    const Scene scene = {2, 1, 1};
    ResizedHost host;
    host.observe(scene.frame(1920 * 1080));
    const double before = host.predict(1920, 1080);
    for (int i = 0; i < 40; ++i)
        host.observe(scene.frame(1920 * 1080, 0));
    EXPECT_DOUBLE_EQ(host.predict(1920, 1080), before);
}

// Numbers at the ends of their ranges leave a memory that the next call accepts.
TEST(GoalSizes, ExtremeObservationsKeepTheMemoryValid) {
    std::mt19937 random(5);
    const float times[] = {0, 1e-38f, 1e-3f, 1, 1e9f};
    const uint64_t sizes[] = {1, 2, 1920 * 1080, UINT64_C(1) << 40, ~UINT64_C(0)};
    const auto one = [&](const auto& list) { return list[random() % std::size(list)]; };
    for (int run = 0; run < 50; ++run) {
        ResizedHost host;
        host.measured.push_back(measuredOf(rowNamed("ssaa", 4), 0.5f));
        for (int i = 0; i < 20; ++i) {
            AgaaObservation o =
                timedFrame(random() % 2 ? rowNamed("single", 1) : rowNamed("ssaa", 4), one(times), one(times));
            o.pixels = one(sizes);
            o.flags |= AGAA_OBSERVED_COUNTS;
            o.coverage = std::min(one(times), 1.0f);
            o.eventsPerPixel = o.lightsPerEvent = o.shadowTapsPerEvent = std::min(one(times), 1e6f);
            host.observe(o);
            EXPECT_GE(host.choice.milliseconds, 0);
            for (const float number : host.choice.memory)
                ASSERT_TRUE(number >= 0 && number <= 1e12f) << number;
        }
        EXPECT_TRUE(std::isfinite(host.predict(1, 1)));
        EXPECT_TRUE(std::isfinite(host.predict(7680, 4320)));
    }
}

// ---- predicted others ----------------------------------------------------------------------------

// A host in a scene of the table measures each choice, and chooses anew with what it measured.
TEST(PredictedOthers, MeasuringTheChoicesReachesTheTarget) {
    for (size_t scene = 0; scene < tableScenes; ++scene)
        for (const float target : {0.25f, 0.1f, 0.05f}) {
            const bool isPossible = std::any_of(choiceRows().begin(), choiceRows().end(),
                                                [&](const ChoiceRow& row) { return row.errorShares[scene] <= target; });
            MeasuringHost host;
            host.goal.flags = AGAA_GOAL_PREDICT_OTHERS;
            host.goal.maxErrorShare = target;
            host.goal.sceneShare = 0.5f;
            std::set<const ChoiceRow*> measured;
            const ChoiceRow* chosen = rowOf(host.freshMeasured());
            while (measured.insert(chosen).second) {
                host.measured.push_back(measuredOf(*chosen, chosen->errorShares[scene]));
                chosen = rowOf(host.freshMeasured());
            }
            EXPECT_LE(measured.size(), 8u) << scene << ' ' << target;
            if (isPossible) {
                EXPECT_LE(chosen->errorShares[scene], target) << scene << ' ' << target << ' ' << host.choice.reason;
            }
        }
}

TEST(PredictedOthers, ErrorsScaleWithThatOfSingle) {
    MeasuringHost host;
    host.goal.flags = AGAA_GOAL_PREDICT_OTHERS;
    host.goal.prefer = AGAA_PREFER_ERROR;
    host.measured = {measuredOf(rowNamed("ssaa", 8), 0.2f)}; // its error is a hundredth of the share
    host.freshMeasured();
    EXPECT_FALSE(isOf(host.choice, rowNamed("ssaa", 8)));
    EXPECT_NEAR(host.choice.error / host.choice.errorShare, 0.01f, 1e-6f);
    EXPECT_LT(host.choice.errorShareMedian, host.choice.errorShare);
    EXPECT_LT(host.choice.errorShare, host.choice.errorShareWorst);
    EXPECT_NE(std::string(host.choice.reason).find("Predicted from 1 measured setting: error"), std::string::npos)
        << host.choice.reason;
    host.goal.sceneShare = 0.5f;
    EXPECT_EQ(host.freshMeasured().errorShare, host.choice.errorShareMedian);
}

// ---- wrong input ---------------------------------------------------------------------------------

TEST(MeasuredGoals, BadInputLeavesTheOutput) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    HostOfThree host;
    host.freshMeasured();
    const AgaaChoice before = host.choice;
    const std::vector<AgaaMeasuredSettings> valid = host.measured;
    const auto refused = [&](AgaaResult expected, const char* words,
                             const std::function<void(AgaaMeasuredSettings&)>& spoil) {
        host.measured = valid;
        spoil(host.measured[1]);
        EXPECT_EQ(host.chooseMeasured(), expected) << words;
        EXPECT_NE(host.message.find(words), std::string::npos) << host.message;
        EXPECT_EQ(std::memcmp(&before, &host.choice, sizeof before), 0) << words;
    };
    struct Number {
        float AgaaMeasuredSettings::*member;
        const char* name;
    };
    for (const Number& n : {Number{&AgaaMeasuredSettings::errorShare, "measured[1].errorShare"},
                            {&AgaaMeasuredSettings::error, "measured[1].error"},
                            {&AgaaMeasuredSettings::geometryMilliseconds, "measured[1].geometryMilliseconds"},
                            {&AgaaMeasuredSettings::shadingMilliseconds, "measured[1].shadingMilliseconds"}})
        for (const float number : {nan, infinity, -1.0f})
            refused(AGAA_ERROR_OUT_OF_RANGE, n.name, [&](AgaaMeasuredSettings& m) { m.*n.member = number; });
    refused(AGAA_ERROR_OUT_OF_RANGE, "reserved", [](AgaaMeasuredSettings& m) { m.reserved = 1; });
    const AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT;
    refused(invalid, "table of choices", [](AgaaMeasuredSettings& m) { m.samples = 5; });
    refused(invalid, "table of choices", [](AgaaMeasuredSettings& m) { m.technique = nullptr; });
    refused(invalid, "element before it", [&](AgaaMeasuredSettings& m) { m = valid[0]; });
    refused(invalid, "times of some",
            [](AgaaMeasuredSettings& m) { m.geometryMilliseconds = m.shadingMilliseconds = 0; });
    refused(invalid, "pixels are 0", [](AgaaMeasuredSettings& m) { m.pixels = 0; });
    refused(invalid, "errorShare is 0", [](AgaaMeasuredSettings& m) { m.errorShare = 0; });
    host.goal.flags = AGAA_GOAL_PREDICT_OTHERS;
    refused(invalid, "times come from observations", [](AgaaMeasuredSettings&) {});
    host.goal.flags = 0;
    refused(AGAA_ERROR_STRUCT, "AgaaMeasuredSettings has sType", [](AgaaMeasuredSettings& m) { m.sType = 0; });
    host.goal.maxError = 0.1f;
    refused(invalid, "maxError is a limit", [](AgaaMeasuredSettings& m) { m.error = 0; });
    host.goal.measured = nullptr;
    EXPECT_EQ(host.choose(), invalid);
    EXPECT_NE(host.message.find("AgaaGoal::measured is null"), std::string::npos) << host.message;
}

// A frame whose geometry is not timed apart is twice as slow as a whole.
TEST(MeasuredGoals, TimesOfTheWholeFrameScaleWholeFrames) {
    HostOfThree host;
    host.goal.maxErrorShare = 0.25f;
    const AgaaObservation whole = timedFrame(rowNamed("single", 1), 0, 6); // measured: 1 and 2
    EXPECT_NEAR(host.freshMeasured(&whole).milliseconds, 20, 1e-4) << host.choice.reason;
}

// They are forgotten with what was observed before, so that a choice waits for 16 observations again.
TEST(MeasuredGoals, OneFrameAfterOtherMeasuredTimesChangesNothing) {
    HostOfThree host;
    const ChoiceRow& eight = rowNamed("ssaa", 8);
    host.goal.prefer = AGAA_PREFER_ERROR;
    host.goal.maxMilliseconds = 30;
    ASSERT_TRUE(isOf(host.freshMeasured(), eight)) << host.choice.reason;
    const AgaaObservation usual = timedFrame(eight, 4, 16), slow = timedFrame(eight, 8, 32);
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(host.chooseMeasured(&usual), AGAA_OK) << host.message;
    host.measured[2].geometryMilliseconds = 4.1f;
    ASSERT_EQ(host.chooseMeasured(&slow), AGAA_OK) << host.message;
    EXPECT_TRUE(isOf(host.choice, eight)) << host.choice.reason;
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(host.chooseMeasured(&slow), AGAA_OK) << host.message;
    EXPECT_FALSE(isOf(host.choice, eight)) << host.choice.reason;
}

// In whatever order the host names them, times are the same, and so is what was observed since.
TEST(MeasuredGoals, TheirOrderDoesNotMatter) {
    HostOfThree host;
    host.freshMeasured();
    const auto numbers = [&] {
        return std::vector<float>(std::begin(host.choice.memory), std::end(host.choice.memory));
    };
    const std::vector<float> before = numbers();
    std::swap(host.measured[0], host.measured[2]);
    host.freshMeasured();
    EXPECT_EQ(numbers(), before);
    host.measured[1].shadingMilliseconds *= 2;
    host.freshMeasured();
    EXPECT_NE(numbers(), before);
}

} // namespace
