// Tests of the rows of a sweep: every technique and n, no row twice, unique file names.
#include "sweep/rows.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace harness {
namespace {

TEST(SweepRows, NoRowTwice) {
    for (bool quick : {false, true}) {
        std::set<std::string> names;
        for (const SweepRow& row : sweepRows(quick))
            EXPECT_TRUE(names.insert(row.name()).second) << row.name();
    }
}

TEST(SweepRows, AreFoundByName) {
    for (const SweepRow& row : sweepRows(false)) {
        const auto found = namedSweepRows({row.name()});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].name(), row.name());
    }
    EXPECT_THROW(namedSweepRows({"agaa-8-2", "agaa-8-2"}), std::invalid_argument);
    EXPECT_THROW(namedSweepRows({"agaa"}), std::invalid_argument);
    EXPECT_TRUE(namedSweepRows({}).empty());
}

TEST(SweepRows, EveryTechniqueIsThere) {
    uint32_t count = 0;
    ASSERT_EQ(agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, nullptr), AGAA_OK);
    std::vector<const char*> names(count);
    ASSERT_EQ(agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, names.data()), AGAA_OK);
    for (bool quick : {false, true})
        for (const char* name : names) {
            bool found = false;
            for (const SweepRow& row : sweepRows(quick))
                found |= row.technique == name;
            EXPECT_TRUE(found) << name;
        }
}

// Rows with errors against ssaa at the same n are compared with its times.
TEST(SweepRows, SupersamplingIsThereAtEveryN) {
    for (bool quick : {false, true}) {
        std::set<uint32_t> wanted, there;
        for (const SweepRow& row : sweepRows(quick))
            if (row.samples <= 32) // beyond, n counts coverage samples
                (row.technique == "ssaa" ? there : wanted).insert(row.samples);
        wanted.erase(1);
        for (uint32_t n : wanted)
            EXPECT_TRUE(there.contains(n)) << n;
    }
}

TEST(SweepRows, PlansCanBeMade) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    for (const SweepRow& row : sweepRows(false)) {
        TechniqueConfig config;
        row.apply(config);
        AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
        view.width = 64;
        view.height = 36;
        view.config = &config;
        view.facts = &facts;
        AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
        fetch.glsl = "";
        fetch.maxDraws = fetch.maxPrimitives = 1;
        if (config.fetches())
            view.pNext = &fetch;
        size_t size = 0;
        EXPECT_EQ(agaaPlanToJson(&view, nullptr, nullptr, &size, nullptr), AGAA_OK) << row.name();
    }
}

TEST(SweepEffects, AreCalledForByScenesThatHaveThem) {
    Scene scene;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = 0;
    facts.shadowMapCount = 0;
    const std::set<std::string> ofAnyScene = {"filtered-diffuse", "more-aggregates", "maximin-seeds", "fused"};
    for (const SweepEffect& effect : sweepEffects())
        EXPECT_EQ(isCalledFor(effect, scene, facts), ofAnyScene.contains(effect.name)) << effect.name;
    scene.materials.emplace_back();
    scene.materials[0].normalTexture = 0;
    facts.flags = AGAA_FACT_ALL_SHADED;
    facts.shadowMapCount = 1;
    for (const SweepEffect& effect : sweepEffects())
        EXPECT_TRUE(isCalledFor(effect, scene, facts)) << effect.name;
}

TEST(SweepEffects, AreSwitchedOffByWhatTheyName) {
    std::map<std::string, TechniqueConfig> off;
    for (const SweepEffect& effect : sweepEffects()) {
        TechniqueConfig config;
        effect.row.apply(config);
        if (effect.off)
            effect.off(config);
        EXPECT_TRUE(effect.off || effect.fact || effect.ofNormalMaps) << effect.name;
        off[effect.name] = config;
    }
    TechniqueConfig accurate;
    accurate.applyPreset("accurate");
    EXPECT_TRUE(off["shadow-filter"].measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER);
    EXPECT_TRUE(off["filtered-diffuse"].measurement.flags & AGAA_MEASURE_NO_DIFFUSE_FILTER);
    EXPECT_EQ(off["ndf-widening"].ndf, uint32_t(AGAA_NDF_NONE));
    EXPECT_EQ(off["lit-aggregates"].aggregation.litShadows, 0u);
    EXPECT_EQ(off["lit-aggregates"].ndf, accurate.ndf);
    EXPECT_EQ(off["elliptic-lobes"].ndf, uint32_t(AGAA_NDF_TOKSVIG));
    EXPECT_EQ(off["elliptic-lobes"].aggregation.litShadows, accurate.aggregation.litShadows);
    EXPECT_EQ(off["gloss-weight"].aggregation.glossWeight, 0.0f);
    EXPECT_EQ(off["more-aggregates"].aggregates, 2u);
    EXPECT_EQ(off["maximin-seeds"].measurement.seeds, uint32_t(AGAA_SEEDS_SUM_OF_SQUARES));
    EXPECT_TRUE(off["fused"].flags & AGAA_CONFIG_BUFFERED);
    EXPECT_EQ(off["fused"].generationTier, uint32_t(AGAA_TIER_IDS));
}

} // namespace
} // namespace harness
