// A view with all that it points to, and the functions that answer for it without a device.
#pragma once

#include "device.h"

namespace agaa::conformance {

// All parts of a valid view; tests change some of them.
struct ViewParts : ViewDescription {
    // device: null for the queries of agaa/query.h.
    ViewParts(const Functions& sdk, const Device* device);

    AgaaGBufferFunction gbuffer; // chained to desc by chain()
    AgaaFetchFunction fetch; // of no scene
    AgaaShadowFunction shadow;
    AgaaDeviceCaps caps;   // of an ideal device; not read by devices
    AgaaAggregation spare; // for chains that hold a struct twice
    bool isNull = false;   // the description itself

    template <class T> void chain(T& function) {
        function.pNext = desc.pNext;
        desc.pNext = &function;
    }
    // In place of the functions that are chained.
    template <class T> void chainAlone(T& function) {
        desc.pNext = nullptr;
        chain(function);
    }
    void useLayout() { config.layout = &layout; }
    const AgaaViewDesc* get() const { return isNull ? nullptr : &desc; }
};

// Every flag that makes a device more capable.
constexpr uint64_t idealDeviceFlags = AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS |
                                      AGAA_DEVICE_SAMPLE_RATE_SHADING | AGAA_DEVICE_DYNAMIC_RENDERING |
                                      AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_NV_MIXED_SAMPLES | AGAA_DEVICE_D24S8 |
                                      AGAA_DEVICE_D32S8 | AGAA_DEVICE_GEOMETRY_SHADERS |
                                      AGAA_DEVICE_FRAGMENT_INTERLOCK | AGAA_DEVICE_FRAMEBUFFER_FETCH;

struct ViewQuery {
    const char* name;
    // Asks for all that the function can give, by the two-call convention. Null pointers are passed on.
    AgaaResult (*call)(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log);
};

// agaaQueryMemory, agaaQueryTarget, agaaPlanToJson and agaaQueryPrices.
const std::vector<ViewQuery>& viewQueries();
extern const ViewQuery aggregateGlslQuery; // fails for views without aggregates in memory

// "agaaQueryMemory with WHAT"
std::string callWith(const std::string& function, const std::string& what);

// Checks that the queries accept a view; failures have the log's sentence.
void expectAccepted(Test& test, const ViewParts& parts, const std::string& what);
// Checks that all queries, agaaGetAggregateGlsl too, refuse a view with a sentence that has the words.
void expectViewRefused(Test& test, const ViewParts& parts, AgaaResult expected, const std::string& what,
                       const std::string& words = "");

// The text of agaaPlanToJson, which must succeed.
std::string planText(Test& test, const ViewParts& parts);
// Tiers as the plan names them.
std::string generationTierOf(Test& test, const ViewParts& parts);
std::vector<AgaaSurface> surfacesOf(Test& test, const ViewParts& parts, AgaaMemoryReport* outReport = nullptr);

} // namespace agaa::conformance
