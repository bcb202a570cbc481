// Whole-frame scenes of hard cases: the covering set, and what fails a frame.
#include "hard/run.h"
#include "scene/builtin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace harness::hard {
namespace {

template <class Row> std::vector<size_t> indicesOf(const std::vector<Row>& rows) {
    std::vector<size_t> indices(rows.size());
    std::iota(indices.begin(), indices.end(), size_t(0));
    return indices;
}

std::vector<HardJob> everyJob() {
    return allJobs(indicesOf(hardFrames()), indicesOf(hardConfigurations()), {"vk", "gl"});
}

std::set<std::string> valuesOf(const std::vector<HardJob>& jobs) {
    std::set<std::string> values;
    for (const HardJob& job : jobs) {
        const HardConfiguration& c = hardConfigurations()[job.configuration];
        values.insert({c.technique + " " + job.backend, c.technique + " n=" + std::to_string(c.samples),
                       c.technique + " c=" + std::to_string(c.aggregates),
                       c.technique + " tier=" + std::to_string(c.generationTier)});
        const HardFrame& frame = hardFrames()[job.frame];
        if (!frame.isFor) // a frame of one technique is rendered once
            values.insert(frame.name + std::string(" ") + job.backend);
        if (c.isAccurate)
            values.insert("accurate");
    }
    return values;
}

TEST(HardScenes, CoveringSetHasEachPairOnceAndEachValue) {
    const std::vector<HardJob> all = everyJob();
    const std::vector<HardJob> chosen = coveringJobs(all, 1);
    const auto pairsOf = [](const std::vector<HardJob>& jobs) {
        std::map<std::pair<size_t, std::string>, size_t> pairs;
        for (const HardJob& job : jobs)
            ++pairs[{job.frame, hardConfigurations()[job.configuration].technique}];
        return pairs;
    };
    const auto pairs = pairsOf(chosen);
    EXPECT_EQ(pairs.size(), pairsOf(all).size());
    for (const auto& [pair, count] : pairs)
        EXPECT_EQ(count, 1u) << hardFrames()[pair.first].name << " " << pair.second;
    EXPECT_EQ(valuesOf(chosen), valuesOf(all));
    EXPECT_LT(chosen.size(), all.size() / 30);
}

TEST(HardScenes, FramesHaveScenesAndConfigurationsAreDistinct) {
    std::set<std::string> names;
    for (const HardFrame& frame : hardFrames()) {
        EXPECT_TRUE(names.insert(frame.name).second) << frame.name;
        EXPECT_TRUE(makeBuiltinScene(frame.scene)) << frame.scene;
        EXPECT_EQ(bool(frame.check), frame.checked != nullptr) << frame.name;
    }
    std::set<std::string> configurations;
    for (const HardConfiguration& configuration : hardConfigurations())
        EXPECT_TRUE(configurations.insert(configuration.name()).second) << configuration.name();
}

TEST(HardScenes, EachExcessFailsAFrame) {
    HardResult good;
    good.mseTm = good.maxMseTm = 1e-3;
    good.meanError = good.maxMeanError = 1e-2;
    good.finding = Finding{1, 1};
    EXPECT_TRUE(good.isWithin());
    const auto expectExcess = [&good](const char* phrase, const auto& change) {
        HardResult bad = good;
        change(bad);
        EXPECT_EQ(bad.excess(), phrase);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expectExcess("error", [](HardResult& r) { r.mseTm = 1.001e-3; });
    expectExcess("error", [=](HardResult& r) { r.mseTm = nan; });
    expectExcess("mean", [](HardResult& r) { r.meanError = 0.011; });
    expectExcess("mean", [=](HardResult& r) { r.meanError = nan; });
    expectExcess("check", [](HardResult& r) { r.finding->value = 1.01; });
    expectExcess("check", [=](HardResult& r) { r.finding->value = nan; });
    expectExcess("non-finite pixels", [](HardResult& r) { r.nonFinite = 1; });
    expectExcess("sanitised materials", [](HardResult& r) { r.sanitised = 1; });
    expectExcess("lost fragments", [](HardResult& r) { r.lostFragments = 1; });
    expectExcess("The device is lost.", [](HardResult& r) { r.failure = "The device is lost."; });
}

} // namespace
} // namespace harness::hard
