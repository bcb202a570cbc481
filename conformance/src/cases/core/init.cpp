// AGAA_…_INIT and agaaInit… give the same struct.
#include "cases.h"
#include "structs.h"

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

namespace {

constexpr size_t guardBytes = 64, moreBytes = 4096;

struct InitRow {
    std::string name;
    std::vector<unsigned char> expected; // result of agaaInit… with this size
    std::function<void(const Functions&, void*, size_t)> init;
};

// AgaaConfig points to a string of the header or of the library.
void takeTechnique(AgaaConfig& config, const std::vector<unsigned char>& expected) {
    const char* technique = reinterpret_cast<const AgaaConfig*>(expected.data())->technique;
    if (config.technique && std::strcmp(config.technique, technique) == 0)
        config.technique = technique;
}

void testInit(Test& test, const InitRow& row) {
    const size_t size = row.expected.size();
    Bytes bytes(size + guardBytes);
    row.init(test.sdk, bytes.data(), size);
    if (row.name == "AgaaConfig")
        takeTechnique(*reinterpret_cast<AgaaConfig*>(bytes.data()), row.expected);
    const auto first = std::mismatch(row.expected.begin(), row.expected.end(), bytes.data()).first;
    test.check(first == row.expected.end(), row.name + ": the function and the macro differ at offset " +
                                                std::to_string(first - row.expected.begin()) + ".");
    test.check(bytes.findDifference(size, bytes.size(), Bytes::pattern) == bytes.size(),
               row.name + ": the function writes beyond structSize.");
}

// A host with an older header has a smaller struct: only its members are written.
void testSmaller(Test& test, const InitRow& row, size_t size) {
    Bytes bytes(row.expected.size() + guardBytes);
    row.init(test.sdk, bytes.data(), size);
    test.check(bytes.findDifference(size, bytes.size(), Bytes::pattern) == bytes.size(),
               row.name + ": the function writes beyond structSize = " + std::to_string(size) + ".");
}

// A later header has a larger struct: bytes that the library does not know become 0. A later library knows some of
// them.
void testLarger(Test& test, const InitRow& row, bool hasHeader) {
    const size_t size = row.expected.size();
    Bytes bytes(size + moreBytes + guardBytes);
    row.init(test.sdk, bytes.data(), size + moreBytes);
    const size_t unknown = isSameVersion(test) ? size : size + moreBytes - 64;
    test.check(bytes.findDifference(unknown, size + moreBytes, 0) == bytes.size(),
               row.name + ": bytes that the library does not know are not 0 after the function.");
    test.check(bytes.findDifference(size + moreBytes, bytes.size(), Bytes::pattern) == bytes.size(),
               row.name + ": the function writes beyond a structSize that is larger than the library's.");
    if (hasHeader)
        test.check(bytes.header().structSize == size + moreBytes, row.name + ": the function does not set structSize.");
}

std::vector<unsigned char> expectedOf(const StructRow& row) {
    std::vector<unsigned char> expected = row.initial;
    if (row.sType == AGAA_STRUCTURE_TYPE_FRAME) { // the host must set the sizes of its lights and shadows
        const uint32_t zero = 0;
        std::memcpy(expected.data() + offsetof(AgaaFrame, lightSize), &zero, sizeof zero);
        std::memcpy(expected.data() + offsetof(AgaaFrame, shadowSize), &zero, sizeof zero);
    }
    return expected;
}

template <class T> std::vector<unsigned char> bytesOf(const T& value) {
    const auto* from = reinterpret_cast<const unsigned char*>(&value);
    return {from, from + sizeof value};
}

const AgaaLight initialLight = AGAA_LIGHT_INIT;
const AgaaShadow initialShadow = AGAA_SHADOW_INIT;
const AgaaLayoutAttribute initialAttribute = AGAA_LAYOUT_ATTRIBUTE_INIT;

} // namespace

void addInitCases(Suite& suite) {
    for (const StructRow& row : versionedStructs())
        suite.core(row.name + "/init", [&row](Test& test) {
            const InitRow init{row.name, expectedOf(row), row.init};
            testInit(test, init);
            testSmaller(test, init, sizeof(AgaaStructHeader));
            testSmaller(test, init, row.firstSize);
            testLarger(test, init, true);
        });
    const auto addPlain = [&](const InitRow& init) {
        suite.core(init.name + "/init", [init](Test& test) {
            testInit(test, init);
            testSmaller(test, init, 8);
            testLarger(test, init, false);
        });
    };
    addPlain({"AgaaLight", bytesOf(initialLight), [](const Functions& sdk, void* light, size_t size) {
                  sdk.agaaInitLight(static_cast<AgaaLight*>(light), size);
              }});
    addPlain({"AgaaShadow", bytesOf(initialShadow), [](const Functions& sdk, void* shadow, size_t size) {
                  sdk.agaaInitShadow(static_cast<AgaaShadow*>(shadow), size);
              }});
    suite.core("AgaaLayoutAttribute/init", [](Test& test) {
        testInit(test,
                 {"AgaaLayoutAttribute", bytesOf(initialAttribute), [](const Functions& sdk, void* attribute, size_t) {
                      sdk.agaaInitLayoutAttribute(static_cast<AgaaLayoutAttribute*>(attribute));
                  }});
    });
}

} // namespace agaa::conformance
