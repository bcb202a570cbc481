// A view with all structs that it points to, and the queries that need no device.
#pragma once

#include "device.h"

namespace agaa::conformance {

// All parts of a valid view; tests change some of them.
struct ViewParts : ViewDescription {
    // `device` is null for the queries of agaa/query.h.
    ViewParts(const Functions& sdk, const Device* device);

    AgaaGBufferFunction gbuffer; // chain() chains it to desc
    AgaaFetchFunction fetch;     // functions without a scene
    AgaaShadowFunction shadow;
    AgaaShadingFunction shading;
    AgaaResolvedOutputs outputs; // the nearest depth
    AgaaDeviceCaps caps;         // an ideal device; devices do not read it
    AgaaAggregation spare;       // second struct of its type in a chain
    bool isNull = false;         // the description is null

    template <class T> void chain(T& function) {
        function.pNext = desc.pNext;
        desc.pNext = &function;
    }
    // Replaces the chained functions.
    template <class T> void chainAlone(T& function) {
        desc.pNext = nullptr;
        chain(function);
    }
    void useLayout() { config.layout = &layout; }
    const AgaaViewDesc* get() const { return isNull ? nullptr : &desc; }
};

// All allTechniques of the library.
constexpr const char* allTechniques[] = {"single",         "fxaa", "smaa", "taa",  "msaa", "ssaa",    "visibility",
                                         "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive"};

// All flags that add a capability to a device.
constexpr uint64_t idealDeviceFlags =
    AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
    AGAA_DEVICE_DYNAMIC_RENDERING | AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_NV_MIXED_SAMPLES |
    AGAA_DEVICE_SAMPLE_LOCATIONS | AGAA_DEVICE_NV_MULTICAST | AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8 |
    AGAA_DEVICE_GEOMETRY_SHADERS | AGAA_DEVICE_FRAGMENT_INTERLOCK | AGAA_DEVICE_FRAMEBUFFER_FETCH;

struct ViewQuery {
    const char* name;
    // Requests all outputs of the function with two calls. Passes null pointers on.
    AgaaResult (*call)(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log);
};

// Returns agaaQueryMemory, agaaQueryTarget, agaaPlanToJson and agaaQueryPrices.
const std::vector<ViewQuery>& viewQueries();
extern const ViewQuery aggregateGlslQuery; // fails for views without aggregates in memory

// Returns "agaaQueryMemory with WHAT".
std::string callWith(const std::string& function, const std::string& what);

// Checks that the queries accept a view. The reason of a failure has the log's sentence.
void expectAccepted(Test& test, const ViewParts& parts, const std::string& what);
// Checks that all queries, including agaaGetAggregateGlsl, refuse a view with a sentence that contains the words.
void expectViewRefused(Test& test, const ViewParts& parts, AgaaResult expected, const std::string& what,
                       const std::string& words = "");

// Returns the text of agaaPlanToJson, which must succeed.
std::string planText(Test& test, const ViewParts& parts);
// Returns the name of the tier in the plan.
std::string generationTierOf(Test& test, const ViewParts& parts);
std::vector<AgaaSurface> surfacesOf(Test& test, const ViewParts& parts, AgaaMemoryReport* outReport = nullptr);

} // namespace agaa::conformance
