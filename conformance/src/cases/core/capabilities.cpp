// agaaQueryCapabilities: the entries per device, and the errors.
#include "cases.h"
#include "capabilities.h"
#include "structs.h"

#include <cstring>

namespace agaa::conformance {

std::vector<AgaaCapability> capabilitiesOf(Test& test, const AgaaDeviceCaps* caps) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryCapabilities(caps, &count, nullptr),
                   "agaaQueryCapabilities with capabilities = null");
    const AgaaCapability initial = AGAA_CAPABILITY_INIT;
    std::vector<AgaaCapability> rows(count, initial);
    test.requireOk(test.sdk.agaaQueryCapabilities(caps, &count, rows.data()), "agaaQueryCapabilities");
    test.check(count == rows.size(), "agaaQueryCapabilities returns another count with an array than without.");
    return rows;
}

namespace {

std::string nameOf(const AgaaCapability& row) {
    return std::string("the capability of \"") + (row.technique ? row.technique : "null") +
           "\", n = " + std::to_string(row.samples) + ", stage " + std::to_string(row.stage);
}

template <class Check> void forEachRow(Test& test, const Check& check) {
    for (const AgaaDeviceCaps& caps : capsOfDevices(test))
        for (const AgaaCapability& row : capabilitiesOf(test, &caps))
            check(row);
}

void testStages(Test& test) {
    forEachRow(test, [&](const AgaaCapability& row) {
        test.check(row.stage <= AGAA_STAGE_OTHER || !isSameVersion(test), nameOf(row) + " is not an AgaaStage.");
        test.check(std::string(test.sdk.agaaStageName(row.stage)) != "unknown", nameOf(row) + " has no name.");
    });
}

void testTiers(Test& test) {
    forEachRow(test, [&](const AgaaCapability& row) {
        test.check(std::string(test.sdk.agaaTierName(row.tier)) != "unknown", nameOf(row) + ": the tier has no name.");
        const bool isVisibility = row.stage == AGAA_STAGE_PREPASS;
        test.check(row.tier == AGAA_TIER_AUTO || !isVisibility || row.tier < AGAA_TIER_NV_MIXED_SAMPLES,
                   nameOf(row) + ": the tier is none of visibility.");
    });
}

void testSentences(Test& test) {
    forEachRow(test, [&](const AgaaCapability& row) {
        test.check(std::memchr(row.reason, 0, sizeof row.reason), nameOf(row) + ": the reason does not end.");
        const std::string reason(row.reason, strnlen(row.reason, sizeof row.reason));
        test.check(!reason.empty() && reason.back() == '.', nameOf(row) + ": the reason is no sentence: " + reason);
        test.check(row.technique && row.isNative <= 1 && row.relativeCost >= 0, nameOf(row) + " has a wrong member.");
    });
}

void testCapsNull(Test& test) {
    const std::vector<AgaaCapability> rows = capabilitiesOf(test, nullptr);
    test.check(!rows.empty(), "agaaQueryCapabilities with caps = null lists nothing.");
    for (const AgaaCapability& row : rows)
        test.check(row.tier != AGAA_TIER_AUTO, nameOf(row) + " cannot run on an ideal device.");
}

// The call writes only count.
void testCapabilitiesNull(Test& test) {
    uint32_t count = 0;
    test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, nullptr), AGAA_OK,
                "agaaQueryCapabilities with capabilities = null");
    test.check(count > 0, "agaaQueryCapabilities with capabilities = null returns no count.");
    const uint32_t first = count;
    count = 1;
    test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, nullptr), AGAA_OK,
                "agaaQueryCapabilities with capabilities = null and count = 1");
    test.check(count == first, "agaaQueryCapabilities with capabilities = null reads count.");
}

void testInvalid(Test& test) {
    AgaaCapability row = AGAA_CAPABILITY_INIT;
    const AgaaCapability before = row;
    test.result(test.sdk.agaaQueryCapabilities(nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                "agaaQueryCapabilities with count = null");
    test.result(test.sdk.agaaQueryCapabilities(nullptr, nullptr, &row), AGAA_ERROR_INVALID_ARGUMENT,
                "agaaQueryCapabilities with count = null and an array");
    test.check(std::memcmp(&before, &row, sizeof row) == 0, "agaaQueryCapabilities with count = null writes.");
}

void testStruct(Test& test) {
    uint32_t count = 0;
    AgaaDeviceCaps caps = capsOfDevices(test)[0];
    caps.sType = 0;
    test.result(test.sdk.agaaQueryCapabilities(&caps, &count, nullptr), AGAA_ERROR_STRUCT,
                "agaaQueryCapabilities with caps that are not initialised");
    std::vector<AgaaCapability> rows = capabilitiesOf(test, nullptr);
    for (const size_t wrong : {size_t(0), rows.size() / 2, rows.size() - 1}) {
        std::vector<AgaaCapability> array = rows;
        for (AgaaCapability& row : array)
            row.samples = 777;
        array[wrong].sType = 0;
        count = uint32_t(array.size());
        test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, array.data()), AGAA_ERROR_STRUCT,
                    "agaaQueryCapabilities with element " + std::to_string(wrong) + " that is not initialised");
        test.check(array[0].samples == 777, "agaaQueryCapabilities fails and changes elements.");
    }
}

void testRange(Test& test) {
    for (const uint32_t lanes : {3u, 48u, 256u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
        AgaaDeviceCaps caps = capsOfDevices(test)[0];
        caps.subgroupSize = lanes;
        uint32_t count = 77;
        test.result(test.sdk.agaaQueryCapabilities(&caps, &count, nullptr), AGAA_ERROR_OUT_OF_RANGE,
                    "agaaQueryCapabilities with AgaaDeviceCaps::subgroupSize = " + std::to_string(lanes));
        test.check(count == 77, "agaaQueryCapabilities fails and changes count.");
    }
}

void testUnknownFlag(Test& test) {
    AgaaDeviceCaps caps = capsOfDevices(test)[0];
    caps.flags |= uint64_t(1) << 63;
    uint32_t count = 77;
    test.result(test.sdk.agaaQueryCapabilities(&caps, &count, nullptr), AGAA_ERROR_OUT_OF_RANGE,
                "agaaQueryCapabilities with an unknown flag of AgaaDeviceCaps");
    test.check(count == 77, "agaaQueryCapabilities fails and changes count.");
}

void testTooSmall(Test& test) {
    std::vector<AgaaCapability> rows = capabilitiesOf(test, nullptr);
    for (AgaaCapability& row : rows)
        row.samples = 777;
    for (const uint32_t length : {0u, 1u, uint32_t(rows.size()) - 1}) {
        uint32_t count = length;
        test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, rows.data()), AGAA_ERROR_BUFFER_TOO_SMALL,
                    "agaaQueryCapabilities with " + std::to_string(length) + " elements");
        test.check(count == length && rows[0].samples == 777, "agaaQueryCapabilities fails and writes.");
    }
    uint32_t count = uint32_t(rows.size()) + 5;
    test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, rows.data()), AGAA_OK,
                "agaaQueryCapabilities with a longer array");
    test.check(count == rows.size(), "agaaQueryCapabilities does not return the number of entries.");
}

// Elements of a later header have a larger stride.
void testArraySteps(Test& test) {
    const std::vector<AgaaCapability> expected = capabilitiesOf(test, nullptr);
    const size_t stride = sizeof(AgaaCapability) + 40;
    Bytes array(expected.size() * stride + 64);
    const auto element = [&](size_t i) { return reinterpret_cast<AgaaCapability*>(array.data() + i * stride); };
    for (size_t i = 0; i < expected.size(); ++i)
        test.sdk.agaaInitCapability(element(i), stride);
    uint32_t count = uint32_t(expected.size());
    test.requireOk(test.sdk.agaaQueryCapabilities(nullptr, &count, element(0)),
                   "agaaQueryCapabilities with larger elements");
    for (size_t i = 0; i < expected.size(); ++i) {
        AgaaCapability got = *element(i);
        test.check(got.structSize == stride, "agaaQueryCapabilities changes structSize of an element.");
        got.structSize = sizeof got;
        test.check(std::memcmp(&got, &expected[i], sizeof got) == 0,
                   "agaaQueryCapabilities does not step by the caller's structSize: element " + std::to_string(i) +
                       " differs.");
    }
    test.check(array.findDifference(expected.size() * stride, array.size(), Bytes::pattern) == array.size(),
               "agaaQueryCapabilities writes beyond an array of larger elements.");
    element(1)->structSize = sizeof(AgaaCapability);
    test.result(test.sdk.agaaQueryCapabilities(nullptr, &count, element(0)), AGAA_ERROR_STRUCT,
                "agaaQueryCapabilities with elements of different structSizes");
}

} // namespace

std::vector<AgaaDeviceCaps> capsOfDevices(Test& test) {
    const AgaaDeviceCaps ideal = ViewParts(test.sdk, nullptr).caps;
    std::vector<AgaaDeviceCaps> all;
    for (const uint32_t counts : {0x7Fu, 0x3Fu, 0x0Fu, 0x05u, 0x01u})
        for (const uint64_t without :
             {UINT64_C(0), uint64_t(AGAA_DEVICE_POST_DEPTH_COVERAGE),
              AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_SAMPLE_RATE_SHADING, uint64_t(AGAA_DEVICE_FRAGMENT_ATOMICS),
              uint64_t(AGAA_DEVICE_GEOMETRY_SHADERS), idealDeviceFlags}) {
            all.push_back(ideal);
            all.back().sampleCounts = counts;
            all.back().flags &= ~without;
        }
    return all;
}

void addCapabilityCases(Suite& suite) {
    suite.core("AgaaCapability.stage/enum", testStages);
    suite.core("AgaaCapability.tier/enum", testTiers);
    suite.core("AgaaCapability.reason/sentence", testSentences);
    suite.core("AgaaCapability.reserved/zero", [](Test& test) {
        forEachRow(test, [&](const AgaaCapability& row) {
            test.check(row.reserved == 0, nameOf(row) + ": the reserved member is not 0.");
        });
    });
    suite.core("AgaaCapability/header/array", testArraySteps);
    suite.core("agaaQueryCapabilities/caps.null", testCapsNull);
    suite.core("agaaQueryCapabilities/capabilities.null", testCapabilitiesNull);
    suite.core("agaaQueryCapabilities/AGAA_ERROR_INVALID_ARGUMENT", testInvalid);
    suite.core("agaaQueryCapabilities/AGAA_ERROR_STRUCT", testStruct);
    suite.core("agaaQueryCapabilities/AGAA_ERROR_OUT_OF_RANGE", testRange);
    suite.core("agaaQueryCapabilities/AGAA_ERROR_OUT_OF_RANGE/flags", testUnknownFlag);
    suite.core("agaaQueryCapabilities/AGAA_ERROR_BUFFER_TOO_SMALL", testTooSmall);
}

} // namespace agaa::conformance
