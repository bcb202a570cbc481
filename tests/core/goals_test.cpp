// Settings for goals: limits, the nearest settings where there are none, lights, and that choices settle.
#include "goal_host.h"

#include "core/tuning/cost_model.h"
#include "core/view/technique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

using namespace agaa;
using namespace agaa::test;

namespace {

// Returns the shading events per covered pixel in a usual scene.
double eventsOf(const AgaaChoice& choice) {
    const ChoiceRow* row = rowOf(choice);
    return row->events + row->eventsByComplexity * usualTerms(AGAA_SCENE_FACTS_INIT).complexity;
}

// ---- the table -----------------------------------------------------------------------------------

TEST(GoalTable, RowsAreSettingsOfTechniques) {
    std::set<std::string> seen;
    for (const ChoiceRow& row : choiceRows()) {
        const Technique* technique = findTechnique(techniques(), row.technique);
        ASSERT_TRUE(technique) << row.technique;
        const bool coversSamples = row.tier == AGAA_TIER_FRAGMENT_LISTS || row.tier == AGAA_TIER_FRAGMENTS;
        EXPECT_LE(row.samples, coversSamples ? 128u : technique->maxSamples);
        EXPECT_EQ(row.aggregates > 0, technique->maxAggregates > 0);
        EXPECT_GT(row.geometryRatio + row.geometryTime, 0);
        for (const float share : row.errorShares)
            EXPECT_GT(share, 0);
        EXPECT_TRUE(seen.insert(std::string(row.technique) + "-" + std::to_string(row.samples) + "-" +
                                std::to_string(row.aggregates) + row.preset + std::to_string(row.tier))
                        .second);
    }
}

TEST(GoalTable, MoreShadowLookUpsTakeLonger) {
    for (const ChoiceRow& row : choiceRows()) {
        SceneTerms terms = usualTerms(AGAA_SCENE_FACTS_INIT);
        for (const double complexity : {0.0, 0.5, 1.0}) {
            terms.complexity = complexity;
            EXPECT_GE(tapsOf(row, complexity), 0.9) << "a covered pixel looks up at least one of its samples";
            const auto shading = [&](double shadows) {
                terms.shadows = shadows;
                return predictTimes(row, terms, 1).shading;
            };
            for (const double shadows : {0.0, 1.0, 3.0}) {
                const double lookUps = tapsOf(row, complexity) * terms.coverage; // of one more shadow
                EXPECT_GT(shading(shadows + 1) - shading(shadows), 1e-6 * lookUps)
                    << row.technique << ' ' << row.samples << ' ' << row.preset << ": a look-up takes 1 ns or more";
            }
        }
    }
}

TEST(GoalTable, QuantilesOfErrors) {
    for (const ChoiceRow& row : choiceRows()) {
        std::array<float, tableScenes> sorted = row.errorShares;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(errorShareIn(row, 0), sorted.front());
        EXPECT_EQ(errorShareIn(row, 0.5f), sorted[4]);
        EXPECT_EQ(errorShareIn(row, 0.8f), sorted[7]);
        EXPECT_EQ(errorShareIn(row, 0.81f), sorted[8]);
        EXPECT_EQ(errorShareIn(row, 1), sorted.back());
    }
}

// ---- limits --------------------------------------------------------------------------------------

TEST(Goals, ATighterErrorNeverChoosesALessAccurateView) {
    Host host;
    for (const float lights : {0.0f, 1.0f, 17.0f, 200.0f}) {
        const AgaaObservation frame = frameOfSingle(lights);
        float last = 2;
        std::set<std::string> chosen;
        for (float limit = 1; limit > 0.001f; limit *= 0.9f) {
            host.goal.maxErrorShare = limit;
            const AgaaChoice choice = host.fresh(&frame);
            EXPECT_LE(choice.errorShare, last) << choice.reason;
            EXPECT_EQ(choice.errorShare <= limit, choice.missedLimits == 0) << choice.reason;
            last = choice.errorShare;
            chosen.insert(std::string(choice.technique) + std::to_string(choice.samples));
        }
        EXPECT_GE(chosen.size(), 3u);
    }
}

TEST(Goals, AbsoluteErrorsAreThoseOfTheScenes) {
    Host host;
    host.goal.maxError = 2e-4f;
    const AgaaChoice choice = host.fresh();
    EXPECT_EQ(choice.missedLimits, 0u);
    EXPECT_LE(choice.error, 2e-4f);
    host.goal.sceneShare = 1;
    EXPECT_LE(host.fresh().error, 2e-4f);
    EXPECT_LE(host.fresh().errorShareWorst, choice.errorShareWorst);
}

TEST(Goals, BytesAreThoseOfThePlanner) {
    Host host;
    host.goal.prefer = AGAA_PREFER_ERROR;
    uint64_t last = ~UINT64_C(0);
    for (const uint64_t perPixel : {700u, 300u, 200u, 120u, 70u, 40u, 28u}) {
        host.goal.maxBytes = perPixel * 1280 * 720;
        const AgaaChoice choice = host.fresh();
        EXPECT_EQ(choice.missedLimits, 0u) << choice.reason;
        EXPECT_LE(choice.bytes, host.goal.maxBytes);
        EXPECT_LE(choice.bytes, last);
        last = choice.bytes;
        TechniqueConfig config = host.config;
        ASSERT_EQ(agaaApplyChoice(&choice, &config, &config.aggregation, &config.measurement), AGAA_OK);
        AgaaViewDesc view = host.view;
        view.config = &config;
        AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
        ASSERT_EQ(agaaQueryMemory(&view, &host.caps, nullptr, &report, nullptr, nullptr), AGAA_OK);
        EXPECT_EQ(report.totalBytes, choice.bytes) << choice.reason;
    }
}

TEST(Goals, ALimitOfTimeIsKeptByThePrediction) {
    Host host;
    host.goal.prefer = AGAA_PREFER_ERROR;
    const FrameTimes single = predictTimes(choiceRows()[0], usualTerms(host.facts), 1280 * 720);
    float last = 0;
    for (const double factor : {10.0, 4.0, 2.0, 1.5, 1.01}) {
        host.goal.maxMilliseconds = float(factor * (single.geometry + single.shading));
        const AgaaChoice choice = host.fresh();
        EXPECT_EQ(choice.missedLimits, 0u) << choice.reason;
        EXPECT_LE(choice.milliseconds, host.goal.maxMilliseconds) << choice.reason;
        EXPECT_GE(choice.errorShare, last);
        last = choice.errorShare;
    }
}

TEST(Goals, WhatCannotBeMetIsNamed) {
    Host host;
    host.goal.maxErrorShare = 1e-6f;
    AgaaChoice choice = host.fresh();
    EXPECT_EQ(choice.missedLimits, AGAA_LIMIT_ERROR_SHARE);
    EXPECT_NE(std::string(choice.reason).find("maxErrorShare"), std::string::npos) << choice.reason;
    for (const ChoiceRow& row : choiceRows()) // the nearest
        EXPECT_LE(choice.errorShare, errorShareIn(row, host.goal.sceneShare));
    host.goal.maxBytes = 1;
    host.goal.maxMilliseconds = 1e-6f;
    choice = host.fresh();
    EXPECT_EQ(choice.missedLimits, AGAA_LIMIT_ERROR_SHARE | AGAA_LIMIT_BYTES | AGAA_LIMIT_MILLISECONDS);
    EXPECT_NE(std::string(choice.reason).find("maxBytes"), std::string::npos) << choice.reason;
    EXPECT_STREQ(choice.technique, "single") << "has the fewest bytes";
}

// ---- lights --------------------------------------------------------------------------------------

TEST(Goals, MoreLightsChooseFewerEvents) {
    Host host;
    for (const float limit : {0.4f, 0.3f, 0.2f, 0.14f, 0.06f}) {
        host.goal.maxErrorShare = limit;
        std::vector<double> events;
        std::string names;
        for (const float lights : {1.0f, 8.0f, 64.0f, 1024.0f}) {
            const AgaaObservation frame = frameOfSingle(lights);
            events.push_back(eventsOf(host.fresh(&frame)));
            names += std::string(" ") + host.choice.technique + "-" + std::to_string(host.choice.samples);
            if (events.size() > 1) {
                EXPECT_LE(events.back(), events[events.size() - 2]) << host.choice.reason;
            }
        }
        std::printf("%.2f:%s\n", double(limit), names.c_str());
        EXPECT_LT(events.back(), events.front()) << limit;
    }
}

// An engine with one light measured 98 ms with "ssaa", 113 ms with "agaa" c=2 and 73 ms with its preset "fast", from a
// G-buffer. The first two determine the share of the geometry in its frames, which the third follows from.
TEST(Goals, OneLightHasTheOrderThatAnEngineMeasured) {
    const auto times = [](const char* technique, uint32_t aggregates, const char* preset, AgaaTier tier) {
        for (const ChoiceRow& row : choiceRows())
            if (std::strcmp(row.technique, technique) == 0 && row.samples == 8 && row.aggregates == aggregates &&
                std::strcmp(row.preset, preset) == 0 && row.tier == tier) {
                SceneTerms terms = usualTerms(AGAA_SCENE_FACTS_INIT);
                terms.lights = 1;
                return predictTimes(row, terms, 1);
            }
        throw std::logic_error("no row");
    };
    const FrameTimes ssaa = times("ssaa", 0, "", AGAA_TIER_AUTO), agaa = times("agaa", 2, "", AGAA_TIER_GBUFFER),
                     fast = times("agaa", 1, "fast", AGAA_TIER_GBUFFER);
    // scale * agaa.geometry + agaa.shading = 113 / 98 * (scale * ssaa.geometry + ssaa.shading)
    const double measured = 113.0 / 98;
    const double scale = (agaa.shading - measured * ssaa.shading) / (measured * ssaa.geometry - agaa.geometry);
    EXPECT_GT(scale, 0.1);
    EXPECT_LT(scale, 10);
    EXPECT_NEAR((scale * fast.geometry + fast.shading) / (scale * ssaa.geometry + ssaa.shading), 73.0 / 98, 0.15);
}

// ---- what a host allows --------------------------------------------------------------------------

TEST(Goals, SettingsThatCannotBePlannedAreLeftOut) {
    Host host;
    host.goal.maxErrorShare = 0.02f;
    const uint32_t all = host.fresh().leftOut;
    host.view.pNext = nullptr; // nothing fetches materials by id
    const AgaaChoice choice = host.fresh();
    EXPECT_GT(choice.leftOut, all);
    EXPECT_NE(choice.generationTier, uint32_t(AGAA_TIER_IDS));
    host.goal.flags = AGAA_GOAL_ONE_GEOMETRY_PASS;
    EXPECT_GT(host.fresh().leftOut, choice.leftOut);
    host.caps.maxImageSize = 1;
    EXPECT_EQ(host.choose(), AGAA_ERROR_UNSUPPORTED);
    EXPECT_FALSE(host.message.empty());
}

// A pattern of the host is for the described number of coverage samples alone, of which the table has no row.
TEST(Goals, PatternsOfOtherNumbersAreLeftOut) {
    Host host;
    AgaaDecoupledCoverage coverage = AGAA_DECOUPLED_COVERAGE_INIT;
    const std::vector<float> positions(2 * 32, 0.5f);
    coverage.samplePositions = positions.data();
    host.config.technique = "dcaa";
    host.config.samples = 32;
    host.config.pNext = &coverage;
    host.goal.maxErrorShare = 0.02f;
    const uint32_t withPattern = host.fresh().leftOut;
    coverage.samplePositions = nullptr;
    EXPECT_GT(withPattern, host.fresh().leftOut);
}

TEST(Goals, SettingsOfTheViewThatAChoiceSetsDoNotCount) {
    Host host;
    host.goal.maxErrorShare = 0.1f;
    const AgaaChoice plain = host.fresh();
    host.config.technique = "agaa";
    ASSERT_EQ(host.config.applyPreset("accurate"), AGAA_OK);
    host.config.generationTier = AGAA_TIER_GBUFFER;
    EXPECT_TRUE(isSame(plain, host.fresh()));
    EXPECT_EQ(plain.bytes, host.choice.bytes);
}

// ---- observations --------------------------------------------------------------------------------

TEST(Goals, AnObservationIsReadFromStatistics) {
    Host host;
    host.config.technique = "agaa";
    host.config.applyPreset("balanced");
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    statistics.counters.visible = 8 * 1280 * 720 / 4;
    statistics.counters.shadingEvents = 1280 * 720 / 2;
    statistics.counters.lightEvaluations = 3 * 1280 * 720 / 2;
    statistics.passCount = 3;
    for (const auto& [i, stage] : {std::pair{0, AGAA_STAGE_PREPASS}, {1, AGAA_STAGE_SHADING}, {2, AGAA_STAGE_OTHER}})
        statistics.passes[i] = {"", uint32_t(stage), 1, 1.5 * (i + 1), {0, 0}};
    AgaaObservation o = AGAA_OBSERVATION_INIT;
    ASSERT_EQ(agaaObserve(&host.view, &host.caps, nullptr, &statistics, &o), AGAA_OK);
    EXPECT_EQ(o.flags, AGAA_OBSERVED_COUNTS | AGAA_OBSERVED_TIMES);
    EXPECT_STREQ(o.preset, "balanced");
    EXPECT_EQ(o.generationTier, uint32_t(AGAA_TIER_IDS));
    EXPECT_EQ(o.coverage, 0.25f);
    EXPECT_EQ(o.eventsPerPixel, 0.5f);
    EXPECT_EQ(o.lightsPerEvent, 3.0f);
    EXPECT_EQ(o.geometryMilliseconds, 1.5f);
    EXPECT_EQ(o.shadingMilliseconds, 7.5f);
    statistics.passes[1].isTimed = 0; // then no time is the frame's
    AgaaObservation untimed = AGAA_OBSERVATION_INIT;
    ASSERT_EQ(agaaObserve(&host.view, &host.caps, nullptr, &statistics, &untimed), AGAA_OK);
    EXPECT_EQ(untimed.flags, AGAA_OBSERVED_COUNTS);
}

// Sums of counters that no frame has still make an observation that a choice accepts.
TEST(Goals, ObservationsStayInTheirRanges) {
    Host host;
    host.config.technique = "single";
    host.config.samples = 1;
    for (const uint64_t events : {uint64_t(1), UINT64_C(1) << 32, ~UINT64_C(0)})
        for (const uint64_t others : {uint64_t(0), UINT64_C(1) << 32, ~UINT64_C(0)}) {
            AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
            statistics.counters.shadingEvents = events;
            statistics.counters.visible = statistics.counters.lightEvaluations = statistics.counters.shadowTaps =
                others;
            AgaaObservation o = AGAA_OBSERVATION_INIT;
            ASSERT_EQ(agaaObserve(&host.view, &host.caps, nullptr, &statistics, &o), AGAA_OK);
            EXPECT_EQ(host.choose(&o), AGAA_OK) << events << ' ' << others << ": " << host.message;
        }
}

TEST(Goals, TimesOfTheDeviceScalePredictions) {
    Host host;
    AgaaObservation frame = frameOfSingle(17);
    host.goal.maxErrorShare = 0.14f;
    const AgaaChoice table = host.fresh(&frame);
    EXPECT_EQ(table.hasTimes, 0u);
    const FrameTimes times =
        predictTimes(choiceRows()[0], {0.6, usualTerms(host.facts).complexity, 17, 1}, frame.pixels);
    frame.flags |= AGAA_OBSERVED_TIMES;
    frame.geometryMilliseconds = float(times.geometry / 100);
    frame.shadingMilliseconds = float(times.shading / 100);
    const AgaaChoice device = host.fresh(&frame);
    EXPECT_EQ(device.hasTimes, 1u);
    EXPECT_TRUE(isSame(table, device));
    EXPECT_NEAR(device.milliseconds, table.milliseconds / 100, 1e-3f * table.milliseconds);
}

// A scene with its own times of all settings: the table's, off by up to 30 %, on a device that is as much faster as
// lets "single" take 7 ms.
class Device {
public:
    explicit Device(uint32_t seed, double noise) : random_(seed), noise_(noise) {
        std::uniform_real_distribution<double> off(0.7, 1.3);
        for (size_t i = 0; i < 2 * choiceRows().size(); ++i)
            errors_.push_back(off(random_));
    }

    double milliseconds(const AgaaChoice& choice) const { return times(choice).geometry + times(choice).shading; }

    AgaaObservation frame(const AgaaChoice& choice) {
        AgaaObservation o = frameOfSingle(6);
        std::uniform_real_distribution<double> noise(1 - noise_, 1 + noise_);
        o.flags |= AGAA_OBSERVED_TIMES;
        o.technique = choice.technique;
        o.preset = choice.preset;
        o.samples = choice.samples;
        o.aggregates = choice.aggregates;
        o.generationTier = choice.generationTier;
        const ChoiceRow& row = *rowOf(choice);
        o.eventsPerPixel = float(0.6 * (row.events + row.eventsByComplexity * 0.4) * noise(random_));
        o.lightsPerEvent = float(6 * row.lightRatio * noise(random_));
        o.geometryMilliseconds = float(times(choice).geometry * noise(random_));
        o.shadingMilliseconds = float(times(choice).shading * noise(random_));
        return o;
    }

private:
    FrameTimes times(const AgaaChoice& choice) const {
        const ChoiceRow& row = *rowOf(choice);
        const auto i = size_t(&row - choiceRows().data());
        FrameTimes times = predictTimes(row, {0.6, 0.4, 6, 1}, 1280 * 720);
        const FrameTimes single = predictTimes(choiceRows()[0], {0.6, 0.4, 6, 1}, 1280 * 720);
        const double scale = 7 / (single.geometry + single.shading);
        return {times.geometry * errors_[2 * i] * scale, times.shading * errors_[2 * i + 1] * scale};
    }

    std::mt19937 random_;
    double noise_;
    std::vector<double> errors_;
};

// Times that spread by 20 % over hundreds of frames, on devices for which the table is wrong by up to 30 %.
TEST(Goals, ChoicesSettleUnderNoise) {
    int changes = 0, runs = 0, lateRuns = 0;
    for (uint32_t seed = 0; seed < 12; ++seed)
        for (const float limit : {8.0f, 14.0f, 25.0f, 45.0f})
            for (const AgaaPreference preference : {AGAA_PREFER_ERROR, AGAA_PREFER_TIME}) {
                Host host;
                Device device(seed, 0.2);
                host.goal.prefer = preference;
                host.goal.maxMilliseconds = limit;
                host.goal.maxErrorShare = preference == AGAA_PREFER_TIME ? 0.3f : 0.0f;
                ASSERT_EQ(host.choose(), AGAA_OK);
                int late = 0, own = 0;
                std::set<const ChoiceRow*> tried = {rowOf(host.choice)};
                for (int frame = 0; frame < 600; ++frame) {
                    const AgaaObservation o = device.frame(host.choice);
                    ASSERT_EQ(host.choose(&o), AGAA_OK) << host.message;
                    own += int(host.choice.hasChanged);
                    tried.insert(rowOf(host.choice));
                    late += frame >= 400 && host.choice.hasChanged;
                }
                ++runs;
                changes += own;
                lateRuns += late > 0;
                EXPECT_LE(own, 10) << "seed " << seed << ", limit " << limit << ": " << host.choice.reason;
                // Settings that turn out too slow are left for those before them, once each.
                EXPECT_LE(own, 2 * (int(tried.size()) - 1)) << "choices alternate: " << host.choice.reason;
                EXPECT_LE(late, 1) << "seed " << seed << ", limit " << limit << ": " << host.choice.reason;
                if (!host.choice.missedLimits) {
                    EXPECT_LE(device.milliseconds(host.choice), 1.15 * limit) << host.choice.reason;
                }
            }
    EXPECT_LE(lateRuns, runs / 50); // of two settings that lie a margin apart, noise may show the better one late
    EXPECT_LE(changes, 3 * runs);
    EXPECT_GE(changes, runs / 2) << "no run had a reason to change";
}

TEST(Goals, ACurrentChoiceStaysWithinTheMargin) {
    Host host;
    host.goal.prefer = AGAA_PREFER_ERROR;
    Device device(1, 0);
    host.goal.maxMilliseconds = 30;
    ASSERT_EQ(host.choose(), AGAA_OK);
    for (int frame = 0; frame < 200; ++frame) {
        const AgaaObservation o = device.frame(host.choice);
        ASSERT_EQ(host.choose(&o), AGAA_OK);
    }
    const AgaaChoice settled = host.choice;
    const auto at = [&](double limit) {
        host.choice = settled;
        host.goal.maxMilliseconds = float(limit);
        const AgaaObservation o = device.frame(settled);
        EXPECT_EQ(host.choose(&o), AGAA_OK);
        return host.choice.hasChanged;
    };
    const double time = device.milliseconds(settled);
    EXPECT_EQ(at(time / 1.05), 0u) << host.choice.reason; // misses by 5 %
    EXPECT_EQ(at(time / 1.2), 1u) << host.choice.reason;
    EXPECT_LE(host.choice.milliseconds, 0.9 * time / 1.2);
}

// ---- errors --------------------------------------------------------------------------------------

TEST(Goals, ApplyingAChoiceMakesItsView) {
    Host host;
    host.view.width = 640; // all settings fit the device
    for (const ChoiceRow& row : choiceRows()) {
        AgaaChoice choice = AGAA_CHOICE_INIT;
        choice.technique = row.technique;
        choice.preset = *row.preset ? row.preset : nullptr;
        choice.samples = row.samples;
        choice.aggregates = row.aggregates;
        choice.generationTier = row.tier;
        TechniqueConfig config;
        config.applyPreset("paper"); // of a view before
        ASSERT_EQ(agaaApplyChoice(&choice, &config, &config.aggregation, &config.measurement), AGAA_OK);
        AgaaViewDesc view = host.view;
        view.config = &config;
        const AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        AgaaObservation o = AGAA_OBSERVATION_INIT;
        ASSERT_EQ(agaaObserve(&view, &host.caps, nullptr, &statistics, &o), AGAA_OK);
        EXPECT_STREQ(o.technique, row.technique);
        EXPECT_EQ(std::string(o.preset ? o.preset : ""), row.preset);
        EXPECT_EQ(o.samples, row.samples);
        EXPECT_EQ(o.aggregates, row.aggregates);
        EXPECT_EQ(o.generationTier, uint32_t(row.tier));
    }
}

} // namespace
