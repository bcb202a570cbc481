// agaaQueryMemory and agaaQueryTarget: pointers, outputs and errors that only they have.
#include "cases.h"
#include "structs.h"
#include "view_parts.h"
#include "wrong_views.h"

#include <cstring>

namespace agaa::conformance {

namespace {

template <class T> T patternOf(const T& initial) {
    T value = initial;
    constexpr size_t header = sizeof(AgaaStructHeader);
    std::memset(reinterpret_cast<char*>(&value) + header, 0x5A, sizeof value - header);
    return value;
}

const AgaaMemoryReport initialReport = AGAA_MEMORY_REPORT_INIT;
const AgaaTarget initialTarget = AGAA_TARGET_INIT;
const AgaaSurface initialSurface = AGAA_SURFACE_INIT;

struct Memory {
    AgaaMemoryReport report = initialReport;
    std::vector<AgaaSurface> surfaces;
};

Memory memoryOf(Test& test, const ViewParts& parts) {
    Memory memory;
    memory.surfaces = surfacesOf(test, parts, &memory.report);
    return memory;
}

// ---- agaaQueryMemory -----------------------------------------------------------------------------

void testMemoryNulls(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    const Memory expected = memoryOf(test, parts);
    uint32_t count = 0;
    std::vector<AgaaSurface> surfaces(expected.surfaces.size(), initialSurface);
    test.result(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, nullptr, nullptr, nullptr), AGAA_OK,
                "agaaQueryMemory with log, outReport, surfaceCount and surfaces = null");
    test.result(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, nullptr, &count, nullptr), AGAA_OK,
                "agaaQueryMemory with outReport and surfaces = null");
    test.check(count == surfaces.size(), "agaaQueryMemory with outReport = null returns another number of surfaces.");
    test.result(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, nullptr, &count, surfaces.data()), AGAA_OK,
                "agaaQueryMemory with outReport = null");
    for (size_t i = 0; i < surfaces.size(); ++i)
        test.check(isSameBytes(surfaces[i], expected.surfaces[i]),
                   "agaaQueryMemory with outReport = null describes surface " + std::to_string(i) + " differently.");
    AgaaMemoryReport report = initialReport;
    test.result(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, &report, nullptr, nullptr), AGAA_OK,
                "agaaQueryMemory with surfaceCount = null");
    test.check(isSameBytes(report, expected.report), "agaaQueryMemory with surfaceCount = null reports other bytes.");
}

void testSurfacesNull(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    uint32_t count = 1; // not the length of any array
    test.result(test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, nullptr, &count, nullptr), AGAA_OK,
                "agaaQueryMemory with surfaces = null and surfaceCount = 1");
    test.check(count > 1, "agaaQueryMemory with surfaces = null does not return the number of surfaces.");
    test.check(count == surfacesOf(test, parts).size(),
               "agaaQueryMemory returns another number of surfaces with an array than without.");
}

// A null pointer and a device with every feature give the same result.
void testMemoryOfNullCaps(Test& test) {
    for (const char* technique :
         {"single", "msaa", "ssaa", "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive"}) {
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique(technique, 4);
        AgaaMemoryReport withNull = initialReport, withCaps = initialReport;
        test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, &withNull, nullptr, nullptr),
                       std::string("agaaQueryMemory of \"") + technique + "\" with caps = null");
        test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, &withCaps, nullptr, nullptr),
                       std::string("agaaQueryMemory of \"") + technique + "\" with an ideal device");
        test.check(isSameBytes(withNull, withCaps), std::string("agaaQueryMemory of \"") + technique +
                                                        "\" differs for caps = null and an ideal device.");
        AgaaTarget targetOfNull = initialTarget, targetOfCaps = initialTarget;
        test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, nullptr, nullptr, &targetOfNull),
                       "agaaQueryTarget with caps = null");
        test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, nullptr, &targetOfCaps), "agaaQueryTarget");
        test.check(isSameBytes(targetOfNull, targetOfCaps), std::string("agaaQueryTarget of \"") + technique +
                                                                "\" differs for caps = null and an ideal device.");
    }
}

// Outputs are unchanged after every error, also if only the array is too short.
void testReportUnchanged(Test& test) {
    const AgaaMemoryReport before = patternOf(initialReport);
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        AgaaMemoryReport report = before;
        uint32_t count = 77;
        test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, &report, &count, nullptr);
        test.check(isSameBytes(before, report), callWith("agaaQueryMemory", row.what) + " changes outReport.");
        test.check(count == 77, callWith("agaaQueryMemory", row.what) + " changes surfaceCount.");
    }
    ViewParts parts(test.sdk, nullptr);
    AgaaMemoryReport report = before;
    AgaaSurface surface = initialSurface;
    uint32_t count = 1;
    test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, &report, &count, &surface);
    test.check(isSameBytes(before, report), "agaaQueryMemory with an array that is too short changes outReport.");
}

void testSurfacesUnchanged(Test& test) {
    const std::vector<AgaaSurface> before(64, patternOf(initialSurface));
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        std::vector<AgaaSurface> surfaces = before;
        uint32_t count = uint32_t(surfaces.size());
        const AgaaResult result =
            test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, nullptr, &count, surfaces.data());
        test.check(result != AGAA_OK && count == before.size() &&
                       std::memcmp(before.data(), surfaces.data(), before.size() * sizeof(AgaaSurface)) == 0,
                   callWith("agaaQueryMemory", row.what) + " changes surfaces.");
    }
}

void testWrongMemory(Test& test, AgaaResult only) {
    const auto query = [&](const ViewParts& parts, LogRecorder& log) {
        AgaaMemoryReport report = initialReport;
        return test.sdk.agaaQueryMemory(parts.get(), &parts.caps, log.get(), &report, nullptr, nullptr);
    };
    testWrongViews(test, nullptr, "agaaQueryMemory", query, only);
}

void testMemoryArguments(Test& test) {
    testWrongMemory(test, AGAA_ERROR_INVALID_ARGUMENT);
    ViewParts parts(test.sdk, nullptr);
    LogRecorder log;
    AgaaSurface surface = initialSurface;
    expectRefused(test, test.sdk.agaaQueryMemory(&parts.desc, nullptr, log.get(), nullptr, nullptr, &surface),
                  AGAA_ERROR_INVALID_ARGUMENT, log, "agaaQueryMemory",
                  "agaaQueryMemory with surfaces and surfaceCount = null", "count");
}

void testMemoryTooSmall(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    const uint32_t needed = uint32_t(surfacesOf(test, parts).size());
    std::vector<AgaaSurface> surfaces(needed + 1, patternOf(initialSurface));
    const std::vector<AgaaSurface> before = surfaces;
    for (const uint32_t length : {0u, 1u, needed - 1}) {
        LogRecorder log;
        uint32_t count = length;
        expectRefused(test, test.sdk.agaaQueryMemory(&parts.desc, nullptr, log.get(), nullptr, &count, surfaces.data()),
                      AGAA_ERROR_BUFFER_TOO_SMALL, log, "agaaQueryMemory",
                      "agaaQueryMemory with " + std::to_string(length) + " surfaces");
        test.check(count == length && std::memcmp(before.data(), surfaces.data(), needed * sizeof(AgaaSurface)) == 0,
                   "agaaQueryMemory with an array that is too short writes.");
    }
    uint32_t count = needed + 1;
    test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, nullptr, &count, surfaces.data()),
                   "agaaQueryMemory with a longer array");
    test.check(count == needed && isSameBytes(before[needed], surfaces[needed]),
               "agaaQueryMemory with a longer array writes behind the surfaces.");
}

// Tests output structs. The wrong views cover the structs of the description.
void testMemoryStruct(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    LogRecorder log;
    AgaaMemoryReport report = initialReport;
    report.sType = 0;
    expectRefused(test, test.sdk.agaaQueryMemory(&parts.desc, nullptr, log.get(), &report, nullptr, nullptr),
                  AGAA_ERROR_STRUCT, log, "agaaQueryMemory", "agaaQueryMemory with AgaaMemoryReport::sType = 0",
                  "AgaaMemoryReport");
    std::vector<AgaaSurface> surfaces(surfacesOf(test, parts).size(), patternOf(initialSurface));
    const std::vector<AgaaSurface> before = surfaces;
    for (size_t wrong = 0; wrong < surfaces.size(); ++wrong) {
        surfaces[wrong].sType = 0;
        uint32_t count = uint32_t(surfaces.size());
        expectRefused(test, test.sdk.agaaQueryMemory(&parts.desc, nullptr, log.get(), nullptr, &count, surfaces.data()),
                      AGAA_ERROR_STRUCT, log, "agaaQueryMemory",
                      "agaaQueryMemory with surface " + std::to_string(wrong) + " that is not initialised",
                      "AgaaSurface");
        surfaces[wrong].sType = AGAA_STRUCTURE_TYPE_SURFACE;
        test.check(std::memcmp(before.data(), surfaces.data(), surfaces.size() * sizeof(AgaaSurface)) == 0,
                   "agaaQueryMemory fails and changes surfaces.");
    }
    AgaaDeviceCaps caps = parts.caps;
    caps.structSize = 0;
    expectRefused(test, test.sdk.agaaQueryMemory(&parts.desc, &caps, log.get(), nullptr, nullptr, nullptr),
                  AGAA_ERROR_STRUCT, log, "agaaQueryMemory", "agaaQueryMemory with AgaaDeviceCaps::structSize = 0",
                  "AgaaDeviceCaps");
}

void testSurfaceSteps(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    const std::vector<AgaaSurface> expected = surfacesOf(test, parts);
    const size_t stride = sizeof(AgaaSurface) + 24;
    Bytes array(expected.size() * stride + 64);
    const auto element = [&](size_t i) { return reinterpret_cast<AgaaSurface*>(array.data() + i * stride); };
    for (size_t i = 0; i < expected.size(); ++i)
        test.sdk.agaaInitSurface(element(i), stride);
    uint32_t count = uint32_t(expected.size());
    test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, nullptr, &count, element(0)),
                   "agaaQueryMemory with larger surfaces");
    for (size_t i = 0; i < expected.size(); ++i) {
        AgaaSurface got = *element(i);
        test.check(got.structSize == stride, "agaaQueryMemory changes structSize of a surface.");
        got.structSize = sizeof got;
        test.check(isSameBytes(got, expected[i]), "agaaQueryMemory does not step by the caller's structSize: surface " +
                                                      std::to_string(i) + " differs.");
    }
    test.check(array.findDifference(expected.size() * stride, array.size(), Bytes::pattern) == array.size(),
               "agaaQueryMemory writes beyond an array of larger surfaces.");
    element(1)->structSize = sizeof(AgaaSurface);
    test.result(test.sdk.agaaQueryMemory(&parts.desc, nullptr, nullptr, nullptr, &count, element(0)), AGAA_ERROR_STRUCT,
                "agaaQueryMemory with surfaces of different structSizes");
}

// ---- agaaQueryTarget -----------------------------------------------------------------------------

void testTargetUnchanged(Test& test) {
    const AgaaTarget before = patternOf(initialTarget);
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        AgaaTarget target = before;
        test.sdk.agaaQueryTarget(parts.get(), &parts.caps, nullptr, &target);
        test.check(isSameBytes(before, target), callWith("agaaQueryTarget", row.what) + " changes outTarget.");
    }
}

void testTargetStruct(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    LogRecorder log;
    AgaaTarget target = initialTarget;
    target.structSize = 0;
    expectRefused(test, test.sdk.agaaQueryTarget(&parts.desc, nullptr, log.get(), &target), AGAA_ERROR_STRUCT, log,
                  "agaaQueryTarget", "agaaQueryTarget with AgaaTarget::structSize = 0", "AgaaTarget");
    target = initialTarget;
    AgaaDeviceCaps caps = parts.caps;
    caps.sType = 0;
    expectRefused(test, test.sdk.agaaQueryTarget(&parts.desc, &caps, log.get(), &target), AGAA_ERROR_STRUCT, log,
                  "agaaQueryTarget", "agaaQueryTarget with AgaaDeviceCaps::sType = 0", "AgaaDeviceCaps");
}

// Tests limits of the device: a target of exactly maxImageSize is accepted, a texel more is refused.
void testTargetTooLarge(Test& test) {
    struct Row {
        uint32_t width, height;
        uint32_t samples, counts; // sample counts of the device
        AgaaResult expected;
    };
    for (const Row& row :
         {Row{1000, 1, 4, 0x3F, AGAA_OK}, Row{1001, 1, 4, 0x3F, AGAA_ERROR_TOO_LARGE}, Row{1, 1000, 4, 0x3F, AGAA_OK},
          Row{1, 1001, 4, 0x3F, AGAA_ERROR_TOO_LARGE}, Row{500, 500, 4, 0x1, AGAA_OK},
          Row{501, 1, 4, 0x1, AGAA_ERROR_TOO_LARGE}, Row{0xFFFFFFFF, 1, 4, 0x1, AGAA_ERROR_TOO_LARGE}}) {
        ViewParts parts(test.sdk, nullptr);
        parts.caps.maxImageSize = 1000;
        parts.caps.sampleCounts = row.counts; // a pixel with 4 samples is 2 x 2 texels of one sample
        parts.config.samples = row.samples;
        parts.desc.width = row.width;
        parts.desc.height = row.height;
        LogRecorder log;
        AgaaTarget target = initialTarget;
        const AgaaResult result = test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, log.get(), &target);
        const std::string what =
            "agaaQueryTarget of " + std::to_string(row.width) + " x " + std::to_string(row.height) +
            " pixels with sampleCounts = " + std::to_string(row.counts) + " and maxImageSize = 1000";
        if (row.expected == AGAA_OK)
            test.result(result, AGAA_OK, what);
        else
            expectRefused(test, result, row.expected, log, "agaaQueryTarget", what, "1000");
    }
}

} // namespace

void addMemoryCases(Suite& suite) {
    suite.core("agaaQueryMemory/log.null", testMemoryNulls);
    suite.core("agaaQueryMemory/outReport.null", testMemoryNulls);
    suite.core("agaaQueryMemory/surfaceCount.null", testMemoryNulls);
    suite.core("agaaQueryMemory/surfaces.null", testSurfacesNull);
    suite.core("agaaQueryMemory/caps.null", testMemoryOfNullCaps);
    suite.core("agaaQueryTarget/caps.null", testMemoryOfNullCaps);
    suite.core("agaaQueryMemory/outReport.unchanged", testReportUnchanged);
    suite.core("agaaQueryMemory/AGAA_ERROR_STRUCT", testMemoryStruct);
    suite.core("agaaQueryMemory/AGAA_ERROR_BUFFER_TOO_SMALL", testMemoryTooSmall);
    suite.core("AgaaSurface/header/array", testSurfaceSteps);
    suite.core("agaaQueryMemory/surfaces.unchanged", testSurfacesUnchanged);
    suite.core("agaaQueryMemory/AGAA_ERROR_INVALID_ARGUMENT", testMemoryArguments);
    suite.core("agaaQueryMemory/AGAA_ERROR_LAYOUT", [](Test& test) { testWrongMemory(test, AGAA_ERROR_LAYOUT); });
    suite.core("agaaQueryMemory/AGAA_ERROR_UNSUPPORTED",
               [](Test& test) { testWrongMemory(test, AGAA_ERROR_UNSUPPORTED); });
    suite.core("agaaQueryMemory/AGAA_ERROR_TOO_LARGE", [](Test& test) { testWrongMemory(test, AGAA_ERROR_TOO_LARGE); });
    suite.core("agaaQueryMemory/wrong_views", [](Test& test) { testWrongMemory(test, AGAA_OK); });
    suite.core("agaaQueryTarget/log.null", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        AgaaTarget target = initialTarget;
        test.result(test.sdk.agaaQueryTarget(&parts.desc, nullptr, nullptr, &target), AGAA_OK,
                    "agaaQueryTarget with log = null");
        parts.desc.width = 0;
        test.result(test.sdk.agaaQueryTarget(&parts.desc, nullptr, nullptr, &target), AGAA_ERROR_OUT_OF_RANGE,
                    "agaaQueryTarget with log = null and AgaaViewDesc::width = 0");
    });
    suite.core("agaaQueryTarget/outTarget.unchanged", testTargetUnchanged);
    suite.core("agaaQueryTarget/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        LogRecorder log;
        expectRefused(test, test.sdk.agaaQueryTarget(&parts.desc, nullptr, log.get(), nullptr),
                      AGAA_ERROR_INVALID_ARGUMENT, log, "agaaQueryTarget", "agaaQueryTarget with outTarget = null",
                      "AgaaTarget");
    });
    suite.core("agaaQueryTarget/AGAA_ERROR_STRUCT", testTargetStruct);
    suite.core("agaaQueryTarget/AGAA_ERROR_TOO_LARGE", testTargetTooLarge);
    suite.core("agaaQueryTarget/those_of.agaaQueryMemory", [](Test& test) {
        testWrongViews(test, nullptr, "agaaQueryTarget", [&](const ViewParts& parts, LogRecorder& log) {
            AgaaTarget target = initialTarget;
            return test.sdk.agaaQueryTarget(parts.get(), &parts.caps, log.get(), &target);
        });
    });
}

} // namespace agaa::conformance
