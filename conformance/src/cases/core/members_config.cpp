// Members of AgaaConfig and of the structs that may be chained to it.
#include "cases.h"
#include "members.h"

namespace agaa::conformance {

namespace {

uint32_t whole(double value) { return uint32_t(value); }

void useDcaa(ViewParts& parts) { parts.setTechnique("dcaa", 4); }

void addConfig(Suite& suite) {
    addMember(suite, {"AgaaConfig.samples/range",
                      "AgaaConfig::samples",
                      [](ViewParts& p, double x) { p.config.samples = whole(x); },
                      {1, 2, 4, 8, 16, 32, 64, 128},
                      largeNumbers({0, 3, 5, 6, 7, 9, 12, 24, 31, 33, 96, 256, 65536}),
                      [](ViewParts& p) { p.chain(p.fetch); }});
    addMember(suite, {"AgaaConfig.samples/range/dcaa",
                      "AgaaConfig::samples",
                      [](ViewParts& p, double x) { p.config.samples = whole(x); },
                      {32, 64, 128},
                      largeNumbers({0, 1, 2, 4, 8, 16, 31, 33, 63, 65, 96, 127, 129, 256}),
                      useDcaa});
    for (const char* technique : {"ssaa", "adaptive"})
        addMember(suite, {std::string("AgaaConfig.samples/range/") + technique,
                          "AgaaConfig::samples",
                          [](ViewParts& p, double x) { p.config.samples = whole(x); },
                          {1, 2, 4, 8, 9, 16, 32},
                          largeNumbers({0, 3, 5, 6, 7, 10, 12, 24, 25, 31, 33, 64}),
                          [technique](ViewParts& p) { p.config.technique = technique; }});
    addMember(suite, {"AgaaConfig.aggregates/range",
                      "AgaaConfig::aggregates",
                      [](ViewParts& p, double x) { p.config.aggregates = whole(x); },
                      {1, 2, 3, 4},
                      largeNumbers({0, 5, 6, 7})});
    addMember(suite, {"AgaaConfig.aggregates/range/sbaa",
                      "AgaaConfig::aggregates",
                      [](ViewParts& p, double x) { p.config.aggregates = whole(x); },
                      {1, 2, 3, 4, 5, 6},
                      largeNumbers({0, 7}),
                      [](ViewParts& p) { p.config.technique = "sbaa"; }});
    addMember(suite, {"AgaaConfig.aggregates/range/dcaa",
                      "AgaaConfig::aggregates",
                      [](ViewParts& p, double x) { p.config.aggregates = whole(x); },
                      {1, 2, 3, 4, 5, 6, 7, 8},
                      largeNumbers({0, 9}),
                      useDcaa});
    addMember(suite, {"AgaaConfig.aggregates/range/ssaa",
                      "AgaaConfig::aggregates",
                      [](ViewParts& p, double x) { p.config.aggregates = whole(x); },
                      {1, 2, 7, 8},
                      largeNumbers({0, 9}),
                      [](ViewParts& p) { p.config.technique = "ssaa"; }});
    addMember(suite, {"AgaaConfig.surfaceCosine/range",
                      "AgaaConfig::surfaceCosine",
                      [](ViewParts& p, double x) { p.config.surfaceCosine = float(x); },
                      {0, below(1), 1},
                      notNumbers({below(0), -1, above(1), 2})});
    addMember(suite, {"AgaaConfig.surfaceDistance/range",
                      "AgaaConfig::surfaceDistance",
                      [](ViewParts& p, double x) { p.config.surfaceDistance = float(x); },
                      {0, above(0), 1e6},
                      notNumbers({below(0), -1, above(1e6f), 3e38})});
    addMember(suite, {"AgaaConfig.surfaceMaterial/range",
                      "AgaaConfig::surfaceMaterial",
                      [](ViewParts& p, double x) { p.config.surfaceMaterial = float(x); },
                      {0, below(1), 1},
                      notNumbers({below(0), -1, above(1), 2})});
    addMember(suite, {"AgaaConfig.shadowTaps/range",
                      "AgaaConfig::shadowTaps",
                      [](ViewParts& p, double x) { p.config.shadowTaps = whole(x); },
                      {0, 1, 8, 31, 32},
                      largeNumbers({33, 64})});
    addMember(suite, {"AgaaConfig.brdf/enum",
                      "AgaaConfig::brdf",
                      [](ViewParts& p, double x) { p.config.brdf = whole(x); },
                      {AGAA_BRDF_BLINN_PHONG, AGAA_BRDF_GGX},
                      largeNumbers({}),
                      nullptr,
                      {AGAA_BRDF_GGX + 1}});
    addMember(suite, {"AgaaConfig.ndf/enum",
                      "AgaaConfig::ndf",
                      [](ViewParts& p, double x) { p.config.ndf = whole(x); },
                      {AGAA_NDF_NONE, AGAA_NDF_TOKSVIG, AGAA_NDF_LEAN, AGAA_NDF_SGGX},
                      largeNumbers({}),
                      nullptr,
                      {AGAA_NDF_SGGX + 1}});
    addFlags(suite, {"AgaaConfig.flags/flags", "AgaaConfig::flags",
                     [](ViewParts& p, uint64_t flags) { p.config.flags = flags; },
                     AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_READBACK | AGAA_CONFIG_SPLIT_SURFACES |
                         AGAA_CONFIG_BUFFERED | AGAA_CONFIG_FINE_MATERIALS | AGAA_CONFIG_CHECK_FACTS |
                         AGAA_CONFIG_ACCUMULATE | AGAA_CONFIG_HDR_RESOLVE | AGAA_CONFIG_BREADCRUMBS,
                     nullptr});
}

// Tiers that need other parts, and tiers of another stage, are in unsupported.cpp.
void addTiers(Suite& suite) {
    const std::vector<double> unknown = {6, 15, AGAA_TIER_RASTER_ORDER + 1};
    const std::vector<double> coverageTiers = {AGAA_TIER_AUTO, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS,
                                               AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER};
    addMember(suite, {"AgaaConfig.visibilityTier/enum",
                      "AgaaConfig::visibilityTier",
                      [](ViewParts& p, double x) { p.config.visibilityTier = whole(x); },
                      {AGAA_TIER_AUTO, AGAA_TIER_NATIVE, AGAA_TIER_NV_MULTICAST, AGAA_TIER_SCALED_TARGET,
                       AGAA_TIER_LAYERS, AGAA_TIER_ORDERED_GRID},
                      largeNumbers({}),
                      nullptr,
                      unknown});
    addMember(suite, {"AgaaConfig.generationTier/enum",
                      "AgaaConfig::generationTier",
                      [](ViewParts& p, double x) { p.config.generationTier = whole(x); },
                      {AGAA_TIER_AUTO, AGAA_TIER_NV_MIXED_SAMPLES, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE,
                       AGAA_TIER_GBUFFER, AGAA_TIER_IDS},
                      largeNumbers({}),
                      [](ViewParts& p) { p.chain(p.fetch); },
                      unknown});
    addMember(suite,
              {"AgaaConfig.generationTier/enum/dcaa", "AgaaConfig::generationTier",
               [](ViewParts& p, double x) { p.config.generationTier = whole(x); }, coverageTiers, largeNumbers({}),
               [](ViewParts& p) {
                   useDcaa(p);
                   p.config.aggregates = 2; // attachments hold two surfaces
               },
               unknown});
    // Techniques without a stage for it check the member, too.
    addMember(suite, {"AgaaConfig.generationTier/enum/ssaa", "AgaaConfig::generationTier",
                      [](ViewParts& p, double x) { p.config.generationTier = whole(x); }, coverageTiers,
                      largeNumbers({}), [](ViewParts& p) { p.config.technique = "ssaa"; }, unknown});
}

void addAggregation(Suite& suite) {
    addMember(suite, {"AgaaAggregation.characteristicLength/range",
                      "AgaaAggregation::characteristicLength",
                      [](ViewParts& p, double x) { p.aggregation.characteristicLength = float(x); },
                      {0, above(0), 1, std::numeric_limits<float>::max()},
                      notNumbers({below(0), -1})});
    addMember(suite, {"AgaaAggregation.characteristicLengthPerDistance/range",
                      "AgaaAggregation::characteristicLengthPerDistance",
                      [](ViewParts& p, double x) { p.aggregation.characteristicLengthPerDistance = float(x); },
                      {0, above(0), below(1), 1},
                      notNumbers({below(0), -1, above(1), 2}),
                      [](ViewParts& p) { p.aggregation.characteristicLength = 1; }});
    addMember(suite, {"AgaaAggregation.characteristicLengthPerDistance/range/k",
                      "AgaaAggregation::characteristicLength",
                      [](ViewParts& p, double x) { p.aggregation.characteristicLengthPerDistance = float(x); },
                      {above(0)},
                      {0},
                      [](ViewParts& p) { p.aggregation.characteristicLength = 0; }});
    addMember(suite, {"AgaaAggregation.aggregateThreshold/range",
                      "AgaaAggregation::aggregateThreshold",
                      [](ViewParts& p, double x) { p.aggregation.aggregateThreshold = float(x); },
                      {0, above(0), 1e6},
                      notNumbers({below(0), -1, above(1e6f), 3e38})});
    addMember(suite, {"AgaaAggregation.glossWeight/range",
                      "AgaaAggregation::glossWeight",
                      [](ViewParts& p, double x) { p.aggregation.glossWeight = float(x); },
                      {0, above(0), below(16), 16},
                      notNumbers({below(0), -1, above(16), 17})});
    addMember(suite, {"AgaaAggregation.reserved/zero",
                      "AgaaAggregation::reserved",
                      [](ViewParts& p, double x) { p.aggregation.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      nullptr,
                      {1}});
    addMember(suite, {"AgaaAggregation.litShadows/range",
                      "AgaaAggregation::litShadows",
                      [](ViewParts& p, double x) { p.aggregation.litShadows = whole(x); },
                      {0, 1, 2, 8, 15},
                      largeNumbers({}),
                      [](ViewParts& p) { p.facts.shadowMapCount = 1; },
                      {16}});
}

void setCoveragePosition(ViewParts& parts, double x) {
    static thread_local float positions[2 * 128];
    for (uint32_t i = 0; i < 2 * 128; ++i)
        positions[i] = float(i) / 256;
    positions[5] = float(x);
    parts.coverage.samplePositions = positions;
}

// Tests "dcaa", and techniques that check the struct and do not use it.
void addDecoupledCoverage(Suite& suite) {
    struct Use {
        const char* variant;
        void (*prepare)(ViewParts&);
    };
    for (const Use& use :
         {Use{"", useDcaa}, Use{"/agaa", nullptr}, Use{"/single", [](ViewParts& p) { p.setTechnique("single", 4); }}}) {
        const auto add = [&](const char* promise, const char* member, void (*set)(ViewParts&, double),
                             std::vector<double> accepted, std::vector<double> refused,
                             std::vector<double> today = {}) {
            addMember(suite, {std::string("AgaaDecoupledCoverage.") + promise + use.variant, member, set,
                              std::move(accepted), std::move(refused), use.prepare, std::move(today)});
        };
        add("merge/enum", "AgaaDecoupledCoverage::merge", [](ViewParts& p, double x) { p.coverage.merge = whole(x); },
            {AGAA_MERGE_VISIBLE, AGAA_MERGE_PAPER, AGAA_MERGE_NONE, AGAA_MERGE_COLOR}, largeNumbers({}),
            {AGAA_MERGE_COLOR + 1});
        add(
            "fragmentsPerPixel/range", "AgaaDecoupledCoverage::fragmentsPerPixel",
            [](ViewParts& p, double x) { p.coverage.fragmentsPerPixel = float(x); }, {1, above(1), 8, below(256), 256},
            notNumbers({0, -1, below(1), above(256), 3e38}));
        add(
            "maxBatches/range", "AgaaDecoupledCoverage::maxBatches",
            [](ViewParts& p, double x) { p.coverage.maxBatches = whole(x); }, {0, 1, 2, 63, 64},
            largeNumbers({65, 128}));
        add("reserved/zero", "AgaaDecoupledCoverage::reserved",
            [](ViewParts& p, double x) { p.coverage.reserved = whole(x); }, {0}, largeNumbers({}), {1});
        add(
            "tableSize/range", "AgaaDecoupledCoverage::tableSize",
            [](ViewParts& p, double x) { p.coverage.tableSize = whole(x); }, {0, 16, 17, 1023, 1024},
            largeNumbers({1, 15, 1025, 4096}));
        add("reservedTable/zero", "AgaaDecoupledCoverage::reservedTable",
            [](ViewParts& p, double x) { p.coverage.reservedTable = whole(x); }, {0}, largeNumbers({}), {1});
    }
    addMember(suite, {"AgaaDecoupledCoverage.samplePositions/range",
                      "AgaaDecoupledCoverage::samplePositions",
                      setCoveragePosition,
                      {0, 0.5, below(1)},
                      notNumbers({below(0), -1, 1, 2}),
                      useDcaa});
    suite.core("AgaaDecoupledCoverage.samplePositions/null", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        useDcaa(parts);
        parts.coverage.samplePositions = nullptr;
        expectAccepted(test, parts, "AgaaDecoupledCoverage::samplePositions = null");
    });
    addFlags(suite, {"AgaaDecoupledCoverage.flags/flags", "AgaaDecoupledCoverage::flags",
                     [](ViewParts& p, uint64_t flags) { p.coverage.flags = flags; },
                     AGAA_COVERAGE_EXACT | AGAA_COVERAGE_DRAW_ORDER | AGAA_COVERAGE_DEPTH_PREPASS |
                         AGAA_COVERAGE_REVERSE_ORDER,
                     useDcaa});
}

// Tests "adaptive", and techniques that check the struct and do not use it.
void addAdaptiveSampling(Suite& suite) {
    struct Use {
        const char* variant;
        void (*prepare)(ViewParts&);
    };
    for (const Use& use : {Use{"", [](ViewParts& p) { p.setTechnique("adaptive", 4); }}, Use{"/agaa", nullptr}}) {
        const auto add = [&](const char* promise, const char* member, void (*set)(ViewParts&, double), float most) {
            addMember(suite, {std::string("AgaaAdaptiveSampling.") + promise + use.variant,
                              member,
                              set,
                              {0, above(0), double(most) / 2, below(most), most},
                              notNumbers({below(0), -1, above(most), 3e38}),
                              use.prepare});
        };
        add(
            "depthScale/range", "AgaaAdaptiveSampling::depthScale",
            [](ViewParts& p, double x) { p.adaptive.depthScale = float(x); }, 1e12f);
        add(
            "normalScale/range", "AgaaAdaptiveSampling::normalScale",
            [](ViewParts& p, double x) { p.adaptive.normalScale = float(x); }, 1e6f);
        add(
            "shadingScale/range", "AgaaAdaptiveSampling::shadingScale",
            [](ViewParts& p, double x) { p.adaptive.shadingScale = float(x); }, 1e6f);
        add(
            "shadingThreshold/range", "AgaaAdaptiveSampling::shadingThreshold",
            [](ViewParts& p, double x) { p.adaptive.shadingThreshold = float(x); }, 1);
        add(
            "shadingMinimum/range", "AgaaAdaptiveSampling::shadingMinimum",
            [](ViewParts& p, double x) { p.adaptive.shadingMinimum = float(x); }, 1);
        add(
            "glossWeight/range", "AgaaAdaptiveSampling::glossWeight",
            [](ViewParts& p, double x) { p.adaptive.glossWeight = float(x); }, 16);
        add(
            "targetEvents/range", "AgaaAdaptiveSampling::targetEvents",
            [](ViewParts& p, double x) { p.adaptive.targetEvents = float(x); }, 32);
        add(
            "countMemory/range", "AgaaAdaptiveSampling::countMemory",
            [](ViewParts& p, double x) { p.adaptive.countMemory = float(x); }, 0.99f);
        addMember(suite, {std::string("AgaaAdaptiveSampling.reserved/zero") + use.variant,
                          "AgaaAdaptiveSampling::reserved",
                          [](ViewParts& p, double x) { p.adaptive.reserved = whole(x); },
                          {0},
                          largeNumbers({}),
                          use.prepare,
                          {1}});
        addFlags(suite, {std::string("AgaaAdaptiveSampling.flags/flags") + use.variant, "AgaaAdaptiveSampling::flags",
                         [](ViewParts& p, uint64_t flags) { p.adaptive.flags = flags; },
                         AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING | AGAA_ADAPTIVE_PRINTED_METRIC |
                             AGAA_ADAPTIVE_IN_ORDER | AGAA_ADAPTIVE_EQUAL_WEIGHTS | AGAA_ADAPTIVE_LOOP |
                             AGAA_ADAPTIVE_DEVICE_PATTERN | AGAA_ADAPTIVE_BUCKETS | AGAA_ADAPTIVE_SORTED |
                             AGAA_ADAPTIVE_TILE_MAXIMUM | AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS | AGAA_ADAPTIVE_BACKGROUND |
                             AGAA_ADAPTIVE_LIGHTS,
                         use.prepare});
    }
}

// Tests "taa", and techniques that check the struct and do not use it.
void addTemporal(Suite& suite) {
    struct Use {
        const char* variant;
        void (*prepare)(ViewParts&);
    };
    for (const Use& use : {Use{"", [](ViewParts& p) { p.setTechnique("taa", 1); }}, Use{"/agaa", nullptr}}) {
        const auto add = [&](const char* promise, const char* member, void (*set)(ViewParts&, double), float least,
                             float most) {
            addMember(suite, {std::string("AgaaTemporal.") + promise + use.variant,
                              member,
                              set,
                              {least, above(least), double(most) / 2, below(most), most},
                              notNumbers({below(least), -1, above(most), 3e38}),
                              use.prepare});
        };
        add(
            "currentShare/range", "AgaaTemporal::currentShare",
            [](ViewParts& p, double x) { p.temporal.currentShare = float(x); }, 0.001f, 1);
        add(
            "clipDeviations/range", "AgaaTemporal::clipDeviations",
            [](ViewParts& p, double x) { p.temporal.clipDeviations = float(x); }, 0, 1e6f);
        add(
            "depthTolerance/range", "AgaaTemporal::depthTolerance",
            [](ViewParts& p, double x) { p.temporal.depthTolerance = float(x); }, 0, 1e6f);
        addMember(suite, {std::string("AgaaTemporal.reserved/zero") + use.variant,
                          "AgaaTemporal::reserved",
                          [](ViewParts& p, double x) { p.temporal.reserved = whole(x); },
                          {0},
                          largeNumbers({}),
                          use.prepare,
                          {1}});
        addFlags(suite, {std::string("AgaaTemporal.flags/flags") + use.variant, "AgaaTemporal::flags",
                         [](ViewParts& p, uint64_t flags) { p.temporal.flags = flags; }, AGAA_TEMPORAL_LAST_FRAME_ONLY,
                         use.prepare});
    }
}

void addMeasurement(Suite& suite) {
    addMember(suite, {"AgaaMeasurement.shadingCost/range",
                      "AgaaMeasurement::shadingCost",
                      [](ViewParts& p, double x) { p.measurement.shadingCost = whole(x); },
                      {1, 2, 63, 64},
                      largeNumbers({0, 65})});
    // The tier IDS supports all debug views.
    addMember(suite, {"AgaaMeasurement.debugView/enum",
                      "AgaaMeasurement::debugView",
                      [](ViewParts& p, double x) { p.measurement.debugView = whole(x); },
                      {AGAA_DEBUG_VIEW_NONE, AGAA_DEBUG_VIEW_EVENTS, AGAA_DEBUG_VIEW_AGGREGATES,
                       AGAA_DEBUG_VIEW_CLUSTERS, AGAA_DEBUG_VIEW_PRIMITIVES, AGAA_DEBUG_VIEW_LIT,
                       AGAA_DEBUG_VIEW_WIDENED, AGAA_DEBUG_VIEW_TIER, AGAA_DEBUG_VIEW_FACTS},
                      largeNumbers({}),
                      [](ViewParts& p) { p.chain(p.fetch); },
                      {AGAA_DEBUG_VIEW_FACTS + 1}});
    addMember(suite, {"AgaaMeasurement.seeds/enum",
                      "AgaaMeasurement::seeds",
                      [](ViewParts& p, double x) { p.measurement.seeds = whole(x); },
                      {AGAA_SEEDS_MAXIMIN, AGAA_SEEDS_SUM_OF_SQUARES},
                      largeNumbers({}),
                      nullptr,
                      {AGAA_SEEDS_SUM_OF_SQUARES + 1}});
    // Other values need capabilities of the device.
    addMember(suite, {"AgaaMeasurement.lanes/enum",
                      "AgaaMeasurement::lanes",
                      [](ViewParts& p, double x) { p.measurement.lanes = whole(x); },
                      {AGAA_LANES_AUTO, AGAA_LANES_PIXEL},
                      largeNumbers({}),
                      nullptr,
                      {AGAA_LANES_SAMPLE_SUBGROUP + 1}});
    addFlags(suite, {"AgaaMeasurement.flags/flags", "AgaaMeasurement::flags",
                     [](ViewParts& p, uint64_t flags) { p.measurement.flags = flags; },
                     AGAA_MEASURE_NO_DIFFUSE_FILTER | AGAA_MEASURE_NO_SHADOW_FILTER | AGAA_MEASURE_SHADOW_ALONG_DEPTH |
                         AGAA_MEASURE_NO_STENCIL | AGAA_MEASURE_FIRST_SAMPLE_ROUTING | AGAA_MEASURE_NO_LIGHT_CULLING |
                         AGAA_MEASURE_LIGHT_DIRECTIONS | AGAA_MEASURE_SHADOW_COVARIANCE | AGAA_MEASURE_STORED_DEPTH |
                         AGAA_MEASURE_DEPTH_PLANES,
                     nullptr});
    addMember(suite, {"AgaaMeasurement.diffuseFilter/enum",
                      "AgaaMeasurement::diffuseFilter",
                      [](ViewParts& p, double x) { p.measurement.diffuseFilter = whole(x); },
                      {AGAA_DIFFUSE_RECTIFIED, AGAA_DIFFUSE_SGGX},
                      largeNumbers({}),
                      nullptr,
                      {AGAA_DIFFUSE_SGGX + 1}});
    addMember(suite, {"AgaaMeasurement.reserved/zero",
                      "AgaaMeasurement::reserved",
                      [](ViewParts& p, double x) { p.measurement.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      nullptr,
                      {1}});
    suite.core("AGAA_MEASURE_SHADOW_COVARIANCE/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        for (const uint64_t other :
             {uint64_t(0), AGAA_MEASURE_SHADOW_ALONG_DEPTH, AGAA_MEASURE_STORED_DEPTH, AGAA_MEASURE_NO_SHADOW_FILTER}) {
            ViewParts parts(test.sdk, nullptr);
            parts.measurement.flags = AGAA_MEASURE_SHADOW_COVARIANCE | other;
            if (other)
                expectViewRefused(test, parts, AGAA_ERROR_INVALID_ARGUMENT, "two places of shadow taps",
                                  "SHADOW_COVARIANCE");
            else
                expectAccepted(test, parts, "AGAA_MEASURE_SHADOW_COVARIANCE");
        }
    });
    suite.core("AGAA_MEASURE_STORED_DEPTH/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        parts.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
        parts.measurement.flags = AGAA_MEASURE_STORED_DEPTH | AGAA_MEASURE_SHADOW_COVARIANCE;
        expectViewRefused(test, parts, AGAA_ERROR_INVALID_ARGUMENT, "two places of shadow taps", "SHADOW_COVARIANCE");
    });
    suite.core("AGAA_MEASURE_STORED_DEPTH/AGAA_ERROR_UNSUPPORTED", [](Test& test) {
        for (const auto& [technique, tier] :
             {std::pair{"agaa", AGAA_TIER_POST_DEPTH_ATOMICS}, std::pair{"agaa", AGAA_TIER_PER_SAMPLE},
              std::pair{"agaa", AGAA_TIER_GBUFFER}, std::pair{"sbaa", AGAA_TIER_POST_DEPTH_ATOMICS}}) {
            ViewParts parts(test.sdk, nullptr);
            parts.config.technique = technique;
            parts.config.generationTier = tier;
            parts.measurement.flags = AGAA_MEASURE_STORED_DEPTH;
            if (std::string_view(technique) == "agaa" && tier != AGAA_TIER_GBUFFER)
                expectAccepted(test, parts, "AGAA_MEASURE_STORED_DEPTH");
            else
                expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, "AGAA_MEASURE_STORED_DEPTH", "STORED_DEPTH");
        }
    });
    suite.core("AGAA_DIFFUSE_SGGX/AGAA_ERROR_UNSUPPORTED", [](Test& test) {
        for (const bool isLit : {false, true}) {
            ViewParts parts(test.sdk, nullptr);
            parts.facts.shadowMapCount = 1;
            parts.config.generationTier = AGAA_TIER_GBUFFER;
            parts.measurement.diffuseFilter = AGAA_DIFFUSE_SGGX;
            parts.aggregation.litShadows = isLit;
            if (isLit)
                expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, "AGAA_DIFFUSE_SGGX and litShadows",
                                  "litShadows");
            else
                expectAccepted(test, parts, "AGAA_DIFFUSE_SGGX");
        }
    });
}

} // namespace

void addConfigMemberCases(Suite& suite) {
    addConfig(suite);
    addTiers(suite);
    addAggregation(suite);
    addDecoupledCoverage(suite);
    addAdaptiveSampling(suite);
    addTemporal(suite);
    addMeasurement(suite);
    suite.core("AgaaConfig.layout/null", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        const std::string withNull = planText(test, parts);
        parts.useLayout();
        test.check(
            planText(test, parts) == withNull,
            "agaaPlanToJson with AgaaConfig::layout = null and with the layout \"precise\" writes different plans.");
    });
}

} // namespace agaa::conformance
