#include "encode.h"

#include "core/base/spirv_code.h"

#include <spirv-tools/libspirv.hpp>

#include <map>
#include <memory>
#include <set>
#include <stdexcept>

namespace {

using agaa::spirvGlobalIds;
using agaa::SpirvOperand;

enum Op : uint32_t { Function = 54, Decorate = 71, MemberDecorate = 72 };
constexpr size_t headerWords = 5;

enum class Kind : uint8_t { Literal, Reference, Result };

struct Instruction {
    uint32_t opcode;
    uint32_t result; // id, or 0
    std::vector<uint32_t> operands;
    std::vector<Kind> kinds; // of the words of the operands
};

bool isId(spv_operand_type_t type) {
    return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_TYPE_ID || type == SPV_OPERAND_TYPE_SCOPE_ID ||
           type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID;
}

std::vector<Instruction> parsed(std::span<const uint32_t> spirv) {
    std::vector<Instruction> instructions;
    const auto append = [](void* list, const spv_parsed_instruction_t* from) {
        Instruction each = {from->opcode, from->result_id, {from->words + 1, from->words + from->num_words}, {}};
        each.kinds.assign(each.operands.size(), Kind::Literal);
        for (const spv_parsed_operand_t& operand : std::span(from->operands, from->num_operands)) {
            if (operand.type == SPV_OPERAND_TYPE_RESULT_ID)
                each.kinds[operand.offset - 1] = Kind::Result;
            else if (isId(operand.type))
                each.kinds[operand.offset - 1] = Kind::Reference;
        }
        static_cast<std::vector<Instruction>*>(list)->push_back(std::move(each));
        return SPV_SUCCESS;
    };
    const std::unique_ptr<spv_context_t, decltype(&spvContextDestroy)> context(spvContextCreate(SPV_ENV_UNIVERSAL_1_6),
                                                                               spvContextDestroy);
    if (spvBinaryParse(context.get(), &instructions, spirv.data(), spirv.size(), nullptr, append, nullptr) !=
        SPV_SUCCESS)
        throw std::runtime_error("SPIRV-Tools cannot read the module");
    return instructions;
}

uint64_t mixed(uint64_t hash, uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15; // 2^64 by the golden ratio: Knuth's multiplicative hashing
    return hash ^ hash >> 29;
}

// New ids of a module. Those of types, constants and global variables are hashes of their content and decorations, so
// that permutations that have them agree in their ids; the others are counted.
class Numbers {
public:
    explicit Numbers(const std::vector<Instruction>& instructions) {
        hashDecorations(instructions);
        uint32_t next = spirvGlobalIds;
        bool isGlobal = true;
        for (const Instruction& each : instructions) {
            isGlobal = isGlobal && each.opcode != Function;
            if (each.result != 0)
                ids_[each.result] = isGlobal ? globalId(each) : next++;
        }
        bound_ = next;
    }

    uint32_t of(uint32_t id) const { return ids_.at(id); }
    uint32_t bound() const { return bound_; }

private:
    void hashDecorations(const std::vector<Instruction>& instructions) {
        for (const Instruction& each : instructions)
            if (each.opcode == Decorate || each.opcode == MemberDecorate)
                for (const uint32_t word : std::span(each.operands).subspan(1))
                    decorations_[each.operands[0]] = mixed(decorations_[each.operands[0]], word + 1);
    }

    uint32_t globalId(const Instruction& each) {
        uint64_t hash = mixed(each.opcode, decorations_[each.result]);
        for (size_t i = 0; i < each.operands.size(); ++i)
            if (each.kinds[i] != Kind::Result)
                hash = mixed(hash, each.kinds[i] == Kind::Reference ? hashes_[each.operands[i]] : each.operands[i]);
        hash = mixed(hash, alike_[hash]++);
        hashes_[each.result] = hash;
        if (taken_.size() > spirvGlobalIds / 2)
            throw std::runtime_error("the module has too many types, constants and variables");
        uint32_t id = uint32_t(hash % spirvGlobalIds);
        while (id == 0 || taken_.contains(id))
            id = (id + 1) % spirvGlobalIds;
        taken_.insert(id);
        return id;
    }

    std::map<uint32_t, uint32_t> ids_;
    std::map<uint32_t, uint64_t> decorations_, hashes_;
    std::map<uint64_t, uint32_t> alike_; // how many had the hash
    std::set<uint32_t> taken_;
    uint32_t bound_ = 0;
};

std::set<uint32_t> usedConstants(const std::vector<Instruction>& instructions) {
    constexpr uint32_t specId = 1; // the decoration
    std::set<uint32_t> used, found;
    for (const Instruction& each : instructions)
        for (size_t i = 0; each.opcode != Decorate && i < each.operands.size(); ++i)
            if (each.kinds[i] == Kind::Reference)
                used.insert(each.operands[i]);
    for (const Instruction& each : instructions)
        if (each.opcode == Decorate && each.operands[1] == specId && used.contains(each.operands[0]))
            found.insert(each.operands[2]);
    return found;
}

void append(std::vector<uint8_t>& code, uint64_t number) {
    for (; number >= 0x80; number >>= 7)
        code.push_back(uint8_t(number | 0x80));
    code.push_back(uint8_t(number));
}

void append(std::vector<uint8_t>& code, SpirvOperand kind, uint64_t value) {
    append(code, value << 2 | uint64_t(kind));
}

} // namespace

EncodedModule encoded(std::span<const uint32_t> spirv) {
    const std::vector<Instruction> instructions = parsed(spirv);
    const Numbers numbers(instructions);
    EncodedModule module;
    module.constants = usedConstants(instructions);
    module.words.assign(spirv.begin(), spirv.begin() + headerWords);
    module.words[3] = numbers.bound();
    for (const uint32_t word : module.words)
        append(module.code, word);
    int64_t next = spirvGlobalIds;
    for (const Instruction& each : instructions) {
        module.words.push_back(uint32_t(each.operands.size() + 1) << 16 | each.opcode);
        append(module.code, each.opcode);
        append(module.code, each.operands.size());
        for (size_t i = 0; i < each.operands.size(); ++i) {
            const bool isLiteral = each.kinds[i] == Kind::Literal;
            const uint32_t word = isLiteral ? each.operands[i] : numbers.of(each.operands[i]);
            module.words.push_back(word);
            if (isLiteral) {
                append(module.code, SpirvOperand::Literal, word);
            } else if (word < spirvGlobalIds) {
                append(module.code, SpirvOperand::Global, word);
            } else if (each.kinds[i] == Kind::Result) {
                append(module.code, SpirvOperand::Result, 0);
                ++next;
            } else {
                const int64_t distance = next - int64_t(word);
                append(module.code, SpirvOperand::Local, uint64_t(distance < 0 ? -2 * distance - 1 : 2 * distance));
            }
        }
    }
    if (!spvtools::SpirvTools(SPV_ENV_UNIVERSAL_1_6).Validate(module.words))
        throw std::runtime_error("the module with new ids is invalid");
    return module;
}
