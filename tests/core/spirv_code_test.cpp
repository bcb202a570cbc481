// The decoder of SPIR-V. The build compares what it decodes of every module with what was encoded.
#include "core/base/spirv_code.h"

#include <gtest/gtest.h>

#include <random>

using namespace agaa;

namespace {

constexpr uint8_t header[] = {1, 2, 3, 4, 5};
constexpr uint32_t next = spirvGlobalIds;

std::vector<uint32_t> decoded(std::initializer_list<uint8_t> instructions) {
    std::vector<uint8_t> code(std::begin(header), std::end(header));
    code.insert(code.end(), instructions);
    return decodedSpirv(code);
}

uint8_t operand(SpirvOperand kind, uint32_t value) { return uint8_t(value << 2 | uint32_t(kind)); }

TEST(SpirvCode, WordsAreThoseOfTheirKinds) {
    const std::vector<uint32_t> words = decoded({54, 3, operand(SpirvOperand::Global, 7),
                                                 operand(SpirvOperand::Result, 0), operand(SpirvOperand::Literal, 9), //
                                                 61, 3, operand(SpirvOperand::Local, 2),
                                                 operand(SpirvOperand::Result, 0), operand(SpirvOperand::Local, 1)});
    // A distance of 2 is 1 back, after the first result; 1 is one forward, after the second.
    EXPECT_EQ(words, (std::vector<uint32_t>{1, 2, 3, 4, 5, 4u << 16 | 54, 7, next, 9, 4u << 16 | 61, next, next + 1,
                                            next + 3}));
}

TEST(SpirvCode, NumbersHaveSevenBitsAByte) {
    // 0xFFFFFFFF << 2
    const std::vector<uint32_t> words = decoded({0xAC, 0x02, 1, 0xFC, 0xFF, 0xFF, 0xFF, 0x3F});
    EXPECT_EQ(words, (std::vector<uint32_t>{1, 2, 3, 4, 5, 2u << 16 | 300, 0xFFFFFFFF}));
}

TEST(SpirvCode, NothingIsDecodedOfOtherBytes) {
    EXPECT_TRUE(decodedSpirv({}).empty());
    EXPECT_TRUE(decodedSpirv(std::span(header, 4)).empty());
    EXPECT_TRUE(decoded({54}).empty());                                       // without a count
    EXPECT_TRUE(decoded({54, 2, operand(SpirvOperand::Literal, 1)}).empty()); // without the second operand
    EXPECT_TRUE(decoded({54, 1, 0x80}).empty());                              // a number that does not end
    EXPECT_TRUE(decoded({0x80, 0x80, 0x04, 0}).empty());                      // the opcode 65536
    EXPECT_TRUE(decoded({54, 0xFF, 0xFF, 0x03}).empty());                     // 65535 operands
    EXPECT_TRUE(decoded({54, 1, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0}).empty());
    std::mt19937 random(1);
    for (int i = 0; i < 10000; ++i) {
        std::vector<uint8_t> code(random() % 64);
        for (uint8_t& byte : code)
            byte = uint8_t(random());
        EXPECT_LE(decodedSpirv(code).size(), code.size() + 5);
    }
}

} // namespace
