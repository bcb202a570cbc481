// SPIR-V in a form that compresses well. Permutations of a pass differ in few bytes of it: ids of types, constants and
// global variables follow from their content, and references to other ids are distances.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace agaa {

// Ids below it are those of types, constants and global variables: of all results before the first function. From it on
// ids count the results of functions.
constexpr uint32_t spirvGlobalIds = 4096;

// The code begins with the five words of the header. An instruction is its opcode, the number of its operands' words,
// and these. All are numbers of seven bits a byte, lowest first. The lowest two bits of an operand tell what the others
// are.
enum class SpirvOperand : uint8_t {
    Literal, // the word
    Local,   // distance back from the next result; a negative one d is 2 * -d - 1, others 2 * d
    Global,  // the id of a type, constant or global variable
    Result,  // nothing: the operand is the next result
};

// Returns the module of the code, or nothing if the code does not have the form above.
std::vector<uint32_t> decodedSpirv(std::span<const uint8_t> code);

} // namespace agaa
