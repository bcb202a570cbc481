// agaaGetBuiltinLayout and agaaApplyPreset.
#include "cases.h"
#include "structs.h"
#include "view_parts.h"

#include <cstring>

namespace agaa::conformance {

namespace {

// ---- layouts -------------------------------------------------------------------------------------

const AgaaLayoutAttribute* find(const AgaaLayout& layout, uint32_t semantic) {
    for (uint32_t i = 0; i < layout.attributeCount; ++i)
        if (layout.attributes[i].semantic == semantic)
            return &layout.attributes[i];
    return nullptr;
}

void testLayouts(Test& test) {
    for (const char* name : {"precise", "paper16"}) {
        ViewParts parts(test.sdk, nullptr);
        test.requireOk(test.sdk.agaaGetBuiltinLayout(name, &parts.layout),
                       std::string("agaaGetBuiltinLayout(\"") + name + "\")");
        parts.useLayout();
        expectAccepted(test, parts, std::string("the layout \"") + name + '"');
        const AgaaLayoutAttribute* emissive = find(parts.layout, AGAA_SEMANTIC_EMISSIVE);
        test.check(emissive && emissive->range == 16.0f,
                   std::string("the range of emission of \"") + name + "\" is not 16.");
    }
    AgaaLayout precise = AGAA_LAYOUT_INIT;
    test.requireOk(test.sdk.agaaGetBuiltinLayout("precise", &precise), "agaaGetBuiltinLayout(\"precise\")");
    for (uint32_t i = 0; i < precise.attributeCount; ++i) {
        const AgaaLayoutAttribute& a = precise.attributes[i];
        const uint32_t promised = a.semantic == AGAA_SEMANTIC_SPECULAR ? 10 : 16;
        test.check(a.sampleBits == promised, "\"precise\" has " + std::to_string(a.sampleBits) +
                                                 " bits per channel of semantic " + std::to_string(a.semantic) +
                                                 " where " + std::to_string(promised) + " are promised.");
    }
}

AgaaLayout patternLayout() {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    std::memset(&layout.attributeCount, 0x5A, sizeof layout - offsetof(AgaaLayout, attributeCount));
    return layout;
}

struct WrongLayoutCall {
    const char* what;
    AgaaResult expected;
    const char* name;
    std::function<void(AgaaLayout&)> corrupt;
};

const WrongLayoutCall wrongLayoutCalls[] = {
    {"name = null", AGAA_ERROR_INVALID_ARGUMENT, nullptr, [](AgaaLayout&) {}},
    {"outLayout that is not initialised", AGAA_ERROR_STRUCT, "precise", [](AgaaLayout& l) { l.sType = 0; }},
    {"outLayout that is too small", AGAA_ERROR_STRUCT, "precise", [](AgaaLayout& l) { l.structSize -= 8; }},
    {"the name \"mlaa\"", AGAA_ERROR_LAYOUT, "mlaa", [](AgaaLayout&) {}},
    {"the name \"\"", AGAA_ERROR_LAYOUT, "", [](AgaaLayout&) {}},
    {"the name \"PRECISE\"", AGAA_ERROR_LAYOUT, "PRECISE", [](AgaaLayout&) {}},
    {"the name \"precise \"", AGAA_ERROR_LAYOUT, "precise ", [](AgaaLayout&) {}},
};

// Runs the rows of the error `expected`. 0 selects all rows and checks that the output is unchanged.
void testWrongLayoutCalls(Test& test, AgaaResult expected) {
    for (const WrongLayoutCall& row : wrongLayoutCalls) {
        AgaaLayout layout = patternLayout();
        row.corrupt(layout);
        const AgaaLayout before = layout;
        const AgaaResult result = test.sdk.agaaGetBuiltinLayout(row.name, &layout);
        if (expected == row.expected)
            test.result(result, row.expected, std::string("agaaGetBuiltinLayout with ") + row.what);
        if (expected == AGAA_OK)
            test.check(isSameBytes(before, layout),
                       std::string("agaaGetBuiltinLayout with ") + row.what + " changes outLayout.");
    }
}

// ---- presets -------------------------------------------------------------------------------------

struct Settings {
    AgaaConfig config;
    AgaaAggregation aggregation;
    AgaaMeasurement measurement;
};

// Every member has a value that no preset sets.
Settings patternSettings() {
    const AgaaConfig config = AGAA_CONFIG_INIT;
    const AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    const AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
    Settings s = {config, aggregation, measurement};
    const auto fill = [](auto& value) {
        constexpr size_t header = sizeof(AgaaStructHeader);
        std::memset(reinterpret_cast<char*>(&value) + header, 0x5A, sizeof value - header);
    };
    fill(s.config);
    fill(s.aggregation);
    fill(s.measurement);
    s.config.technique = "ssaa";
    s.config.layout = nullptr;
    return s;
}

constexpr uint64_t configFlags = AGAA_CONFIG_SPLIT_SURFACES | AGAA_CONFIG_FINE_MATERIALS;
constexpr uint64_t measurementFlags = AGAA_MEASURE_NO_DIFFUSE_FILTER | AGAA_MEASURE_NO_SHADOW_FILTER |
                                      AGAA_MEASURE_SHADOW_ALONG_DEPTH | AGAA_MEASURE_FIRST_SAMPLE_ROUTING |
                                      AGAA_MEASURE_SHADOW_COVARIANCE | AGAA_MEASURE_STORED_DEPTH;

// Copies the members that a preset sets from `from`. All other members must then be equal.
void copyPresetMembers(Settings& s, const Settings& from) {
    s.config.technique = from.config.technique;
    s.config.aggregates = from.config.aggregates;
    s.config.surfaceCosine = from.config.surfaceCosine;
    s.config.surfaceDistance = from.config.surfaceDistance;
    s.config.surfaceMaterial = from.config.surfaceMaterial;
    s.config.shadowTaps = from.config.shadowTaps;
    s.config.ndf = from.config.ndf;
    s.config.flags = (s.config.flags & ~configFlags) | (from.config.flags & configFlags);
    s.aggregation.aggregateThreshold = from.aggregation.aggregateThreshold;
    s.aggregation.litShadows = from.aggregation.litShadows;
    s.aggregation.glossWeight = from.aggregation.glossWeight;
    s.measurement.seeds = from.measurement.seeds;
    s.measurement.flags = (s.measurement.flags & ~measurementFlags) | (from.measurement.flags & measurementFlags);
}

constexpr const char* presetNames[] = {"paper", "fast", "balanced", "accurate"};

void testPresetKeepsOthers(Test& test) {
    for (const char* name : presetNames) {
        Settings s = patternSettings();
        const Settings before = s;
        const std::string call = std::string("agaaApplyPreset(\"") + name + "\")";
        test.requireOk(test.sdk.agaaApplyPreset(name, &s.config, &s.aggregation, &s.measurement), call);
        test.check(std::string(s.config.technique) == "agaa", call + " does not set the technique to \"agaa\".");
        Settings expected = before;
        copyPresetMembers(expected, s);
        test.check(isSameBytes(expected.config, s.config),
                   call + " changes a member of AgaaConfig that it does not receive.");
        test.check(isSameBytes(expected.aggregation, s.aggregation),
                   call + " changes a member of AgaaAggregation that it does not receive.");
        test.check(isSameBytes(expected.measurement, s.measurement),
                   call + " changes a member of AgaaMeasurement that it does not receive.");
    }
}

// Presets leave out what the tier cannot have, so that the queries accept them.
void testPresetFitsTier(Test& test) {
    for (const char* name : presetNames)
        for (const uint32_t tier :
             {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
            for (const uint64_t flags : {UINT64_C(0), AGAA_CONFIG_BUFFERED}) {
                ViewParts parts(test.sdk, nullptr);
                parts.config.generationTier = tier;
                parts.config.flags |= flags;
                const std::string call = std::string("agaaApplyPreset(\"") + name + "\")";
                test.requireOk(test.sdk.agaaApplyPreset(name, &parts.config, &parts.aggregation, &parts.measurement),
                               call);
                parts.chain(parts.fetch);
                const std::string what = call + ", the tier " + std::to_string(tier) + " and the flags " +
                                         std::to_string(parts.config.flags);
                expectAccepted(test, parts, what);
                const bool isTwoPasses = tier == AGAA_TIER_POST_DEPTH_ATOMICS || tier == AGAA_TIER_PER_SAMPLE;
                const bool groups = std::string(name) == "balanced" || std::string(name) == "accurate";
                test.check((parts.aggregation.glossWeight > 0) == (groups && !isTwoPasses), what + ": glossWeight");
                test.check((parts.aggregation.litShadows != 0) == (groups && !isTwoPasses && !flags),
                           what + ": litShadows");
            }
}

// The result does not depend on the previous settings, and the queries accept it.
void testPresetIsComplete(Test& test) {
    for (const char* name : presetNames) {
        ViewParts parts(test.sdk, nullptr);
        Settings pattern = patternSettings();
        pattern.config.generationTier = AGAA_TIER_AUTO; // presets read it, and BUFFERED
        pattern.config.flags &= ~AGAA_CONFIG_BUFFERED;
        const std::string call = std::string("agaaApplyPreset(\"") + name + "\")";
        test.requireOk(test.sdk.agaaApplyPreset(name, &parts.config, &parts.aggregation, &parts.measurement), call);
        test.requireOk(test.sdk.agaaApplyPreset(name, &pattern.config, &pattern.aggregation, &pattern.measurement),
                       call);
        Settings values = {parts.config, parts.aggregation, parts.measurement};
        Settings after = values;
        copyPresetMembers(after, pattern);
        after.config.technique = values.config.technique;
        test.check(isSameBytes(after.config, values.config) && isSameBytes(after.aggregation, values.aggregation) &&
                       isSameBytes(after.measurement, values.measurement),
                   call + " gives other settings if members had other values.");
        expectAccepted(test, parts, std::string("the preset \"") + name + '"');
    }
}

void testPresetMeasurementNull(Test& test) {
    for (const char* name : {"fast", "balanced", "accurate"}) {
        Settings s = patternSettings();
        test.result(test.sdk.agaaApplyPreset(name, &s.config, &s.aggregation, nullptr), AGAA_OK,
                    std::string("agaaApplyPreset(\"") + name + "\") with measurement = null");
    }
    Settings s = patternSettings();
    test.result(test.sdk.agaaApplyPreset("paper", &s.config, &s.aggregation, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                "agaaApplyPreset(\"paper\") with measurement = null");
}

const AgaaStructHeader unknownStruct = {farStructType, sizeof(AgaaStructHeader), nullptr};

struct WrongPreset {
    const char* what;
    AgaaResult expected;
    const char* name;
    uint32_t nulls; // bit i: pointer i is null
    std::function<void(Settings&)> corrupt;
};

const WrongPreset wrongPresets[] = {
    {"name = null", AGAA_ERROR_INVALID_ARGUMENT, nullptr, 0, [](Settings&) {}},
    {"config = null", AGAA_ERROR_INVALID_ARGUMENT, "fast", 1, [](Settings&) {}},
    {"aggregation = null", AGAA_ERROR_INVALID_ARGUMENT, "fast", 2, [](Settings&) {}},
    {"measurement = null and \"paper\"", AGAA_ERROR_INVALID_ARGUMENT, "paper", 4, [](Settings&) {}},
    {"the name \"mlaa\"", AGAA_ERROR_INVALID_ARGUMENT, "mlaa", 0, [](Settings&) {}},
    {"the name \"\"", AGAA_ERROR_INVALID_ARGUMENT, "", 0, [](Settings&) {}},
    {"the name \"FAST\"", AGAA_ERROR_INVALID_ARGUMENT, "FAST", 0, [](Settings&) {}},
    {"AgaaConfig::sType = 0", AGAA_ERROR_STRUCT, "paper", 0, [](Settings& s) { s.config.sType = 0; }},
    {"AgaaAggregation::structSize = 0", AGAA_ERROR_STRUCT, "paper", 0,
     [](Settings& s) { s.aggregation.structSize = 0; }},
    {"AgaaMeasurement::sType = 0", AGAA_ERROR_STRUCT, "paper", 0, [](Settings& s) { s.measurement.sType = 0; }},
    {"an unknown struct chained to AgaaConfig", AGAA_ERROR_UNKNOWN_STRUCT, "paper", 0,
     [](Settings& s) { s.config.pNext = &unknownStruct; }},
    {"an unknown struct chained to AgaaAggregation", AGAA_ERROR_UNKNOWN_STRUCT, "paper", 0,
     [](Settings& s) { s.aggregation.pNext = &unknownStruct; }},
    {"an unknown struct chained to AgaaMeasurement", AGAA_ERROR_UNKNOWN_STRUCT, "paper", 0,
     [](Settings& s) { s.measurement.pNext = &unknownStruct; }},
};

// On failure all structs keep their values.
void testWrongPresets(Test& test, AgaaResult expected) {
    for (const WrongPreset& row : wrongPresets) {
        if (row.expected != expected)
            continue;
        Settings s = patternSettings();
        row.corrupt(s);
        const Settings before = s;
        const AgaaResult result = test.sdk.agaaApplyPreset(row.name, row.nulls & 1 ? nullptr : &s.config,
                                                           row.nulls & 2 ? nullptr : &s.aggregation,
                                                           row.nulls & 4 ? nullptr : &s.measurement);
        const std::string call = std::string("agaaApplyPreset with ") + row.what;
        test.result(result, expected, call);
        test.check(isSameBytes(before, s), call + " fails and changes a struct.");
    }
}

} // namespace

void addPresetCases(Suite& suite) {
    suite.core("agaaGetBuiltinLayout/layouts", testLayouts);
    suite.core("agaaGetBuiltinLayout/outLayout.unchanged", [](Test& test) { testWrongLayoutCalls(test, AGAA_OK); });
    suite.core("agaaGetBuiltinLayout/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        testWrongLayoutCalls(test, AGAA_ERROR_INVALID_ARGUMENT);
        test.result(test.sdk.agaaGetBuiltinLayout("precise", nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                    "agaaGetBuiltinLayout with outLayout = null");
    });
    suite.core("agaaGetBuiltinLayout/AGAA_ERROR_STRUCT",
               [](Test& test) { testWrongLayoutCalls(test, AGAA_ERROR_STRUCT); });
    suite.core("agaaGetBuiltinLayout/AGAA_ERROR_LAYOUT",
               [](Test& test) { testWrongLayoutCalls(test, AGAA_ERROR_LAYOUT); });
    suite.core("agaaApplyPreset/other_members", testPresetKeepsOthers);
    suite.core("agaaApplyPreset/all_settings", testPresetIsComplete);
    suite.core("agaaApplyPreset/tiers", testPresetFitsTier);
    suite.core("agaaApplyPreset/measurement.null", testPresetMeasurementNull);
    for (const auto& [name, error] :
         {std::pair<const char*, AgaaResult>{"INVALID_ARGUMENT", AGAA_ERROR_INVALID_ARGUMENT},
          {"STRUCT", AGAA_ERROR_STRUCT},
          {"UNKNOWN_STRUCT", AGAA_ERROR_UNKNOWN_STRUCT}})
        suite.core(std::string("agaaApplyPreset/AGAA_ERROR_") + name,
                   [error = error](Test& test) { testWrongPresets(test, error); });
}

} // namespace agaa::conformance
