// Structs of hosts that were compiled against earlier and later headers: every versioned struct.
#include "core/base/structs.h"
#include "gl/structs.h"
#include "vk/structs.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace agaa {
namespace {

struct Case {
    StructRow row;
    std::vector<unsigned char> initial;               // AGAA_…_INIT
    void (*init)(void* structure, size_t structSize); // agaaInit…
};

std::vector<Case> allStructs() {
    std::vector<Case> cases;
#define AGAA_STRUCT(Name, TYPE, bytes)                                                                                 \
    {                                                                                                                  \
        const Agaa##Name value = AGAA_##TYPE##_INIT;                                                                   \
        const auto* from = reinterpret_cast<const unsigned char*>(&value);                                             \
        cases.push_back({StructOf<Agaa##Name>::row, {from, from + sizeof value}, [](void* structure, size_t size) {    \
                             agaaInit##Name(static_cast<Agaa##Name*>(structure), size);                                \
                         }});                                                                                          \
    }
#define AGAA_VK_STRUCT AGAA_STRUCT
#define AGAA_GL_STRUCT AGAA_STRUCT
#include "core/base/structs.inc"
    return cases;
}

AgaaStructHeader& headerOf(std::vector<unsigned char>& bytes) {
    return *reinterpret_cast<AgaaStructHeader*>(bytes.data());
}

// AGAA_OK where it throws nothing.
AgaaResult checked(const std::vector<unsigned char>& bytes, const StructRow& row, std::string* message = nullptr) {
    try {
        checkStruct(bytes.data(), row);
    } catch (const Error& error) {
        if (message)
            *message = error.message;
        return error.code;
    }
    return AGAA_OK;
}

TEST(Structs, BeginWithTheirHeader) {
    const std::vector<Case> cases = allStructs();
    EXPECT_EQ(cases.size(), 47u);
    for (const Case& c : cases) {
        std::vector<unsigned char> bytes = c.initial;
        EXPECT_EQ(headerOf(bytes).sType, c.row.sType) << c.row.name;
        EXPECT_EQ(headerOf(bytes).structSize, c.row.size) << c.row.name;
        EXPECT_EQ(headerOf(bytes).pNext, nullptr) << c.row.name;
        EXPECT_EQ(checked(bytes, c.row), AGAA_OK) << c.row.name;
        headerOf(bytes).sType ^= 1;
        EXPECT_EQ(checked(bytes, c.row), AGAA_ERROR_STRUCT) << c.row.name;
    }
}

// Of an earlier version: what it lacks has its default, at every size.
TEST(Structs, OfEarlierVersionsHaveDefaults) {
    for (const Case& c : allStructs()) {
        for (size_t first = sizeof(AgaaStructHeader); first < c.row.size; first += 8) {
            StructRow row = c.row;
            row.firstSize = first;
            std::vector<unsigned char> bytes(first, 0xA5); // no more memory than the host has
            headerOf(bytes) = {row.sType, uint32_t(first), nullptr};
            EXPECT_EQ(checked(bytes, row), AGAA_OK) << row.name << ' ' << first;
            std::vector<unsigned char> value = c.initial;
            copyKnown(bytes.data(), value.data(), value.size());
            for (size_t i = 0; i < value.size(); ++i)
                ASSERT_EQ(value[i], i < first ? bytes[i] : c.initial[i]) << row.name << ' ' << first << ' ' << i;
            headerOf(bytes).structSize -= 8;
            EXPECT_EQ(checked(bytes, row), AGAA_ERROR_STRUCT) << row.name << ' ' << first;
            headerOf(bytes).structSize += 12; // elements of arrays would not be aligned
            EXPECT_EQ(checked(bytes, row), AGAA_ERROR_STRUCT) << row.name << ' ' << first;
        }
        std::vector<unsigned char> bytes = c.initial;
        headerOf(bytes).structSize = uint32_t(c.row.firstSize - 1);
        EXPECT_EQ(checked(bytes, c.row), AGAA_ERROR_STRUCT) << c.row.name << " below that of version 0.2";
    }
}

// Of a later version: what this one does not know must be 0.
TEST(Structs, OfLaterVersionsMayNotSayWhatIsNotKnown) {
    for (const Case& c : allStructs())
        for (const size_t more : {size_t(8), size_t(200)}) {
            std::vector<unsigned char> bytes = c.initial;
            bytes.resize(bytes.size() + more, 0);
            headerOf(bytes).structSize = uint32_t(bytes.size());
            EXPECT_EQ(checked(bytes, c.row), AGAA_OK) << c.row.name << ' ' << more;
            bytes.back() = 1;
            std::string message;
            EXPECT_EQ(checked(bytes, c.row, &message), AGAA_ERROR_VERSION) << c.row.name << ' ' << more;
            EXPECT_NE(message.find("offset " + std::to_string(bytes.size() - 1)), std::string::npos) << message;
            headerOf(bytes).structSize = 1u << 20; // not initialised: nothing is read so far
            EXPECT_EQ(checked(bytes, c.row), AGAA_ERROR_STRUCT) << c.row.name;
        }
}

TEST(Structs, AreWrittenUpToTheSizeOfTheHost) {
    for (const Case& c : allStructs()) {
        std::vector<unsigned char> value(c.row.size, 0x5A);
        for (const size_t size : {c.row.size, c.row.size + 24}) {
            std::vector<unsigned char> bytes(size + 8, 0);
            const AgaaStructHeader header = {c.row.sType, uint32_t(size), &value};
            headerOf(bytes) = header;
            writeKnown(bytes.data(), value.data(), value.size());
            EXPECT_EQ(std::memcmp(bytes.data(), &header, sizeof header), 0) << c.row.name;
            for (size_t i = sizeof header; i < bytes.size(); ++i)
                ASSERT_EQ(bytes[i], i < c.row.size ? 0x5A : 0) << c.row.name << ' ' << i;
        }
        const size_t less = c.row.size - 4;
        std::vector<unsigned char> bytes(c.row.size, 0);
        headerOf(bytes) = {c.row.sType, uint32_t(less), nullptr};
        writeKnown(bytes.data(), value.data(), value.size());
        EXPECT_TRUE(std::all_of(bytes.begin() + ptrdiff_t(less), bytes.end(), [](unsigned char b) { return b == 0; }))
            << c.row.name;
    }
}

TEST(Structs, AreInitialisedByFunctionsAsByMacros) {
    for (const Case& c : allStructs()) {
        std::vector<unsigned char> bytes(c.row.size + 16, 0xEE);
        c.init(bytes.data(), c.row.size);
        std::vector<unsigned char> expected = c.initial;
        if (c.row.sType == AGAA_STRUCTURE_TYPE_FRAME) { // sizes that only the host knows
            auto& frame = *reinterpret_cast<AgaaFrame*>(expected.data());
            frame.lightSize = frame.shadowSize = 0;
        }
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), bytes.begin())) << c.row.name;
        EXPECT_EQ(bytes[c.row.size], 0xEE) << c.row.name;
        c.init(bytes.data(), c.row.size + 8); // of a later header
        EXPECT_EQ(headerOf(bytes).structSize, c.row.size + 8) << c.row.name;
        EXPECT_EQ(bytes[c.row.size + 7], 0) << c.row.name;
        EXPECT_EQ(bytes[c.row.size + 8], 0xEE) << c.row.name;
        c.init(nullptr, 0);
    }
    AgaaLight light, expectedLight = AGAA_LIGHT_INIT;
    agaaInitLight(&light, sizeof light);
    EXPECT_EQ(std::memcmp(&light, &expectedLight, sizeof light), 0);
    AgaaShadow shadow, expectedShadow = AGAA_SHADOW_INIT;
    agaaInitShadow(&shadow, sizeof shadow);
    EXPECT_EQ(std::memcmp(&shadow, &expectedShadow, sizeof shadow), 0);
    AgaaLayoutAttribute attribute, expectedAttribute = AGAA_LAYOUT_ATTRIBUTE_INIT;
    agaaInitLayoutAttribute(&attribute);
    EXPECT_EQ(std::memcmp(&attribute, &expectedAttribute, sizeof attribute), 0);
}

// Elements of arrays without headers.
TEST(Structs, ElementsStepByTheSizeOfTheHost) {
    struct Longer {
        AgaaLight light;
        uint32_t more[2];
    };
    Longer lights[3] = {{AGAA_LIGHT_INIT, {0, 0}}, {AGAA_LIGHT_INIT, {0, 0}}, {AGAA_LIGHT_INIT, {0, 0}}};
    lights[2].light.radius = 7;
    const auto check = [&](uint32_t bytes, uint32_t count) -> AgaaResult {
        try {
            checkElements(lights, bytes, count, sizeof(AgaaLight), sizeof(AgaaLight), "AgaaFrame::lightSize");
        } catch (const Error& error) {
            return error.code;
        }
        return AGAA_OK;
    };
    EXPECT_EQ(check(sizeof(Longer), 3), AGAA_OK);
    EXPECT_EQ(readElement<AgaaLight>(&lights[0].light, sizeof(Longer), 2, AGAA_LIGHT_INIT).radius, 7.0f);
    lights[1].more[1] = 1;
    EXPECT_EQ(check(sizeof(Longer), 3), AGAA_ERROR_VERSION);
    EXPECT_EQ(check(sizeof(AgaaLight) - 4, 1), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(check(sizeof(AgaaLight) + 2, 1), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(check(0, 1), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(check(0, 0), AGAA_OK);
}

} // namespace
} // namespace agaa
