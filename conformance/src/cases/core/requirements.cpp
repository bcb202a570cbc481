// agaaVkGetRequirements and agaaGlGetRequirements.
#include "cases.h"
#include "structs.h"

#include <cstring>

namespace agaa::conformance {

namespace {

const AgaaVkRequirements initialVk = AGAA_VK_REQUIREMENTS_INIT;
const AgaaGlRequirements initialGl = AGAA_GL_REQUIREMENTS_INIT;

struct Api {
    const char* function;
    std::function<AgaaResult(const Functions&, void*)> call; // called with a struct of either API
    Bytes initial;
};

template <class T> Bytes bytesOf(const T& value) {
    Bytes bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

const Api& vulkan() {
    static const Api api = {"agaaVkGetRequirements",
                            [](const Functions& sdk, void* out) {
                                return sdk.agaaVkGetRequirements(static_cast<AgaaVkRequirements*>(out));
                            },
                            bytesOf(initialVk)};
    return api;
}

const Api& openGl() {
    static const Api api = {"agaaGlGetRequirements",
                            [](const Functions& sdk, void* out) {
                                return sdk.agaaGlGetRequirements(static_cast<AgaaGlRequirements*>(out));
                            },
                            bytesOf(initialGl)};
    return api;
}

void testStruct(Test& test, const Api& api, bool checksOutput) {
    const auto expectCorruptRefused = [&](const std::string& what,
                                          const std::function<void(AgaaStructHeader&)>& corrupt) {
        Bytes bytes = api.initial;
        std::memset(bytes.data() + sizeof(AgaaStructHeader), 0x5A, bytes.size() - sizeof(AgaaStructHeader));
        corrupt(bytes.header());
        const Bytes before = bytes;
        const AgaaResult result = api.call(test.sdk, bytes.data());
        if (checksOutput)
            test.check(bytes == before, std::string(api.function) + " with " + what + " changes outRequirements.");
        else
            test.result(result, AGAA_ERROR_STRUCT, std::string(api.function) + " with " + what);
    };
    expectCorruptRefused("sType = 0", [](AgaaStructHeader& h) { h.sType = 0; });
    expectCorruptRefused("structSize = 0", [](AgaaStructHeader& h) { h.structSize = 0; });
    expectCorruptRefused("structSize = 48", [](AgaaStructHeader& h) { h.structSize = 48; });
    expectCorruptRefused("structSize = 57", [](AgaaStructHeader& h) { h.structSize = 57; });
    expectCorruptRefused("the sType of AgaaLog", [](AgaaStructHeader& h) { h.sType = AGAA_STRUCTURE_TYPE_LOG; });
}

void checkNames(Test& test, const char* const* names, uint32_t count, const std::string& member, const char* begin) {
    for (uint32_t i = 0; i < count; ++i) {
        test.require(names && names[i], member + " holds a null pointer.");
        test.check(std::string(names[i]).rfind(begin, 0) == 0, member + " holds \"" + names[i] + "\".");
    }
}

// The versions are those of the header.
void testVulkan(Test& test) {
    AgaaVkRequirements r = initialVk;
    test.requireOk(test.sdk.agaaVkGetRequirements(&r), "agaaVkGetRequirements");
    test.check(r.apiVersion == ((1u << 22) | (2u << 12)), "AgaaVkRequirements::apiVersion is not VK_API_VERSION_1_2.");
    checkNames(test, r.requiredFeatures, r.requiredFeatureCount, "AgaaVkRequirements::requiredFeatures", "");
    checkNames(test, r.optionalFeatures, r.optionalFeatureCount, "AgaaVkRequirements::optionalFeatures", "");
    checkNames(test, r.optionalDeviceExtensions, r.optionalDeviceExtensionCount,
               "AgaaVkRequirements::optionalDeviceExtensions", "VK_");
    AgaaVkRequirements again = initialVk;
    test.requireOk(test.sdk.agaaVkGetRequirements(&again), "agaaVkGetRequirements");
    test.check(std::memcmp(&r, &again, sizeof r) == 0, "agaaVkGetRequirements: the lists have no static storage.");
}

void testOpenGl(Test& test) {
    AgaaGlRequirements r = initialGl;
    test.requireOk(test.sdk.agaaGlGetRequirements(&r), "agaaGlGetRequirements");
    test.check(r.majorVersion == 4 && r.minorVersion == 3, "AgaaGlRequirements: the version is not 4.3.");
    test.check(r.completeMajorVersion == 4 && r.completeMinorVersion == 5,
               "AgaaGlRequirements: the complete version is not 4.5.");
    checkNames(test, r.requiredExtensions, r.requiredExtensionCount, "AgaaGlRequirements::requiredExtensions", "GL_");
    checkNames(test, r.optionalExtensions, r.optionalExtensionCount, "AgaaGlRequirements::optionalExtensions", "GL_");
    AgaaGlRequirements again = initialGl;
    test.requireOk(test.sdk.agaaGlGetRequirements(&again), "agaaGlGetRequirements");
    test.check(std::memcmp(&r, &again, sizeof r) == 0, "agaaGlGetRequirements: the lists have no static storage.");
}

} // namespace

void addRequirementCases(Suite& suite) {
    for (const Api* api : {&vulkan(), &openGl()}) {
        const std::string function = api->function;
        suite.core(function + "/outRequirements.unchanged", [api](Test& test) { testStruct(test, *api, true); });
        suite.core(function + "/AGAA_ERROR_STRUCT", [api](Test& test) { testStruct(test, *api, false); });
        suite.core(function + "/AGAA_ERROR_INVALID_ARGUMENT", [api](Test& test) {
            test.result(api->call(test.sdk, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                        std::string(api->function) + " with outRequirements = null");
        });
    }
    suite.core("AgaaVkRequirements/lists", testVulkan);
    suite.core("AgaaGlRequirements/lists", testOpenGl);
}

} // namespace agaa::conformance
