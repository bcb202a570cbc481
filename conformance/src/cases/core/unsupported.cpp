// AGAA_ERROR_UNSUPPORTED: settings that a device or a technique does not support, as the comments of the settings
// state.
#include "cases.h"
#include "view_parts.h"

namespace agaa::conformance {

namespace {

using Change = std::function<void(ViewParts&)>;

struct Row {
    std::string what;
    AgaaResult expected;
    Change change;
    std::string tier; // generation tier that AUTO selects; empty: not tested
};

void testRows(Test& test, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        ViewParts parts(test.sdk, nullptr);
        parts.facts.shadowMapCount = 1;
        row.change(parts);
        if (row.expected != AGAA_OK) {
            expectViewRefused(test, parts, row.expected, row.what);
            continue;
        }
        expectAccepted(test, parts, row.what);
        if (row.tier.empty())
            continue;
        const std::string tier = generationTierOf(test, parts);
        test.check(tier == row.tier, "agaaPlanToJson with " + row.what + " names the tier " + tier + " where " +
                                         row.tier + " is promised.");
    }
}

constexpr AgaaResult unsupported = AGAA_ERROR_UNSUPPORTED;

// Tests a setting that needs the tiers IDS or GBUFFER. isBuffered: it works with AGAA_CONFIG_BUFFERED, too.
std::vector<Row> needsMaterials(const std::string& setting, bool isBuffered, const Change& set) {
    const auto with = [set](uint32_t tier, bool fetches, uint64_t flags) {
        return [=](ViewParts& p) {
            set(p);
            p.config.generationTier = tier;
            p.config.flags |= flags;
            if (fetches)
                p.chain(p.fetch);
        };
    };
    const AgaaResult buffered = isBuffered ? AGAA_OK : unsupported;
    return {
        {setting + " and the tier AUTO", AGAA_OK, with(AGAA_TIER_AUTO, false, 0), "gbuffer"},
        {setting + ", an AgaaFetchFunction and the tier AUTO", AGAA_OK, with(AGAA_TIER_AUTO, true, 0), "ids"},
        {setting + " and the tier GBUFFER", AGAA_OK, with(AGAA_TIER_GBUFFER, false, 0), "gbuffer"},
        {setting + " and the tier IDS", AGAA_OK, with(AGAA_TIER_IDS, true, 0), "ids"},
        {setting + " and the tier POST_DEPTH_ATOMICS", unsupported, with(AGAA_TIER_POST_DEPTH_ATOMICS, false, 0), ""},
        {setting + " and the tier PER_SAMPLE", unsupported, with(AGAA_TIER_PER_SAMPLE, true, 0), ""},
        {setting + " and the tier NV_MIXED_SAMPLES", unsupported, with(AGAA_TIER_NV_MIXED_SAMPLES, false, 0), ""},
        {setting + ", the tier GBUFFER and BUFFERED", buffered, with(AGAA_TIER_GBUFFER, false, AGAA_CONFIG_BUFFERED),
         ""},
        {setting + ", the tier IDS and BUFFERED", buffered, with(AGAA_TIER_IDS, true, AGAA_CONFIG_BUFFERED), ""},
        {setting + ", the tier AUTO and BUFFERED", buffered, with(AGAA_TIER_AUTO, false, AGAA_CONFIG_BUFFERED), ""},
    };
}

void testNdf(Test& test) {
    AgaaLayout folded = AGAA_LAYOUT_INIT;
    test.requireOk(test.sdk.agaaGetBuiltinLayout("paper16", &folded), "agaaGetBuiltinLayout(\"paper16\")");
    for (const uint32_t ndf : {AGAA_NDF_LEAN, AGAA_NDF_SGGX}) {
        const std::string name = ndf == AGAA_NDF_LEAN ? "AGAA_NDF_LEAN" : "AGAA_NDF_SGGX";
        testRows(test, needsMaterials(name + ", a layout with folded roughness", false, [&](ViewParts& p) {
                     p.config.ndf = ndf;
                     p.layout = folded;
                     p.useLayout();
                 }));
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE,
                                    AGAA_TIER_GBUFFER, AGAA_TIER_IDS, AGAA_TIER_NV_MIXED_SAMPLES})
            for (const uint64_t flags : {uint64_t(0), uint64_t(AGAA_CONFIG_BUFFERED)})
                testRows(test,
                         {{name + ", the tier " + std::to_string(tier) + " and the flags " + std::to_string(flags),
                           tier == AGAA_TIER_NV_MIXED_SAMPLES ? unsupported : AGAA_OK,
                           [=](ViewParts& p) {
                               p.config.ndf = ndf;
                               p.config.generationTier = tier;
                               p.config.flags |= flags;
                               if (tier == AGAA_TIER_IDS)
                                   p.chain(p.fetch);
                           },
                           ""}});
        const auto withTier = [ndf](const char* technique, bool isSpecular) {
            return [=](ViewParts& p) {
                p.config.technique = technique;
                p.config.ndf = ndf;
                p.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
                if (!isSpecular)
                    p.facts.flags &= ~AGAA_FACT_SPECULAR;
            };
        };
        // These techniques use TOKSVIG.
        testRows(test, {{"\"sbaa\" and " + name, AGAA_OK, withTier("sbaa", true), ""},
                        {"\"ssaa\" and " + name, AGAA_OK, withTier("ssaa", true), ""},
                        {"no specular light and " + name, AGAA_OK, withTier("agaa", false), ""}});
    }
}

void testLitShadows(Test& test) {
    testRows(test, needsMaterials("AgaaAggregation::litShadows = 1", false,
                                  [](ViewParts& p) { p.aggregation.litShadows = 1; }));
    const Change beyond = [](ViewParts& p) {
        p.aggregation.litShadows = 6;
        p.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
    };
    testRows(test, {{"litShadows beyond shadowMapCount", AGAA_OK, beyond, ""}});
}

void testGlossWeight(Test& test) {
    testRows(test, needsMaterials("AgaaAggregation::glossWeight = 0.5", true,
                                  [](ViewParts& p) { p.aggregation.glossWeight = 0.5f; }));
    const Change rough = [](ViewParts& p) {
        p.aggregation.glossWeight = 0.5f;
        p.facts.flags &= ~AGAA_FACT_SPECULAR;
        p.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
    };
    testRows(test, {{"glossWeight and no specular light", AGAA_OK, rough, ""}});
}

// The techniques whose samples are those of the device, and others.
void testLayeredTier(Test& test, uint32_t tier, const std::string& name) {
    const auto with = [=](const char* technique, uint32_t samples) {
        return [=](ViewParts& p) {
            p.setTechnique(technique, samples);
            p.config.visibilityTier = tier;
        };
    };
    for (const char* technique : {"msaa", "ssaa", "visibility", "simple_complex", "sbaa", "agaa", "adaptive"})
        for (const uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
            testRows(test, {{std::string("\"") + technique + "\", n = " + std::to_string(samples) +
                                 " and visibilityTier = " + name,
                             samples == 1 ? unsupported : AGAA_OK, with(technique, samples), ""}});
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "dcaa", "sgbc"})
        testRows(test, {{std::string("\"") + technique + "\" and visibilityTier = " + name, unsupported,
                         with(technique, 4), ""}});
    testRows(test, {{"an AgaaGBufferFunction and visibilityTier = " + name, unsupported,
                     [=](ViewParts& p) {
                         p.config.visibilityTier = tier;
                         p.chain(p.gbuffer);
                     },
                     ""},
                    {"n = 16 of samples of one and visibilityTier = " + name, unsupported,
                     [=](ViewParts& p) {
                         p.setTechnique("agaa", 16);
                         p.config.visibilityTier = tier;
                         p.caps.sampleCounts = 1;
                     },
                     ""}});
}

void testMulticast(Test& test) {
    testLayeredTier(test, AGAA_TIER_NV_MULTICAST, "AGAA_TIER_NV_MULTICAST");
    const auto without = [](uint64_t flag) {
        return [=](ViewParts& p) {
            p.config.visibilityTier = AGAA_TIER_NV_MULTICAST;
            p.caps.flags &= ~flag;
        };
    };
    testRows(test, {{"AGAA_TIER_NV_MULTICAST without AGAA_DEVICE_NV_MULTICAST", unsupported,
                     without(AGAA_DEVICE_NV_MULTICAST), ""},
                    {"AGAA_TIER_NV_MULTICAST without AGAA_DEVICE_SAMPLE_LOCATIONS", AGAA_OK,
                     without(AGAA_DEVICE_SAMPLE_LOCATIONS), ""}});
}

// Tests a tier of the other stage.
void testOtherStage(Test& test) {
    for (const uint32_t tier : {AGAA_TIER_NV_MIXED_SAMPLES, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE,
                                AGAA_TIER_GBUFFER, AGAA_TIER_IDS, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_FRAGMENTS,
                                AGAA_TIER_MATERIAL_LISTS, AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER})
        testRows(test, {{"visibilityTier = " + std::to_string(tier), unsupported,
                         [=](ViewParts& p) { p.config.visibilityTier = tier; }, ""}});
    for (const uint32_t tier :
         {AGAA_TIER_NATIVE, AGAA_TIER_NV_MULTICAST, AGAA_TIER_SCALED_TARGET, AGAA_TIER_LAYERS, AGAA_TIER_ORDERED_GRID})
        for (const char* technique : {"agaa", "dcaa"})
            testRows(test,
                     {{std::string("\"") + technique + "\" and generationTier = " + std::to_string(tier), unsupported,
                       [=](ViewParts& p) {
                           p.setTechnique(technique, 4);
                           p.config.generationTier = tier;
                       },
                       ""}});
}

// Tests a generation tier of other techniques.
void testOtherTechnique(Test& test) {
    const auto with = [](const char* technique, uint32_t tier) {
        return [=](ViewParts& p) {
            p.setTechnique(technique, 4);
            p.config.generationTier = tier;
            p.desc.pNext = nullptr;
            p.chain(p.fetch);
        };
    };
    for (const char* technique : {"agaa", "sbaa"})
        testRows(test, {{std::string("\"") + technique + "\" and AGAA_TIER_FRAGMENT_LISTS", unsupported,
                         with(technique, AGAA_TIER_FRAGMENT_LISTS), ""},
                        {std::string("\"") + technique + "\" and AGAA_TIER_MATERIAL_LISTS", unsupported,
                         with(technique, AGAA_TIER_MATERIAL_LISTS), ""},
                        {std::string("\"") + technique + "\" and AGAA_TIER_FRAGMENT_INTERLOCK", unsupported,
                         with(technique, AGAA_TIER_FRAGMENT_INTERLOCK), ""},
                        {std::string("\"") + technique + "\" and AGAA_TIER_RASTER_ORDER", unsupported,
                         with(technique, AGAA_TIER_RASTER_ORDER), ""}});
    for (const uint32_t tier : {AGAA_TIER_NV_MIXED_SAMPLES, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE,
                                AGAA_TIER_GBUFFER, AGAA_TIER_IDS, AGAA_TIER_FRAGMENTS})
        testRows(test,
                 {{"\"dcaa\" and generationTier = " + std::to_string(tier), unsupported, with("dcaa", tier), ""}});
    for (const uint32_t tier : {AGAA_TIER_IDS, AGAA_TIER_FRAGMENTS})
        testRows(test,
                 {{"\"sbaa\" and generationTier = " + std::to_string(tier), unsupported, with("sbaa", tier), ""}});
}

void testMixedSamples(Test& test) {
    for (const char* technique : {"agaa", "sbaa"}) {
        const auto with = [=](uint64_t without) {
            return [=](ViewParts& p) {
                p.config.technique = technique;
                p.config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
                p.caps.flags &= ~without;
            };
        };
        const std::string name = std::string("\"") + technique + "\" and AGAA_TIER_NV_MIXED_SAMPLES";
        testRows(test, {{name, AGAA_OK, with(0), "nv-mixed-samples"},
                        {name + " without AGAA_DEVICE_NV_MIXED_SAMPLES", unsupported,
                         with(AGAA_DEVICE_NV_MIXED_SAMPLES), ""}});
    }
}

void testCounters(Test& test) {
    for (const char* technique :
         {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex", "sbaa", "agaa"}) {
        const auto with = [=](uint64_t flags) {
            return [=](ViewParts& p) {
                p.config.technique = technique;
                p.config.flags = flags;
                p.caps.flags &= ~AGAA_DEVICE_FRAGMENT_ATOMICS;
            };
        };
        const std::string name = std::string("\"") + technique + "\" without AGAA_DEVICE_FRAGMENT_ATOMICS";
        testRows(test, {{name + " and with AGAA_CONFIG_COUNTERS", unsupported, with(AGAA_CONFIG_COUNTERS), ""},
                        {name, AGAA_OK, with(0), ""}});
    }
}

void testCustomDepth(Test& test) {
    const auto with = [](const char* technique, uint32_t tier, bool fetches) {
        return [=](ViewParts& p) {
            p.setTechnique(technique, 4);
            p.config.generationTier = tier;
            p.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
            if (fetches)
                p.chain(p.fetch);
        };
    };
    const std::string fact = " and AGAA_FACT_CUSTOM_DEPTH";
    testRows(test, {{"\"msaa\"" + fact, unsupported, with("msaa", 0, false), ""},
                    {"\"agaa\"" + fact, AGAA_OK, with("agaa", 0, false), "gbuffer"},
                    {"\"agaa\", an AgaaFetchFunction" + fact, AGAA_OK, with("agaa", 0, true), "ids"},
                    {"\"sbaa\"" + fact, AGAA_OK, with("sbaa", 0, false), "gbuffer"},
                    {"\"single\"" + fact, AGAA_OK, with("single", 0, false), ""},
                    {"\"ssaa\"" + fact, AGAA_OK, with("ssaa", 0, false), ""},
                    {"\"dcaa\"" + fact, unsupported, with("dcaa", 0, false), ""},
                    {"the tier POST_DEPTH_ATOMICS" + fact, unsupported,
                     with("agaa", AGAA_TIER_POST_DEPTH_ATOMICS, false), ""},
                    {"the tier PER_SAMPLE" + fact, unsupported, with("sbaa", AGAA_TIER_PER_SAMPLE, false), ""}});
}

// The flag replaces geometry shaders only.
void testVertexPulling(Test& test) {
    for (const auto& [technique, tier] : {std::pair{"dcaa", AGAA_TIER_FRAGMENT_LISTS},
                                          {"dcaa", AGAA_TIER_MATERIAL_LISTS},
                                          {"dcaa", AGAA_TIER_FRAGMENT_INTERLOCK},
                                          {"dcaa", AGAA_TIER_RASTER_ORDER},
                                          {"agaa", AGAA_TIER_FRAGMENTS}}) {
        const auto with = [&, technique = technique, tier = tier](uint64_t flags, uint64_t without) {
            return [=](ViewParts& p) {
                p.setTechnique("dcaa", 4); // this also chains sceneFetch
                p.config.technique = technique;
                p.config.aggregates = 2; // attachments hold two surfaces
                p.config.generationTier = uint32_t(tier);
                p.config.flags = 0;
                p.desc.flags |= flags;
                p.caps.flags &= ~without;
            };
        };
        const std::string name = test.sdk.agaaTierName(tier);
        const uint64_t pulls = AGAA_VIEW_VERTEX_PULLING, geometry = AGAA_DEVICE_GEOMETRY_SHADERS;
        testRows(test, {{"the tier " + name + " without geometry shaders", unsupported, with(0, geometry), ""},
                        {"AGAA_VIEW_VERTEX_PULLING and the tier " + name, AGAA_OK, with(pulls, 0), name},
                        {"AGAA_VIEW_VERTEX_PULLING and the tier " + name + " without geometry shaders", AGAA_OK,
                         with(pulls, geometry), name},
                        {"AGAA_VIEW_VERTEX_PULLING and the tier " + name + " without atomics", unsupported,
                         with(pulls, AGAA_DEVICE_FRAGMENT_ATOMICS), ""}});
    }
}

// Compute passes need no features of the device, but the materials of all draws.
void testMaxTriangles(Test& test) {
    for (const auto& [technique, tier, isExpanded] : {std::tuple{"dcaa", AGAA_TIER_FRAGMENT_LISTS, true},
                                                      {"dcaa", AGAA_TIER_AUTO, true},
                                                      {"agaa", AGAA_TIER_FRAGMENTS, true},
                                                      {"dcaa", AGAA_TIER_MATERIAL_LISTS, false},
                                                      {"dcaa", AGAA_TIER_FRAGMENT_INTERLOCK, false}}) {
        const auto with = [technique = technique, tier = tier](uint32_t maxTriangles, uint64_t without) {
            return [=](ViewParts& p) {
                p.setTechnique("dcaa", 4); // this also chains sceneFetch
                p.config.technique = technique;
                p.config.generationTier = uint32_t(tier);
                p.config.flags = 0;
                p.sceneFetch.maxTriangles = maxTriangles;
                p.caps.flags &= ~without;
            };
        };
        const std::string taken = test.sdk.agaaTierName(tier == AGAA_TIER_AUTO ? AGAA_TIER_FRAGMENT_LISTS : tier);
        const std::string name = std::string("the tier ") + test.sdk.agaaTierName(tier);
        const AgaaResult expected = isExpanded ? AGAA_OK : unsupported;
        for (const uint64_t without : {uint64_t(AGAA_DEVICE_FRAGMENT_ATOMICS), uint64_t(AGAA_DEVICE_GEOMETRY_SHADERS),
                                       AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_GEOMETRY_SHADERS})
            testRows(test, {{name + " without a feature", unsupported, with(0, without), ""},
                            {name + " and maxTriangles = 1000 without a feature", expected, with(1000, without),
                             isExpanded ? taken : ""}});
        testRows(test, {{name + " and maxTriangles = 1000", AGAA_OK, with(1000, 0), taken}});
    }
}

// Each tier needs features; without them AUTO selects another one, and "ssaa" does not use the tier at all.
void testGenerationTier(Test& test) {
    struct Need {
        uint32_t tier;
        const char* name;
        uint64_t feature;
    };
    for (const Need& need : {Need{AGAA_TIER_POST_DEPTH_ATOMICS, "POST_DEPTH_ATOMICS", AGAA_DEVICE_POST_DEPTH_COVERAGE},
                             Need{AGAA_TIER_POST_DEPTH_ATOMICS, "POST_DEPTH_ATOMICS", AGAA_DEVICE_FRAGMENT_ATOMICS},
                             Need{AGAA_TIER_PER_SAMPLE, "PER_SAMPLE", AGAA_DEVICE_FRAGMENT_ATOMICS},
                             Need{AGAA_TIER_PER_SAMPLE, "PER_SAMPLE", AGAA_DEVICE_SAMPLE_RATE_SHADING},
                             Need{AGAA_TIER_NV_MIXED_SAMPLES, "NV_MIXED_SAMPLES", AGAA_DEVICE_NV_MIXED_SAMPLES}}) {
        const auto with = [need](uint32_t tier, const char* technique) {
            return [=](ViewParts& p) {
                p.config.technique = technique;
                p.config.generationTier = tier;
                p.config.flags = 0; // counters need features, too
                p.caps.flags &= ~need.feature;
            };
        };
        const std::string lacks = " on a device that lacks a feature of " + std::string(need.name);
        testRows(test, {{"the tier" + lacks, unsupported, with(need.tier, "agaa"), ""},
                        {"the tier AUTO" + lacks, AGAA_OK, with(AGAA_TIER_AUTO, "agaa"), ""},
                        {"\"ssaa\" and the tier" + lacks, AGAA_OK, with(need.tier, "ssaa"), ""}});
    }
    const auto ids = [](ViewParts& p) { p.config.generationTier = AGAA_TIER_IDS; };
    testRows(test, {{"the tier IDS without an AgaaFetchFunction", unsupported, ids, ""}});
    // All tiers of "dcaa" need the features.
    for (const uint64_t feature : {AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_DEVICE_GEOMETRY_SHADERS})
        for (const uint32_t tier :
             {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS, AGAA_TIER_FRAGMENT_INTERLOCK}) {
            const auto lists = [=](uint64_t without) {
                return [=](ViewParts& p) {
                    p.setTechnique("dcaa", 4);
                    p.config.generationTier = tier;
                    p.config.flags = 0;
                    p.caps.flags &= ~without;
                };
            };
            const uint32_t taken = tier == AGAA_TIER_AUTO ? uint32_t(AGAA_TIER_FRAGMENT_LISTS) : tier;
            testRows(test,
                     {{"\"dcaa\"", AGAA_OK, lists(0), test.sdk.agaaTierName(taken)},
                      {"\"dcaa\" on a device that lacks a feature of its tier", unsupported, lists(feature), ""}});
        }
    for (const uint64_t without : {UINT64_C(0), AGAA_DEVICE_FRAGMENT_INTERLOCK})
        for (const uint64_t flags : {UINT64_C(0), AGAA_COVERAGE_EXACT}) {
            const auto interlock = [=](ViewParts& p) {
                p.setTechnique("dcaa", 4);
                p.config.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
                p.coverage.flags = flags;
                p.caps.flags &= ~without;
            };
            testRows(test, {{"the tier FRAGMENT_INTERLOCK, AgaaDecoupledCoverage::flags = " + std::to_string(flags) +
                                 (without ? ", without the feature" : ""),
                             without || flags ? unsupported : AGAA_OK, interlock, ""}});
        }
    // Attachments hold 128 bytes per pixel.
    for (const uint64_t without : {UINT64_C(0), AGAA_DEVICE_FRAMEBUFFER_FETCH, AGAA_DEVICE_GEOMETRY_SHADERS})
        for (const uint32_t surfaces : {1u, 2u, 8u})
            for (const uint64_t flags : {UINT64_C(0), AGAA_COVERAGE_EXACT}) {
                const auto rasterOrder = [=](ViewParts& p) {
                    p.setTechnique("dcaa", 4);
                    p.config.generationTier = AGAA_TIER_RASTER_ORDER;
                    p.config.aggregates = surfaces;
                    p.config.flags = 0;
                    p.coverage.flags = flags;
                    p.caps.flags &= ~without;
                };
                testRows(test, {{"the tier RASTER_ORDER, " + std::to_string(surfaces) +
                                     " surfaces, AgaaDecoupledCoverage::flags = " + std::to_string(flags) +
                                     (without ? ", without a feature" : ""),
                                 without || flags || surfaces > 2 ? unsupported : AGAA_OK, rasterOrder, ""}});
            }
}

// AGAA_ADAPTIVE_SORTED sorts at most 2^26 pixels.
void testSorted(Test& test) {
    const auto with = [](uint32_t width, uint64_t flags) {
        return [=](ViewParts& p) {
            p.setTechnique("adaptive", 1);
            p.config.samples = 1;
            p.caps.maxImageSize = 1u << 20;
            p.caps.maxStorageRange = UINT64_C(1) << 48;
            p.desc.width = width;
            p.desc.height = 8192;
            p.adaptive.flags |= flags;
        };
    };
    testRows(test, {{"8192 x 8192 pixels and SORTED", AGAA_OK, with(8192, AGAA_ADAPTIVE_SORTED), ""},
                    {"8193 x 8192 pixels", AGAA_OK, with(8193, 0), ""},
                    {"8193 x 8192 pixels and SORTED", AGAA_ERROR_TOO_LARGE, with(8193, AGAA_ADAPTIVE_SORTED), ""}});
}

// targetEvents needs differences of samples, which decide the samples that are skipped.
void testTargets(Test& test) {
    const auto with = [](uint64_t flags) {
        return [flags](ViewParts& p) {
            p.setTechnique("adaptive", 4);
            p.adaptive.targetEvents = 2;
            p.adaptive.flags = flags;
        };
    };
    constexpr uint64_t both = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING;
    testRows(test, {{"targetEvents and both metrics", AGAA_OK, with(both), ""},
                    {"targetEvents and GEOMETRY", AGAA_OK, with(AGAA_ADAPTIVE_GEOMETRY), ""},
                    {"targetEvents and SHADING alone", unsupported, with(AGAA_ADAPTIVE_SHADING), ""},
                    {"targetEvents without metrics", unsupported, with(0), ""},
                    {"targetEvents and PRINTED_METRIC", unsupported, with(both | AGAA_ADAPTIVE_PRINTED_METRIC), ""},
                    {"targetEvents and IN_ORDER", unsupported, with(both | AGAA_ADAPTIVE_IN_ORDER), ""},
                    {"targetEvents and BUCKETS", unsupported, with(both | AGAA_ADAPTIVE_BUCKETS), ""},
                    {"targetEvents and TILE_MAXIMUM", unsupported, with(both | AGAA_ADAPTIVE_TILE_MAXIMUM), ""},
                    {"targetEvents and SORTED", AGAA_OK, with(both | AGAA_ADAPTIVE_SORTED), ""},
                    {"targetEvents and countMemory", unsupported,
                     [&](ViewParts& p) {
                         with(both)(p);
                         p.adaptive.countMemory = 0.5f;
                     },
                     ""}});
}

// Only lists keep all fragments.
void testExact(Test& test) {
    const auto exact = [](uint32_t tier, uint64_t flags = AGAA_COVERAGE_EXACT) {
        return [=](ViewParts& p) {
            p.setTechnique("dcaa", 4);
            p.config.generationTier = tier;
            p.coverage.flags = flags;
        };
    };
    testRows(test, {{"AGAA_COVERAGE_EXACT", AGAA_OK, exact(AGAA_TIER_AUTO), ""},
                    {"the tier FRAGMENT_INTERLOCK", AGAA_OK, exact(AGAA_TIER_FRAGMENT_INTERLOCK, 0), ""},
                    {"AGAA_COVERAGE_EXACT and the tier FRAGMENT_INTERLOCK", unsupported,
                     exact(AGAA_TIER_FRAGMENT_INTERLOCK), ""},
                    {"AGAA_COVERAGE_EXACT and the tier RASTER_ORDER", unsupported, exact(AGAA_TIER_RASTER_ORDER), ""}});
}

// Only draws of the host have a depth prepass, and only lists drop fragments.
void testDepthPrepass(Test& test) {
    const auto prepass = [](uint32_t tier, uint32_t maxTriangles, uint64_t flags = AGAA_COVERAGE_DEPTH_PREPASS) {
        return [=](ViewParts& p) {
            p.setTechnique("dcaa", 4);
            p.config.generationTier = tier;
            p.sceneFetch.maxTriangles = maxTriangles;
            p.coverage.flags = flags;
        };
    };
    const std::string name = "AGAA_COVERAGE_DEPTH_PREPASS";
    testRows(
        test,
        {{name, AGAA_OK, prepass(AGAA_TIER_AUTO, 0), ""},
         {name + " and the tier MATERIAL_LISTS", AGAA_OK, prepass(AGAA_TIER_MATERIAL_LISTS, 0), ""},
         {name + " and the tier FRAGMENT_INTERLOCK", unsupported, prepass(AGAA_TIER_FRAGMENT_INTERLOCK, 0), ""},
         {name + " and the tier RASTER_ORDER", unsupported, prepass(AGAA_TIER_RASTER_ORDER, 0), ""},
         {"maxTriangles", AGAA_OK, prepass(AGAA_TIER_AUTO, 1000, 0), ""},
         {name + " and maxTriangles", unsupported, prepass(AGAA_TIER_AUTO, 1000), ""},
         {name + ", maxTriangles and the tier MATERIAL_LISTS", AGAA_OK, prepass(AGAA_TIER_MATERIAL_LISTS, 1000), ""}});
}

// "sgbc" has lists only, and keeps depths of samples.
void testStreaming(Test& test) {
    const auto with = [](uint32_t tier, uint64_t flags) {
        return [=](ViewParts& p) {
            p.setTechnique("sgbc", 4);
            p.config.generationTier = tier;
            p.coverage.flags = flags;
        };
    };
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS,
                                AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER}) {
        const bool isList = tier != AGAA_TIER_FRAGMENT_INTERLOCK && tier != AGAA_TIER_RASTER_ORDER;
        testRows(test, {{"\"sgbc\" and the tier " + std::to_string(tier), isList ? AGAA_OK : unsupported, with(tier, 0),
                         ""}});
    }
    for (const uint64_t flags : {AGAA_COVERAGE_EXACT, AGAA_COVERAGE_DEPTH_PREPASS})
        testRows(test, {{"\"sgbc\" and AgaaDecoupledCoverage::flags = " + std::to_string(flags), unsupported,
                         with(AGAA_TIER_AUTO, flags), ""}});
}

// Without lists, fragments merge as they come.
void testMergeOrder(Test& test) {
    const auto with = [](const char* technique, uint32_t tier, uint64_t flags) {
        return [=](ViewParts& p) {
            p.setTechnique(technique, 4);
            p.config.generationTier = tier;
            p.coverage.flags = flags;
        };
    };
    const std::string reverse = "AGAA_COVERAGE_REVERSE_ORDER";
    for (const char* technique : {"dcaa", "sgbc"})
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS})
            testRows(test, {{reverse + ", \"" + technique + "\" and the tier " + std::to_string(tier), AGAA_OK,
                             with(technique, tier, AGAA_COVERAGE_REVERSE_ORDER), ""}});
    for (const uint32_t tier : {AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER})
        testRows(test, {{reverse + " and the tier " + std::to_string(tier), unsupported,
                         with("dcaa", tier, AGAA_COVERAGE_REVERSE_ORDER), ""}});
}

// The tier FRAGMENTS of "agaa" groups and shades all fragments in one pass.
void testFragmentsAtOnce(Test& test) {
    const auto fragments = [](uint64_t flags) {
        return [=](ViewParts& p) {
            p.chain(p.fetch);
            p.config.samples = 64;
            p.config.flags |= flags;
            p.coverage.flags = AGAA_COVERAGE_EXACT; // the flag belongs to "dcaa"
        };
    };
    testRows(test, {{"the tier FRAGMENTS", AGAA_OK, fragments(0), ""},
                    {"the tier FRAGMENTS and AGAA_CONFIG_BUFFERED", unsupported, fragments(AGAA_CONFIG_BUFFERED), ""}});
}

void testVisibilityTier(Test& test) {
    const auto with = [](uint32_t tier) {
        return [=](ViewParts& p) {
            p.config.visibilityTier = tier;
            p.caps.sampleCounts = 1; // the device has no multisampling
        };
    };
    testRows(test, {{"the tier NATIVE on a device without multisampling", unsupported, with(AGAA_TIER_NATIVE), ""},
                    {"the tier SCALED on a device without multisampling", AGAA_OK, with(AGAA_TIER_SCALED_TARGET), ""},
                    {"the tier AUTO on a device without multisampling", AGAA_OK, with(AGAA_TIER_AUTO), ""}});
    // The targets of "dcaa" have one sample.
    const auto withDcaaTier = [](uint32_t tier) {
        return [=](ViewParts& p) {
            p.setTechnique("dcaa", 4);
            p.config.visibilityTier = tier;
            p.caps.sampleCounts = 1;
        };
    };
    testRows(test, {{"\"dcaa\" and the tier NATIVE", AGAA_OK, withDcaaTier(AGAA_TIER_NATIVE), ""},
                    {"\"dcaa\" and the tier AUTO", AGAA_OK, withDcaaTier(AGAA_TIER_AUTO), ""},
                    {"\"dcaa\" and the tier SCALED", unsupported, withDcaaTier(AGAA_TIER_SCALED_TARGET), ""}});
}

void testSampleCounts(Test& test) {
    struct Counts {
        uint32_t device, samples;
        AgaaResult expected;
    };
    for (const Counts& c : {Counts{0, 1, unsupported}, Counts{0, 4, unsupported}, Counts{0x04, 2, unsupported},
                            Counts{0x04, 4, AGAA_OK}, Counts{0x01, 32, AGAA_OK}, Counts{0x3F, 32, AGAA_OK}})
        testRows(test,
                 {{"n = " + std::to_string(c.samples) + " and sampleCounts = " + std::to_string(c.device), c.expected,
                   [=](ViewParts& p) {
                       p.config.samples = c.samples;
                       p.caps.sampleCounts = c.device;
                   },
                   ""}});
    testRows(test, {{"NATIVE and sampleCounts without n", unsupported,
                     [](ViewParts& p) {
                         p.config.visibilityTier = AGAA_TIER_NATIVE;
                         p.caps.sampleCounts = 0x3B;
                     },
                     ""}});
}

// Frames are accumulated by their depth.
void testAccumulation(Test& test) {
    const auto with = [](const char* technique, uint32_t tier) {
        return [=](ViewParts& p) {
            p.setTechnique(technique, 4);
            p.config.generationTier = tier;
            if (tier == AGAA_TIER_FRAGMENTS) {
                p.config.samples = 64;
                p.chain(p.fetch);
            }
            p.config.flags |= AGAA_CONFIG_ACCUMULATE;
        };
    };
    testRows(test, {{"\"single\" and ACCUMULATE", AGAA_OK, with("single", AGAA_TIER_AUTO), ""},
                    {"\"msaa\" and ACCUMULATE", AGAA_OK, with("msaa", AGAA_TIER_AUTO), ""},
                    {"\"agaa\" and ACCUMULATE", AGAA_OK, with("agaa", AGAA_TIER_AUTO), ""},
                    {"\"dcaa\" and ACCUMULATE", unsupported, with("dcaa", AGAA_TIER_AUTO), ""},
                    {"the tier FRAGMENTS and ACCUMULATE", unsupported, with("agaa", AGAA_TIER_FRAGMENTS), ""}});
}

// A custom attribute "velocity" with these channels, and its name in AgaaTemporal::motion.
Change withMotion(const char* technique, uint32_t tier, uint32_t channels, const char* name = "velocity") {
    return [=](ViewParts& p) {
        p.setTechnique(technique, 4);
        p.useLayout();
        AgaaLayoutAttribute& a = p.layout.attributes[p.layout.attributeCount++];
        a = AGAA_LAYOUT_ATTRIBUTE_INIT;
        a.semantic = AGAA_SEMANTIC_CUSTOM;
        a.channels = channels;
        a.sampleBits = 16;
        a.name = "velocity";
        p.config.generationTier = tier;
        p.config.flags |= AGAA_CONFIG_ACCUMULATE;
        p.temporal.motion = name;
    };
}

void testMotion(Test& test) {
    testRows(test, {{"\"taa\" and motion", AGAA_OK, withMotion("taa", AGAA_TIER_AUTO, 2), ""},
                    {"\"agaa\", the tier GBUFFER and motion", AGAA_OK, withMotion("agaa", AGAA_TIER_GBUFFER, 2), ""},
                    {"\"agaa\", the tier POST_DEPTH_ATOMICS and motion", unsupported,
                     withMotion("agaa", AGAA_TIER_POST_DEPTH_ATOMICS, 2), ""},
                    {"\"msaa\" and motion", unsupported, withMotion("msaa", AGAA_TIER_AUTO, 2), ""}});
}

void testMotionLayout(Test& test) {
    testRows(test,
             {{"motion with 1 channel", AGAA_ERROR_LAYOUT, withMotion("taa", AGAA_TIER_AUTO, 1), ""},
              {"motion with 3 channels", AGAA_ERROR_LAYOUT, withMotion("taa", AGAA_TIER_AUTO, 3), ""},
              {"motion without an attribute", AGAA_ERROR_LAYOUT, withMotion("taa", AGAA_TIER_AUTO, 2, "spin"), ""},
              {"motion with an empty name", AGAA_ERROR_LAYOUT, withMotion("taa", AGAA_TIER_AUTO, 2, ""), ""}});
}

} // namespace

void addUnsupportedCases(Suite& suite) {
    suite.core("AgaaNdf/AGAA_ERROR_UNSUPPORTED", testNdf);
    suite.core("AgaaAggregation.litShadows/AGAA_ERROR_UNSUPPORTED", testLitShadows);
    suite.core("AgaaAggregation.glossWeight/AGAA_ERROR_UNSUPPORTED", testGlossWeight);
    suite.core("AGAA_TIER_NV_MULTICAST/AGAA_ERROR_UNSUPPORTED", testMulticast);
    suite.core("AGAA_TIER_LAYERS/AGAA_ERROR_UNSUPPORTED",
               [](Test& test) { testLayeredTier(test, AGAA_TIER_LAYERS, "AGAA_TIER_LAYERS"); });
    suite.core("AGAA_TIER_NV_MIXED_SAMPLES/AGAA_ERROR_UNSUPPORTED/queries", testMixedSamples);
    suite.core("AgaaTier/AGAA_ERROR_UNSUPPORTED/other_stage", testOtherStage);
    suite.core("AgaaTier/AGAA_ERROR_UNSUPPORTED/other_technique", testOtherTechnique);
    suite.core("AGAA_COVERAGE_EXACT/AGAA_ERROR_UNSUPPORTED", testExact);
    suite.core("AGAA_COVERAGE_DEPTH_PREPASS/AGAA_ERROR_UNSUPPORTED", testDepthPrepass);
    suite.core("AgaaConfig.technique/AGAA_ERROR_UNSUPPORTED", testStreaming);
    suite.core("AGAA_COVERAGE_REVERSE_ORDER/AGAA_ERROR_UNSUPPORTED", testMergeOrder);
    suite.core("AgaaDecoupledCoverage/AGAA_ERROR_UNSUPPORTED", testFragmentsAtOnce);
    suite.core("AgaaAdaptiveSampling.targetEvents/AGAA_ERROR_UNSUPPORTED", testTargets);
    suite.core("AGAA_ADAPTIVE_SORTED/AGAA_ERROR_TOO_LARGE", testSorted);
    suite.core("AGAA_CONFIG_ACCUMULATE/AGAA_ERROR_UNSUPPORTED", testAccumulation);
    suite.core("AgaaTemporal.motion/AGAA_ERROR_UNSUPPORTED", testMotion);
    suite.core("AgaaTemporal.motion/AGAA_ERROR_LAYOUT", testMotionLayout);
    suite.core("AGAA_CONFIG_COUNTERS/AGAA_ERROR_UNSUPPORTED", testCounters);
    suite.core("AGAA_FACT_CUSTOM_DEPTH/AGAA_ERROR_UNSUPPORTED", testCustomDepth);
    suite.core("AGAA_VIEW_VERTEX_PULLING/AGAA_ERROR_UNSUPPORTED", testVertexPulling);
    suite.core("AgaaFetchFunction.maxTriangles/AGAA_ERROR_UNSUPPORTED", testMaxTriangles);
    suite.core("AgaaConfig.generationTier/AGAA_ERROR_UNSUPPORTED", testGenerationTier);
    suite.core("AgaaConfig.visibilityTier/AGAA_ERROR_UNSUPPORTED", testVisibilityTier);
    suite.core("AgaaDeviceCaps.sampleCounts/AGAA_ERROR_UNSUPPORTED/queries", testSampleCounts);
}

} // namespace agaa::conformance
