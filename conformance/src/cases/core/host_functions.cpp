// Functions of the host and debug views: the techniques and structs that they exclude.
#include "cases.h"
#include "structs.h"
#include "view_parts.h"

#include <set>

namespace agaa::conformance {

namespace {

using Change = std::function<void(ViewParts&)>;

// All techniques accept the function, except those in `refusing`.
void testNotFor(Test& test, const std::set<std::string>& refusing, const std::string& name, const Change& chain) {
    for (const char* technique : allTechniques) {
        ViewParts parts(test.sdk, nullptr);
        parts.facts.shadowMapCount = 1;
        parts.setTechnique(technique, 4);
        chain(parts);
        const std::string what = std::string("\"") + technique + "\" and an " + name;
        if (refusing.count(technique))
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what,
                              technique == std::string("msaa") ? name : "G-buffer");
        else
            expectAccepted(test, parts, what);
    }
}

void testGBufferTiers(Test& test) {
    for (const char* technique : {"sbaa", "agaa"}) {
        ViewParts parts(test.sdk, nullptr);
        parts.config.technique = technique;
        parts.chain(parts.gbuffer);
        const std::string tier = generationTierOf(test, parts);
        test.check(tier == "gbuffer",
                   std::string("\"") + technique + "\" with an AgaaGBufferFunction uses the tier " + tier + ".");
        AgaaTarget target = AGAA_TARGET_INIT;
        test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, nullptr, &target), "agaaQueryTarget");
        test.check(target.geometryPasses == 0, "agaaQueryTarget with an AgaaGBufferFunction counts geometry passes.");
    }
}

void testTwoSources(Test& test) {
    for (const bool isFetchFirst : {false, true}) {
        ViewParts parts(test.sdk, nullptr);
        if (isFetchFirst) {
            parts.chain(parts.fetch);
            parts.chain(parts.gbuffer);
        } else {
            parts.chain(parts.gbuffer);
            parts.chain(parts.fetch);
        }
        expectViewRefused(test, parts, AGAA_ERROR_INVALID_ARGUMENT, "an AgaaGBufferFunction and an AgaaFetchFunction",
                          "AgaaGBufferFunction");
    }
}

void testNotAllDraws(Test& test) {
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_IDS})
        for (const uint64_t flags : {UINT64_C(0), AGAA_CONFIG_BUFFERED}) {
            ViewParts parts(test.sdk, nullptr);
            parts.chain(parts.fetch);
            parts.fetch.flags = AGAA_FETCH_NOT_ALL_DRAWS;
            parts.config.generationTier = tier;
            parts.config.flags |= flags;
            expectAccepted(test, parts, "AGAA_FETCH_NOT_ALL_DRAWS");
            parts.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED,
                              "AGAA_FETCH_NOT_ALL_DRAWS and AGAA_FACT_CUSTOM_DEPTH", "AGAA_FETCH_NOT_ALL_DRAWS");
        }
}

// AUTO selects the tier if n exceeds the sample counts of devices.
void testFragments(Test& test) {
    for (const uint32_t samples : {32u, 64u, 128u})
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENTS}) {
            ViewParts parts(test.sdk, nullptr);
            parts.config.samples = samples;
            parts.config.generationTier = tier;
            if (tier == AGAA_TIER_FRAGMENTS || samples > 32)
                expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED,
                                  "the tier FRAGMENTS without an AgaaFetchFunction", "AgaaFetchFunction");
            parts.chain(parts.fetch);
            const std::string found = generationTierOf(test, parts);
            const uint32_t expected = samples > 32 ? uint32_t(AGAA_TIER_FRAGMENTS)
                                      : tier       ? tier
                                                   : uint32_t(AGAA_TIER_IDS);
            test.check(found == test.sdk.agaaTierName(expected), "\"agaa\" with n = " + std::to_string(samples) +
                                                                     " and generationTier = " + std::to_string(tier) +
                                                                     " uses the tier " + found + ".");
            if (expected != AGAA_TIER_FRAGMENTS)
                continue;
            parts.fetch.flags = AGAA_FETCH_NOT_ALL_DRAWS;
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, "the tier FRAGMENTS and AGAA_FETCH_NOT_ALL_DRAWS",
                              "AGAA_FETCH_NOT_ALL_DRAWS");
            parts.fetch.flags = 0;
            parts.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, "the tier FRAGMENTS and AGAA_FACT_CUSTOM_DEPTH",
                              "depth");
        }
}

// Lists hold the fragments of all draws. If some draws cannot be fetched, fragments carry their materials.
void testFragmentLists(Test& test) {
    const auto expectTier = [&](const ViewParts& parts, uint32_t tier, const std::string& what) {
        const std::string found = generationTierOf(test, parts);
        test.check(found == test.sdk.agaaTierName(tier), what + " uses the tier " + found + ".");
    };
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique("dcaa", 4);
        parts.config.generationTier = tier;
        const std::string what = "\"dcaa\" with generationTier = " + std::to_string(tier);
        expectTier(parts, tier == AGAA_TIER_AUTO ? uint32_t(AGAA_TIER_FRAGMENT_LISTS) : tier, what);
        parts.sceneFetch.flags = AGAA_FETCH_NOT_ALL_DRAWS;
        if (tier == AGAA_TIER_FRAGMENT_LISTS)
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what + " and AGAA_FETCH_NOT_ALL_DRAWS",
                              "AGAA_FETCH_NOT_ALL_DRAWS");
        else
            expectTier(parts, AGAA_TIER_MATERIAL_LISTS, what + " and AGAA_FETCH_NOT_ALL_DRAWS");
        parts.desc.pNext = nullptr;
        if (tier == AGAA_TIER_FRAGMENT_LISTS)
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what + " without an AgaaFetchFunction",
                              "AgaaFetchFunction");
        else
            expectTier(parts, AGAA_TIER_MATERIAL_LISTS, what + " without an AgaaFetchFunction");
    }
}

void testAutoSelectsIds(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    parts.chain(parts.fetch);
    const std::string tier = generationTierOf(test, parts);
    test.check(tier == "ids", "\"agaa\" with an AgaaFetchFunction and the tier AUTO uses the tier " + tier + ".");
    ViewParts without(test.sdk, nullptr);
    without.config.generationTier = AGAA_TIER_IDS;
    expectViewRefused(test, without, AGAA_ERROR_UNSUPPORTED, "the tier IDS without an AgaaFetchFunction",
                      "AgaaFetchFunction");
}

// Tests the bits of the shadows that the function answers for.
void testShadowBits(Test& test) {
    struct Row {
        uint32_t maps, bits;
        bool isAccepted;
    };
    for (const Row& row :
         {Row{1, 1, true}, Row{4, 0xF, true}, Row{4, 8, true}, Row{4, 16, false}, Row{1, 0x80000000u, false}}) {
        ViewParts parts(test.sdk, nullptr);
        parts.facts.shadowMapCount = row.maps;
        parts.chain(parts.shadow);
        parts.shadow.shadows = row.bits;
        const std::string what = "AgaaShadowFunction::shadows = " + std::to_string(row.bits) + " and " +
                                 std::to_string(row.maps) + " shadow maps";
        if (row.isAccepted)
            expectAccepted(test, parts, what);
        else
            expectViewRefused(test, parts, AGAA_ERROR_OUT_OF_RANGE, what, "shadows");
    }
}

// Functions that look shadows up over footprints cannot tell the samples that light reaches.
void testFootprints(Test& test) {
    for (const uint32_t lit : {0u, 1u, 2u}) {
        ViewParts parts(test.sdk, nullptr);
        parts.config.generationTier = AGAA_TIER_GBUFFER;
        parts.facts.shadowMapCount = 2;
        parts.chain(parts.shadow);
        parts.shadow.shadows = 3;
        parts.shadow.footprints = 2;
        parts.aggregation.litShadows = lit;
        if (lit == 2)
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, "litShadows of a footprint", "footprints");
        else
            expectAccepted(test, parts, "footprints of a shadow");
    }
}

// ---- lanes ---------------------------------------------------------------------------------------

void testLanes(Test& test) {
    for (const char* technique : {"agaa", "sbaa"}) {
        ViewParts parts(test.sdk, nullptr);
        parts.config.technique = technique;
        parts.config.samples = 8;
        parts.config.generationTier = AGAA_TIER_GBUFFER;
        parts.measurement.lanes = AGAA_LANES_SAMPLE_SUBGROUP;
        parts.caps.subgroupSize = 8;
        const std::string what = std::string(technique) + " with AGAA_LANES_SAMPLE_SUBGROUP and subgroupSize = ";
        expectAccepted(test, parts, what + "8");
        for (const uint32_t size : {0u, 4u, 128u}) {
            parts.caps.subgroupSize = size;
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what + std::to_string(size), "lanes");
        }
    }
}

// ---- debug views ---------------------------------------------------------------------------------

struct DebugRow {
    std::string what;
    bool isAccepted;
    uint32_t view;
    Change change;
};

void testDebugRows(Test& test, const std::vector<DebugRow>& rows) {
    for (const DebugRow& row : rows) {
        ViewParts parts(test.sdk, nullptr);
        parts.measurement.debugView = row.view;
        row.change(parts);
        const std::string what = "AgaaMeasurement::debugView = " + std::to_string(row.view) + " and " + row.what;
        if (row.isAccepted)
            expectAccepted(test, parts, what);
        else
            expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what, "debugView");
    }
}

Change technique(const char* name) {
    return [=](ViewParts& p) { p.setTechnique(name, 4); };
}

Change tierOf(uint32_t tier, uint64_t flags) {
    return [=](ViewParts& p) {
        p.config.generationTier = tier;
        p.config.flags |= flags;
        p.chain(p.fetch);
    };
}

void testDebugViews(Test& test) {
    std::vector<DebugRow> rows;
    for (uint32_t view = AGAA_DEBUG_VIEW_EVENTS; view <= AGAA_DEBUG_VIEW_TIER; ++view)
        rows.push_back({"\"msaa\"", false, view, technique("msaa")});
    for (const uint32_t view : {AGAA_DEBUG_VIEW_AGGREGATES, AGAA_DEBUG_VIEW_CLUSTERS, AGAA_DEBUG_VIEW_WIDENED}) {
        for (const char* name : {"single", "fxaa", "ssaa", "simple_complex"})
            rows.push_back({std::string("\"") + name + "\"", false, view, technique(name)});
        rows.push_back({"\"sbaa\"", true, view, technique("sbaa")});
        rows.push_back({"\"agaa\"", true, view, technique("agaa")});
        rows.push_back({"\"dcaa\"", true, view, technique("dcaa")});
    }
    const uint32_t primitives = AGAA_DEBUG_VIEW_PRIMITIVES;
    rows.push_back({"the tier IDS", true, primitives, tierOf(AGAA_TIER_IDS, 0)});
    rows.push_back({"the tier IDS and BUFFERED", false, primitives, tierOf(AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED)});
    rows.push_back({"the tier GBUFFER", false, primitives, tierOf(AGAA_TIER_GBUFFER, 0)});
    rows.push_back({"the tier POST_DEPTH_ATOMICS", false, primitives, tierOf(AGAA_TIER_POST_DEPTH_ATOMICS, 0)});
    for (const char* name : {"single", "fxaa", "ssaa", "simple_complex", "sbaa", "dcaa", "sgbc", "adaptive"})
        rows.push_back({std::string("\"") + name + "\"", false, primitives, technique(name)});
    testDebugRows(test, rows);
}

// Layouts that do not store roughness.
void testWidened(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    test.requireOk(test.sdk.agaaGetBuiltinLayout("paper16", &parts.layout), "agaaGetBuiltinLayout(\"paper16\")");
    const AgaaLayout paper = parts.layout;
    const Change folded = [paper](ViewParts& p) {
        p.layout = paper;
        p.useLayout();
    };
    testDebugRows(test, {{"a layout with folded roughness", false, AGAA_DEBUG_VIEW_WIDENED, folded},
                         {"a layout with folded roughness", true, AGAA_DEBUG_VIEW_CLUSTERS, folded}});
}

Change resolves(uint32_t value) {
    return [value](ViewParts& p) {
        p.outputs.outputs[0].value = value;
        p.chain(p.outputs);
    };
}

// A view whose layout has the attribute `velocity`.
void testNameOfAttribute(Test& test) {
    for (const bool isKnown : {true, false}) {
        ViewParts parts(test.sdk, nullptr);
        AgaaLayoutAttribute velocity = AGAA_LAYOUT_ATTRIBUTE_INIT;
        velocity.semantic = AGAA_SEMANTIC_CUSTOM;
        velocity.channels = 2;
        velocity.sampleBits = 16;
        velocity.name = "velocity";
        parts.layout.attributes[parts.layout.attributeCount++] = velocity;
        parts.useLayout();
        resolves(AGAA_RESOLVED_CUSTOM)(parts);
        parts.outputs.outputs[0].attribute = isKnown ? "velocity" : "speed";
        if (isKnown)
            expectAccepted(test, parts, "an output of a custom attribute");
        else
            expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, "an output of an attribute that the layout lacks",
                              "speed");
    }
}

} // namespace

void addHostFunctionCases(Suite& suite) {
    suite.core("AgaaResolvedOutputs.techniques",
               [](Test& test) { testNotFor(test, {}, "AgaaResolvedOutputs", resolves(AGAA_RESOLVED_NORMAL)); });
    suite.core("AgaaResolvedOutput.attribute/AGAA_ERROR_LAYOUT", testNameOfAttribute);
    suite.core("AgaaGBufferFunction/AGAA_ERROR_UNSUPPORTED", [](Test& test) {
        testNotFor(test, {"msaa", "dcaa", "sgbc"}, "AgaaGBufferFunction",
                   [](ViewParts& p) { p.chainAlone(p.gbuffer); });
    });
    suite.core("AgaaShadowFunction/AGAA_ERROR_UNSUPPORTED", [](Test& test) {
        testNotFor(test, {"msaa"}, "AgaaShadowFunction", [](ViewParts& p) { p.chain(p.shadow); });
    });
    suite.core("AgaaGBufferFunction/AGAA_ERROR_INVALID_ARGUMENT", testTwoSources);
    suite.core("AgaaGBufferFunction/tier", testGBufferTiers);
    suite.core("AgaaFetchFunction/tier", testAutoSelectsIds);
    suite.core("AGAA_TIER_FRAGMENT_LISTS/AGAA_ERROR_UNSUPPORTED", testFragmentLists);
    suite.core("AGAA_TIER_FRAGMENTS/AGAA_ERROR_UNSUPPORTED", testFragments);
    suite.core("AgaaShadowFunction.shadows/range", testShadowBits);
    suite.core("AgaaShadowFunction.footprints/AGAA_ERROR_UNSUPPORTED", testFootprints);
    suite.core("AGAA_FETCH_NOT_ALL_DRAWS/AGAA_ERROR_UNSUPPORTED", testNotAllDraws);
    suite.core("AgaaLanes/AGAA_ERROR_UNSUPPORTED", testLanes);
    suite.core("AgaaDebugView/AGAA_ERROR_UNSUPPORTED", testDebugViews);
    suite.core("AgaaDebugView/AGAA_ERROR_UNSUPPORTED/folded_roughness", testWidened);
}

} // namespace agaa::conformance
