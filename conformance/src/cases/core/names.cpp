// Results, version, names.
#include "cases.h"
#include "log.h"
#include "structs.h"

#include <algorithm>
#include <cctype>
#include <climits>
#include <cstring>
#include <set>

namespace agaa::conformance {

namespace {

struct ResultRow {
    AgaaResult value;
    const char* name;
};

#define AGAA_RESULT(name)                                                                                              \
    { name, #name }
constexpr ResultRow results[] = {AGAA_RESULT(AGAA_OK),
                                 AGAA_RESULT(AGAA_NOT_READY),
                                 AGAA_RESULT(AGAA_ERROR_INVALID_ARGUMENT),
                                 AGAA_RESULT(AGAA_ERROR_VERSION),
                                 AGAA_RESULT(AGAA_ERROR_STRUCT),
                                 AGAA_RESULT(AGAA_ERROR_UNKNOWN_STRUCT),
                                 AGAA_RESULT(AGAA_ERROR_OUT_OF_RANGE),
                                 AGAA_RESULT(AGAA_ERROR_UNSUPPORTED),
                                 AGAA_RESULT(AGAA_ERROR_LAYOUT),
                                 AGAA_RESULT(AGAA_ERROR_TOO_LARGE),
                                 AGAA_RESULT(AGAA_ERROR_OUT_OF_MEMORY),
                                 AGAA_RESULT(AGAA_ERROR_DEVICE),
                                 AGAA_RESULT(AGAA_ERROR_CALLBACK),
                                 AGAA_RESULT(AGAA_ERROR_PARTIAL),
                                 AGAA_RESULT(AGAA_ERROR_WRONG_ORDER),
                                 AGAA_RESULT(AGAA_ERROR_BUFFER_TOO_SMALL),
                                 AGAA_RESULT(AGAA_ERROR_INTERNAL)};
#undef AGAA_RESULT
constexpr AgaaResult unknownResults[] = {INT_MIN, INT_MIN + 1, -1000000, 1000000, INT_MAX - 1, INT_MAX};

using TextOf = const char*(AGAA_CALL*)(uint32_t);

void testResultNames(Test& test) {
    for (const ResultRow& row : results) {
        const char* name = test.sdk.agaaResultName(row.value);
        test.check(name && std::string(name) == row.name,
                   "agaaResultName(" + std::to_string(row.value) + ") does not return " + row.name + ".");
    }
    for (const AgaaResult value : unknownResults) {
        const char* name = test.sdk.agaaResultName(value);
        test.check(name && std::string(name) == "unknown result",
                   "agaaResultName(" + std::to_string(value) + ") does not return \"unknown result\".");
    }
}

void testResultStrings(Test& test) {
    std::set<std::string> seen;
    for (const ResultRow& row : results) {
        const char* text = test.sdk.agaaResultString(row.value);
        const std::string call = std::string("agaaResultString(") + row.name + ")";
        test.require(text, call + " returns null.");
        test.check(std::strlen(text) > 0 && std::string(text) != "unknown result", call + " describes nothing.");
        test.check(seen.insert(text).second, call + " returns the text of another result.");
        test.check(test.sdk.agaaResultString(row.value) == text, call + " has no static storage: the pointer changes.");
    }
    for (const AgaaResult value : unknownResults) {
        const char* text = test.sdk.agaaResultString(value);
        test.check(text && std::string(text) == "unknown result",
                   "agaaResultString(" + std::to_string(value) + ") does not return \"unknown result\".");
    }
}

// Every value gives a pointer that is not null.
template <class Value> void testAnyValue(Test& test, const char* function, const char*(AGAA_CALL* call)(Value)) {
    for (int64_t i = -70000; i <= 70000; ++i)
        if (!test.check(call(Value(i)), std::string(function) + '(' + std::to_string(i) + ") returns null."))
            return;
    for (uint32_t bit = 0; bit < 32; ++bit)
        test.check(call(Value(1u << bit)), std::string(function) + '(' + std::to_string(1u << bit) + ") returns null.");
}

std::vector<std::string> namesOf(Test& test, uint32_t kind) {
    uint32_t count = 0;
    const std::string call = "agaaGetNames(" + std::to_string(kind) + ")";
    test.requireOk(test.sdk.agaaGetNames(kind, &count, nullptr), call + " with names = null");
    std::vector<const char*> names(count);
    test.requireOk(test.sdk.agaaGetNames(kind, &count, names.data()), call);
    test.check(count == names.size(), call + " returns another count with an array than without.");
    std::vector<std::string> texts;
    for (const char* name : names) {
        test.require(name, call + " writes a null name.");
        texts.push_back(name);
    }
    return texts;
}

constexpr uint32_t kinds[] = {AGAA_NAMES_TECHNIQUES, AGAA_NAMES_TIERS, AGAA_NAMES_STAGES, AGAA_NAMES_LAYOUTS,
                              AGAA_NAMES_PRESETS};

void testLists(Test& test) {
    for (const uint32_t kind : kinds) {
        const std::vector<std::string> names = namesOf(test, kind);
        const std::string call = "agaaGetNames(" + std::to_string(kind) + ")";
        test.check(!names.empty(), call + " lists nothing.");
        test.check(std::set<std::string>(names.begin(), names.end()).size() == names.size(),
                   call + " lists a name twice.");
        for (const std::string& name : names)
            test.check(std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isupper(c); }),
                       call + " lists \"" + name + "\", which is not lower case.");
    }
    const auto expect = [&](uint32_t kind, std::initializer_list<const char*> promised) {
        const std::vector<std::string> names = namesOf(test, kind);
        for (const char* name : promised)
            test.check(std::find(names.begin(), names.end(), name) != names.end(),
                       "agaaGetNames(" + std::to_string(kind) + ") does not list \"" + name + "\".");
    };
    expect(AGAA_NAMES_TECHNIQUES, {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                   "sbaa", "agaa", "dcaa", "sgbc", "adaptive"});
    expect(AGAA_NAMES_LAYOUTS, {"paper16", "precise"});
    expect(AGAA_NAMES_PRESETS, {"paper", "fast", "balanced", "accurate"});
}

void testNamesInvalid(Test& test) {
    uint32_t count = 77;
    for (const uint32_t kind : {0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
        expectRefused(test, test.sdk.agaaGetNames(kind, &count, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                      "agaaGetNames(" + std::to_string(kind) + ")");
        test.check(count == 77, "agaaGetNames with an unknown kind changes count.");
    }
    if (isSameVersion(test))
        expectRefused(test, test.sdk.agaaGetNames(AGAA_NAMES_PRESETS + 1, &count, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                      "agaaGetNames(AGAA_NAMES_PRESETS + 1)");
    const char* names[64] = {};
    expectRefused(test, test.sdk.agaaGetNames(AGAA_NAMES_TIERS, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  "agaaGetNames with count = null");
    expectRefused(test, test.sdk.agaaGetNames(AGAA_NAMES_TIERS, nullptr, names), AGAA_ERROR_INVALID_ARGUMENT,
                  "agaaGetNames with count = null and an array");
    test.check(names[0] == nullptr, "agaaGetNames with count = null writes names.");
}

void testNamesTooSmall(Test& test) {
    for (const uint32_t kind : kinds) {
        const uint32_t needed = uint32_t(namesOf(test, kind).size());
        std::vector<const char*> names(needed + 1, nullptr);
        for (const uint32_t length : {0u, needed - 1}) {
            uint32_t count = length;
            expectRefused(test, test.sdk.agaaGetNames(kind, &count, names.data()), AGAA_ERROR_BUFFER_TOO_SMALL,
                          "agaaGetNames(" + std::to_string(kind) + ") with " + std::to_string(length) + " elements");
            test.check(count == length && !names[0], "agaaGetNames with an array that is too short writes.");
        }
        uint32_t count = needed + 1;
        test.requireOk(test.sdk.agaaGetNames(kind, &count, names.data()), "agaaGetNames with a longer array");
        test.check(count == needed && !names[needed],
                   "agaaGetNames with a longer array does not return the number of names.");
    }
}

void testJitter(Test& test) {
    for (const uint32_t count : {1u, 2u, 4u, 8u, 16u, 1024u})
        for (uint64_t i = 0; i < 2 * uint64_t(count); ++i) {
            float jitter[2] = {7, 7}, again[2];
            test.requireOk(test.sdk.agaaGetJitter(i, count, jitter), "agaaGetJitter");
            test.requireOk(test.sdk.agaaGetJitter(i + (UINT64_C(1) << 40) * count, count, again), "agaaGetJitter");
            test.check(jitter[0] == again[0] && jitter[1] == again[1], "agaaGetJitter does not repeat its positions.");
            for (const float x : jitter)
                test.check(x > -0.5f && x < 0.5f, "agaaGetJitter leaves the pixel.");
            if (count == 1)
                test.check(jitter[0] == 0 && jitter[1] == 0, "One position is not the centre.");
        }
}

void testJitterErrors(Test& test) {
    expectRefused(test, test.sdk.agaaGetJitter(0, 4, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  "agaaGetJitter with outJitter = null");
}

void testJitterRange(Test& test) {
    for (const uint32_t count : {0u, 1025u, 0xFFFFFFFFu}) {
        float jitter[2] = {7, 7};
        expectRefused(test, test.sdk.agaaGetJitter(0, count, jitter), AGAA_ERROR_OUT_OF_RANGE,
                      "agaaGetJitter with count = " + std::to_string(count));
        test.check(jitter[0] == 7 && jitter[1] == 7, "agaaGetJitter writes on failure.");
    }
}

struct NamedTier {
    uint32_t tier;
    const char* part; // part of the name
};
constexpr NamedTier tiers[] = {{AGAA_TIER_AUTO, "auto"},
                               {AGAA_TIER_NATIVE, "native"},
                               {AGAA_TIER_NV_MULTICAST, "multicast"},
                               {AGAA_TIER_SCALED_TARGET, "scaled"},
                               {AGAA_TIER_LAYERS, "layers"},
                               {AGAA_TIER_ORDERED_GRID, "grid"},
                               {AGAA_TIER_NV_MIXED_SAMPLES, "mixed"},
                               {AGAA_TIER_POST_DEPTH_ATOMICS, "post"},
                               {AGAA_TIER_PER_SAMPLE, "per"},
                               {AGAA_TIER_GBUFFER, "gbuffer"},
                               {AGAA_TIER_IDS, "ids"},
                               {AGAA_TIER_FRAGMENT_LISTS, "lists"},
                               {AGAA_TIER_FRAGMENTS, "fragments"},
                               {AGAA_TIER_MATERIAL_LISTS, "material"},
                               {AGAA_TIER_FRAGMENT_INTERLOCK, "interlock"},
                               {AGAA_TIER_RASTER_ORDER, "raster"}};
constexpr NamedTier stages[] = {{AGAA_STAGE_PREPASS, "prepass"},
                                {AGAA_STAGE_DEFINITION, "definition"},
                                {AGAA_STAGE_GENERATION, "generation"},
                                {AGAA_STAGE_SHADING, "shading"},
                                {AGAA_STAGE_OTHER, "other"}};

// Each value has the name that agaaGetNames lists; other values are "unknown".
template <size_t n>
void testValueNames(Test& test, const char* function, TextOf call, const NamedTier (&rows)[n], uint32_t kind) {
    const std::vector<std::string> listed = namesOf(test, kind);
    for (const NamedTier& row : rows) {
        const char* name = call(row.tier);
        const std::string what = std::string(function) + '(' + std::to_string(row.tier) + ")";
        test.require(name, what + " returns null.");
        test.check(std::string(name).find(row.part) != std::string::npos, what + " returns \"" + name + "\".");
        test.check(std::find(listed.begin(), listed.end(), name) != listed.end(),
                   what + " returns \"" + name + "\", which agaaGetNames does not list.");
        test.check(call(row.tier) == name, what + " has no static storage: the pointer changes.");
    }
    for (const uint32_t value : {0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
        const char* name = call(value);
        test.check(name && std::string(name) == "unknown",
                   std::string(function) + '(' + std::to_string(value) + ") does not return \"unknown\".");
    }
}

std::string swapped(std::string name) {
    for (char& c : name)
        c = c == '-' ? '_' : c == '_' ? '-' : c;
    return name;
}

void testTierFromName(Test& test) {
    for (const NamedTier& row : tiers) {
        const std::string name = test.sdk.agaaTierName(row.tier);
        for (const std::string& spelling : {name, swapped(name)}) {
            uint32_t tier = 99;
            test.result(test.sdk.agaaTierFromName(spelling.c_str(), &tier), AGAA_OK,
                        "agaaTierFromName(\"" + spelling + "\")");
            test.check(tier == row.tier, "agaaTierFromName(\"" + spelling + "\") finds another tier.");
        }
    }
}

void testTierFromNameRefused(Test& test, bool checksOutput) {
    for (const char* name : {"", "unknown", "GBUFFER", "gbuffe", "gbufferr", " ids", "mlaa"}) {
        uint32_t tier = 0xABCDEF01;
        const AgaaResult result = test.sdk.agaaTierFromName(name, &tier);
        if (checksOutput)
            test.check(tier == 0xABCDEF01,
                       std::string("agaaTierFromName(\"") + name + "\") fails and changes outTier.");
        else
            expectRefused(test, result, AGAA_ERROR_INVALID_ARGUMENT, std::string("agaaTierFromName(\"") + name + "\")");
    }
    uint32_t tier = 0xABCDEF01;
    expectRefused(test, test.sdk.agaaTierFromName(nullptr, &tier), AGAA_ERROR_INVALID_ARGUMENT,
                  "agaaTierFromName(null, …)");
    test.check(tier == 0xABCDEF01, "agaaTierFromName(null, …) changes outTier.");
    expectRefused(test, test.sdk.agaaTierFromName("ids", nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  "agaaTierFromName(\"ids\", null)");
}

void addTierCases(Suite& suite) {
    suite.core("agaaTierName/returns", [](Test& test) {
        testValueNames(test, "agaaTierName", test.sdk.agaaTierName, tiers, AGAA_NAMES_TIERS);
    });
    suite.core("agaaStageName/returns", [](Test& test) {
        testValueNames(test, "agaaStageName", test.sdk.agaaStageName, stages, AGAA_NAMES_STAGES);
    });
    suite.core("agaaTierName/no_errors", [](Test& test) { testAnyValue(test, "agaaTierName", test.sdk.agaaTierName); });
    suite.core("agaaStageName/no_errors",
               [](Test& test) { testAnyValue(test, "agaaStageName", test.sdk.agaaStageName); });
    suite.core("agaaTierFromName/names", testTierFromName);
    suite.core("agaaTierFromName/outTier.unchanged", [](Test& test) { testTierFromNameRefused(test, true); });
    suite.core("agaaTierFromName/AGAA_ERROR_INVALID_ARGUMENT",
               [](Test& test) { testTierFromNameRefused(test, false); });
}

} // namespace

void addNameCases(Suite& suite) {
    suite.core("agaaResultName/returns", testResultNames);
    suite.core("agaaResultString/returns", testResultStrings);
    suite.core("agaaResultName/no_errors",
               [](Test& test) { testAnyValue(test, "agaaResultName", test.sdk.agaaResultName); });
    suite.core("agaaResultString/no_errors",
               [](Test& test) { testAnyValue(test, "agaaResultString", test.sdk.agaaResultString); });
    suite.core("agaaGetVersion/no_errors", [](Test& test) {
        const uint32_t version = test.sdk.agaaGetVersion();
        test.check(version >> 12 == AGAA_HEADER_VERSION >> 12,
                   "agaaGetVersion: the library has another major or minor version than the suite's headers.");
        test.check(test.sdk.agaaGetVersion() == version, "agaaGetVersion returns different versions.");
    });
    suite.core("agaaGetJitter/outJitter.unchanged", testJitterRange);
    suite.core("agaaGetJitter/AGAA_ERROR_OUT_OF_RANGE", testJitter);
    suite.core("agaaGetJitter/AGAA_ERROR_INVALID_ARGUMENT", testJitterErrors);
    suite.core("agaaGetNames/names.null", testLists);
    suite.core("agaaGetNames/AGAA_ERROR_INVALID_ARGUMENT", testNamesInvalid);
    suite.core("agaaGetNames/AGAA_ERROR_BUFFER_TOO_SMALL", testNamesTooSmall);
    addTierCases(suite);
}

} // namespace agaa::conformance
