// Capabilities of devices and contexts: agaa…GetDeviceCaps and agaa…GetContextCaps.
#include "cases.h"
#include "creation.h"

#include "cases/core/header_check.h"

#include <cstring>

namespace agaa::conformance {

namespace {

const AgaaDeviceCaps initialCaps = AGAA_DEVICE_CAPS_INIT;

bool isSame(const AgaaDeviceCaps& a, const AgaaDeviceCaps& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

AgaaDeviceCaps pattern() {
    AgaaDeviceCaps caps;
    std::memset(&caps, 0x5A, sizeof caps);
    caps.sType = initialCaps.sType;
    caps.structSize = initialCaps.structSize;
    caps.pNext = nullptr;
    return caps;
}

// Tests the capabilities that every device with a context must have.
void checkCaps(Test& test, const AgaaDeviceCaps& caps, const std::string& function) {
    test.check(caps.deviceName[0] && std::memchr(caps.deviceName, 0, sizeof caps.deviceName),
               function + ": deviceName is empty or does not end.");
    test.check(caps.driverName[0] && std::memchr(caps.driverName, 0, sizeof caps.driverName),
               function + ": driverName is empty or does not end.");
    test.check(caps.sampleCounts & 1, function + ": sampleCounts lacks one sample.");
    test.check(caps.maxImageSize >= 4096 && caps.maxStorageRange >= 1u << 20 && caps.maxSharedBytes >= 16384,
               function + ": a limit is lower than those that the graphics API guarantees.");
    test.check(caps.subgroupSize <= 128 && (caps.subgroupSize & (caps.subgroupSize - 1)) == 0,
               function + ": subgroupSize is no power of two up to 128.");
    test.check(caps.flags & AGAA_DEVICE_STORAGE_FORMATS, function + ": the flag STORAGE_FORMATS is missing.");
    // The queries accept the result of the function.
    ViewParts parts(test.sdk, &test.device());
    parts.caps = caps;
    test.result(test.sdk.agaaQueryMemory(&parts.desc, &caps, nullptr, nullptr, nullptr, nullptr), AGAA_OK,
                "agaaQueryMemory with the capabilities of " + function);
    uint32_t count = 0;
    test.result(test.sdk.agaaQueryCapabilities(&caps, &count, nullptr), AGAA_OK,
                "agaaQueryCapabilities with the capabilities of " + function);
}

void testDeviceCaps(Test& test) {
    const std::string function = apiName(test.device(), "GetDeviceCaps");
    LogRecorder log;
    AgaaDeviceCaps caps = initialCaps, again = pattern();
    test.requireOk(test.device().getDeviceCaps(test.sdk, log.get(), &caps), function);
    test.check(log.lines.empty(), function + " succeeds and logs a line.");
    checkCaps(test, caps, function);
    test.requireOk(test.device().getDeviceCaps(test.sdk, nullptr, &again), function + " with log = null");
    test.check(isSame(caps, again), function + " differs without a log, or does not write all members.");
    again = initialCaps;
    again.structSize = 0;
    test.result(test.device().getDeviceCaps(test.sdk, nullptr, &again), AGAA_ERROR_STRUCT,
                function + " with log = null and AgaaDeviceCaps::structSize = 0");
}

// The context of a device without options has no more capabilities than the device.
void testContextCaps(Test& test) {
    const std::string function = apiName(test.device(), "GetContextCaps");
    ScopedContext context(test);
    AgaaDeviceCaps deviceCaps = initialCaps, caps = pattern();
    test.requireOk(test.device().getDeviceCaps(test.sdk, nullptr, &deviceCaps),
                   apiName(test.device(), "GetDeviceCaps"));
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), function);
    checkCaps(test, caps, function);
    test.check(!(caps.flags & ~deviceCaps.flags), function + ": the context has flags that the device lacks.");
    test.check(caps.subgroupSize == 0 || caps.subgroupSize == deviceCaps.subgroupSize,
               function + ": the context has other subgroups than the device.");
    test.check(!std::strcmp(caps.deviceName, deviceCaps.deviceName), function + ": another device is named.");
}

// Runs each failing call and checks that its struct is unchanged.
using Call = std::function<AgaaResult(const AgaaLog*, AgaaDeviceCaps*)>;

void refuseStructs(Test& test, const std::string& function, LogRecorder& log, const Call& call) {
    struct Row {
        const char* what;
        void (*corrupt)(AgaaDeviceCaps&);
    };
    for (const Row& row : {Row{"sType = 0", [](AgaaDeviceCaps& c) { c.sType = 0; }},
                           Row{"structSize = 0", [](AgaaDeviceCaps& c) { c.structSize = 0; }},
                           Row{"structSize = 12", [](AgaaDeviceCaps& c) { c.structSize = 12; }}}) {
        AgaaDeviceCaps caps = pattern();
        row.corrupt(caps);
        const AgaaDeviceCaps before = caps;
        const std::string what = function + " with AgaaDeviceCaps::" + row.what;
        expectRefused(test, call(log.get(), &caps), AGAA_ERROR_STRUCT, log, function, what, "AgaaDeviceCaps");
        test.check(isSame(before, caps), what + " changes outCaps.");
    }
}

void testDeviceStructs(Test& test) {
    LogRecorder log;
    refuseStructs(test, apiName(test.device(), "GetDeviceCaps"), log, [&](const AgaaLog* to, AgaaDeviceCaps* caps) {
        return test.device().getDeviceCaps(test.sdk, to, caps);
    });
}

void testContextStructs(Test& test) {
    ScopedContext context(test);
    refuseStructs(test, apiName(test.device(), "GetContextCaps"), context.log,
                  [&](const AgaaLog*, AgaaDeviceCaps* caps) {
                      return test.device().getContextCaps(test.sdk, context.get(), caps);
                  });
}

void testContextNulls(Test& test) {
    const std::string function = apiName(test.device(), "GetContextCaps");
    ScopedContext context(test);
    AgaaDeviceCaps caps = pattern();
    test.result(test.device().getContextCaps(test.sdk, nullptr, &caps), AGAA_ERROR_INVALID_ARGUMENT,
                function + " with context = null");
    test.check(isSame(caps, pattern()), function + " with context = null changes outCaps.");
    expectRefused(test, test.device().getContextCaps(test.sdk, context.get(), nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  context.log, function, function + " with outCaps = null", "AgaaDeviceCaps");
}

AgaaResult deviceCapsOf(Test& test, const ContextDescription& d, const AgaaLog* log, AgaaDeviceCaps* caps) {
    return test.device().backend() == Backend::Vulkan
               ? test.sdk.agaaVkGetDeviceCaps(d.vk.instance, d.vk.physicalDevice, d.vk.getProcAddr, log, caps)
               : test.sdk.agaaGlGetDeviceCaps(d.gl.getProcAddr, d.gl.getProcUser, log, caps);
}

void refuseDevice(Test& test, const std::string& what, const std::string& words, const ChangeContext& change) {
    const std::string function = apiName(test.device(), "GetDeviceCaps");
    ContextDescription description = test.device().description();
    change(description);
    LogRecorder log;
    AgaaDeviceCaps caps = pattern();
    expectRefused(test, deviceCapsOf(test, description, log.get(), &caps), AGAA_ERROR_INVALID_ARGUMENT, log, function,
                  function + " with " + what, words);
    test.check(isSame(caps, pattern()), function + " with " + what + " changes outCaps.");
}

void testDeviceNulls(Test& test) {
    const std::string function = apiName(test.device(), "GetDeviceCaps");
    if (test.device().backend() == Backend::Vulkan) {
        refuseDevice(test, "instance = null", "null", [](ContextDescription& d) { d.vk.instance = nullptr; });
        refuseDevice(test, "physicalDevice = null", "null",
                     [](ContextDescription& d) { d.vk.physicalDevice = nullptr; });
    }
    refuseDevice(test, "getProcAddr = null", "null",
                 [](ContextDescription& d) { d.vk.getProcAddr = nullptr, d.gl.getProcAddr = nullptr; });
    LogRecorder log;
    expectRefused(test, deviceCapsOf(test, test.device().description(), log.get(), nullptr),
                  AGAA_ERROR_INVALID_ARGUMENT, log, function, function + " with outCaps = null", "AgaaDeviceCaps");
}

// ---- headers ---------------------------------------------------------------------------------------

void testCapsHeader(Test& test, bool isContext) {
    std::unique_ptr<ScopedContext> context;
    if (isContext)
        context = std::make_unique<ScopedContext>(test);
    HeaderCase c = {"AgaaDeviceCaps", apiName(test.device(), isContext ? "GetContextCaps" : "GetDeviceCaps"), nullptr,
                    [&](Test& inner, void* structure, const AgaaLog* log) {
                        auto* caps = static_cast<AgaaDeviceCaps*>(structure);
                        return isContext ? inner.device().getContextCaps(inner.sdk, context->get(), caps)
                                         : inner.device().getDeviceCaps(inner.sdk, log, caps);
                    },
                    true};
    c.hasLog = !isContext; // the log belongs to the context
    testHeader(test, c);
}

} // namespace

void addDeviceCapsCases(Suite& suite) {
    addApiCase(suite, "GetDeviceCaps", "AGAA_ERROR_INVALID_ARGUMENT", testDeviceNulls);
    addApiCase(suite, "GetDeviceCaps", "AGAA_ERROR_STRUCT", testDeviceStructs);
    addApiCase(suite, "GetDeviceCaps", "outCaps.unchanged", [](Test& test) {
        testDeviceNulls(test);
        testDeviceStructs(test);
    });
    addApiCase(suite, "GetDeviceCaps", "log.null", testDeviceCaps);
    addApiCase(suite, "GetContextCaps", "AGAA_ERROR_INVALID_ARGUMENT", testContextNulls);
    addApiCase(suite, "GetContextCaps", "AGAA_ERROR_STRUCT", testContextStructs);
    addApiCase(suite, "GetContextCaps", "outCaps.unchanged", [](Test& test) {
        testContextNulls(test);
        testContextStructs(test);
    });
    addApiCase(suite, "GetContextCaps", "values", testContextCaps);
    suite.both("AgaaDeviceCaps/header/GetDeviceCaps", [](Test& test) { testCapsHeader(test, false); });
    suite.both("AgaaDeviceCaps/header/GetContextCaps", [](Test& test) { testCapsHeader(test, true); });
}

} // namespace agaa::conformance
