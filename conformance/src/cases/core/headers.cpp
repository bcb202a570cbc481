// The calls with each struct that functions without a device take.
#include "cases.h"
#include "goal_parts.h"
#include "header_check.h"
#include "view_parts.h"

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

namespace {

template <class T> T& as(void* structure) { return *static_cast<T*>(structure); }

AgaaResult memory(Test& test, const ViewParts& parts, const AgaaLog* log) {
    return test.sdk.agaaQueryMemory(parts.get(), nullptr, log, nullptr, nullptr, nullptr);
}

// A struct that is chained to AgaaConfig or AgaaViewDesc of a view with the default chain of the config.
HeaderCase chainedCase(const char* name, std::function<void(ViewParts&, void*)> link,
                       std::function<void(Test&, void*)> fill = nullptr) {
    const auto call = [link](Test& test, void* structure, const AgaaLog* log) {
        ViewParts parts(test.sdk, nullptr);
        parts.facts.shadowMapCount = 1;
        parts.config.pNext = nullptr;
        link(parts, structure);
        return memory(test, parts, log);
    };
    return {name, "agaaQueryMemory", fill, call, false, true, true};
}

void linkConfig(ViewParts& parts, void* structure) { parts.config.pNext = structure; }
void linkView(ViewParts& parts, void* structure) { parts.desc.pNext = structure; }

// Calls an array whose `count` elements have the bytes of a case's struct, and returns those of the first.
template <class T, class Call> AgaaResult callArray(uint32_t count, void* structure, const Call& call) {
    const size_t bytes = sizeof(T) + spareBytes;
    const size_t stride = std::max<size_t>(as<AgaaStructHeader>(structure).structSize, 8);
    Bytes array((count - 1) * stride + bytes);
    for (uint32_t i = 0; i < count; ++i)
        std::memcpy(array.data() + i * stride, structure, i + 1 < count ? stride : bytes);
    const AgaaResult result = call(reinterpret_cast<T*>(array.data()));
    std::memcpy(structure, array.data(), stride);
    return result;
}

AgaaResult callSurfaces(Test& test, void* structure, const AgaaLog* log) {
    ViewParts parts(test.sdk, nullptr);
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, nullptr, &count, nullptr),
                   "agaaQueryMemory with surfaces = null");
    return callArray<AgaaSurface>(count, structure, [&](AgaaSurface* array) {
        return test.sdk.agaaQueryMemory(&parts.desc, nullptr, log, nullptr, &count, array);
    });
}

AgaaResult callCapabilities(Test& test, void* structure, const AgaaLog*) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryCapabilities(nullptr, &count, nullptr),
                   "agaaQueryCapabilities with capabilities = null");
    return callArray<AgaaCapability>(count, structure, [&](AgaaCapability* array) {
        return test.sdk.agaaQueryCapabilities(nullptr, &count, array);
    });
}

AgaaResult callPreset(Test& test, AgaaConfig* config, AgaaAggregation* aggregation, AgaaMeasurement* measurement) {
    AgaaConfig defaultConfig = AGAA_CONFIG_INIT;
    AgaaAggregation defaultAggregation = AGAA_AGGREGATION_INIT;
    AgaaMeasurement defaultMeasurement = AGAA_MEASUREMENT_INIT;
    return test.sdk.agaaApplyPreset("paper", config ? config : &defaultConfig,
                                    aggregation ? aggregation : &defaultAggregation,
                                    measurement ? measurement : &defaultMeasurement);
}

template <class T> void copyMembers(void* structure, const T& from) {
    constexpr size_t header = sizeof(AgaaStructHeader);
    std::memcpy(static_cast<char*>(structure) + header, reinterpret_cast<const char*>(&from) + header,
                sizeof from - header);
}

AgaaResult callPrices(Test& test, void* structure, const AgaaLog* log) {
    ViewParts parts(test.sdk, nullptr);
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryPrices(&parts.desc, nullptr, nullptr, &count, nullptr),
                   "agaaQueryPrices with prices = null");
    return callArray<AgaaPrice>(count, structure, [&](AgaaPrice* array) {
        return test.sdk.agaaQueryPrices(&parts.desc, nullptr, log, &count, array);
    });
}

std::vector<HeaderCase> inputs() {
    return {
        {"AgaaLog", "agaaGetCoverageGlsl", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             as<AgaaLog>(structure).callback = log->callback;
             as<AgaaLog>(structure).user = log->user;
             size_t size = 0;
             return test.sdk.agaaGetCoverageGlsl(&as<AgaaLog>(structure), &size, nullptr);
         }},
        {"AgaaLayout", "agaaQueryMemory",
         [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).layout); },
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             parts.config.layout = &as<AgaaLayout>(structure);
             return memory(test, parts, log);
         }},
        {"AgaaConfig", "agaaQueryMemory", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             parts.desc.config = &as<AgaaConfig>(structure);
             return memory(test, parts, log);
         },
         false, true, false, "AgaaAggregation"},
        chainedCase("AgaaAggregation", linkConfig),
        chainedCase("AgaaMeasurement", linkConfig),
        chainedCase("AgaaDecoupledCoverage", linkConfig),
        chainedCase("AgaaAdaptiveSampling", linkConfig),
        chainedCase("AgaaTemporal", linkConfig),
        {"AgaaSceneFacts", "agaaQueryMemory", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             parts.desc.facts = &as<AgaaSceneFacts>(structure);
             return memory(test, parts, log);
         }},
        {"AgaaViewDesc", "agaaQueryMemory", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             copyMembers(structure, parts.desc);
             return test.sdk.agaaQueryMemory(&as<AgaaViewDesc>(structure), nullptr, log, nullptr, nullptr, nullptr);
         },
         false, true, false, "AgaaGBufferFunction"},
        chainedCase("AgaaGBufferFunction", linkView,
                    [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).gbuffer); }),
        chainedCase("AgaaFetchFunction", linkView,
                    [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).fetch); }),
        chainedCase("AgaaShadowFunction", linkView,
                    [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).shadow); }),
        chainedCase("AgaaResolvedOutputs", linkView,
                    [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).outputs); }),
        chainedCase("AgaaShadingFunction", linkView,
                    [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).shading); }),
        {"AgaaDeviceCaps", "agaaQueryMemory",
         [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).caps); },
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             return test.sdk.agaaQueryMemory(&parts.desc, &as<AgaaDeviceCaps>(structure), log, nullptr, nullptr,
                                             nullptr);
         }},
        {"AgaaGoal", "agaaChooseSettings", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             return test.sdk.agaaChooseSettings(parts.get(), nullptr, log, &as<AgaaGoal>(structure), nullptr, nullptr,
                                                &parts.choice);
         }},
        {"AgaaMeasuredSettings", "agaaChooseSettings",
         [](Test& test, void* structure) { copyMembers(structure, GoalParts(test.sdk).measured[0]); },
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             parts.goal.measured = &as<AgaaMeasuredSettings>(structure);
             parts.goal.measuredCount = 1;
             return parts.choose(test, log);
         }},
        {"AgaaObservation", "agaaChooseSettings", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             return test.sdk.agaaChooseSettings(parts.get(), nullptr, log, &parts.goal, &as<AgaaObservation>(structure),
                                                nullptr, &parts.choice);
         }},
    };
}

std::vector<HeaderCase> outputs() {
    return {
        {"AgaaMemoryReport", "agaaQueryMemory", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             return test.sdk.agaaQueryMemory(&parts.desc, nullptr, log, &as<AgaaMemoryReport>(structure), nullptr,
                                             nullptr);
         },
         true},
        {"AgaaTarget", "agaaQueryTarget", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             ViewParts parts(test.sdk, nullptr);
             return test.sdk.agaaQueryTarget(&parts.desc, nullptr, log, &as<AgaaTarget>(structure));
         },
         true},
        {"AgaaSurface", "agaaQueryMemory", nullptr, callSurfaces, true},
        {"AgaaPrice", "agaaQueryPrices", nullptr, callPrices, true},
        {"AgaaChoice", "agaaChooseSettings", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             return test.sdk.agaaChooseSettings(parts.get(), nullptr, log, &parts.goal, nullptr, nullptr,
                                                &as<AgaaChoice>(structure));
         },
         true},
        {"AgaaCapability", "agaaQueryCapabilities", nullptr, callCapabilities, true, false},
        {"AgaaVkRequirements", "agaaVkGetRequirements", nullptr,
         [](Test& test, void* structure, const AgaaLog*) {
             return test.sdk.agaaVkGetRequirements(&as<AgaaVkRequirements>(structure));
         },
         true, false},
        {"AgaaGlRequirements", "agaaGlGetRequirements", nullptr,
         [](Test& test, void* structure, const AgaaLog*) {
             return test.sdk.agaaGlGetRequirements(&as<AgaaGlRequirements>(structure));
         },
         true, false},
    };
}

// Structs that a second function takes. The names of their tests have the struct and the function.
std::vector<HeaderCase> further() {
    return {
        {"AgaaObservation", "agaaObserve", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             return test.sdk.agaaObserve(parts.get(), nullptr, log, &parts.statistics, &as<AgaaObservation>(structure));
         },
         true},
        {"AgaaChoice", "agaaChooseSettings", nullptr,
         [](Test& test, void* structure, const AgaaLog* log) {
             GoalParts parts(test.sdk);
             return test.sdk.agaaChooseSettings(parts.get(), nullptr, log, &parts.goal, nullptr,
                                                &as<AgaaChoice>(structure), &parts.choice);
         }},
        {"AgaaLayout", "agaaGetBuiltinLayout", nullptr,
         [](Test& test, void* structure, const AgaaLog*) {
             return test.sdk.agaaGetBuiltinLayout("paper16", &as<AgaaLayout>(structure));
         },
         true, false},
        {"AgaaConfig", "agaaApplyPreset", nullptr,
         [](Test& test, void* s, const AgaaLog*) { return callPreset(test, &as<AgaaConfig>(s), nullptr, nullptr); },
         true, false, false, "AgaaAggregation"},
        {"AgaaAggregation", "agaaApplyPreset", nullptr,
         [](Test& test, void* s, const AgaaLog*) {
             return callPreset(test, nullptr, &as<AgaaAggregation>(s), nullptr);
         },
         true, false},
        {"AgaaMeasurement", "agaaApplyPreset", nullptr,
         [](Test& test, void* s, const AgaaLog*) {
             return callPreset(test, nullptr, nullptr, &as<AgaaMeasurement>(s));
         },
         true, false},
        {"AgaaDeviceCaps", "agaaQueryCapabilities",
         [](Test& test, void* structure) { copyMembers(structure, ViewParts(test.sdk, nullptr).caps); },
         [](Test& test, void* structure, const AgaaLog*) {
             uint32_t count = 0;
             return test.sdk.agaaQueryCapabilities(&as<AgaaDeviceCaps>(structure), &count, nullptr);
         },
         false, false},
    };
}

} // namespace

const std::vector<HeaderCase>& coreHeaders() {
    static const std::vector<HeaderCase> cases = [] {
        std::vector<HeaderCase> all = inputs();
        for (const HeaderCase& c : outputs())
            all.push_back(c);
        return all;
    }();
    return cases;
}

void addHeaderCases(Suite& suite) {
    for (const HeaderCase& c : coreHeaders())
        suite.core(std::string(c.name) + "/header", [&c](Test& test) { testHeader(test, c); });
    for (const HeaderCase& c : further())
        suite.core(std::string(c.name) + "/header/" + c.function, [c](Test& test) { testHeader(test, c); });
    suite.core("AgaaStructHeader/AGAA_ERROR_VERSION", [](Test& test) {
        for (const HeaderCase& c : coreHeaders())
            testTail(test, c);
    });
    suite.core("AgaaStructHeader/AGAA_ERROR_UNKNOWN_STRUCT", [](Test& test) {
        for (const HeaderCase& c : coreHeaders())
            testChain(test, c);
    });
    suite.core("AgaaStructHeader/AGAA_ERROR_UNKNOWN_STRUCT/long_chain", [](Test& test) {
        for (const HeaderCase& c : coreHeaders())
            testLongChain(test, c);
    });
}

} // namespace agaa::conformance
