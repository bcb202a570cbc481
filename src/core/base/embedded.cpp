#include "core/base/embedded.h"

#include <algorithm>

namespace agaa {

namespace {

#include "spirv_includes.inc"

struct SpirvRow {
    std::string_view name;
    std::span<const uint32_t> words;
};
const SpirvRow spirvTable[] = {
#include "spirv_table.inc"
};

struct TextRow {
    std::string_view path;
    std::string_view text;
};
constexpr TextRow textTable[] = {
#include "shader_texts.inc"
#include "written_glsl.inc"
};

} // namespace

std::span<const uint32_t> embeddedSpirv(std::string_view name) {
    for (const SpirvRow& row : spirvTable)
        if (row.name == name)
            return row.words;
    return {};
}

std::string_view embeddedGlsl(std::string_view path) {
    for (const TextRow& row : textTable)
        if (row.path == path)
            return row.text;
    return {};
}

bool readsConstant(std::span<const uint32_t> spirv, uint32_t specId) {
    enum Op : uint32_t { Source = 3, Line = 8, Constant = 43, SpecConstant = 50, Decorate = 71 };
    constexpr uint32_t header = 5, decoratesSpecId = 1;
    // Calls visit(op, operands) for each instruction until it returns true.
    const auto any = [&](const auto& visit) {
        for (size_t at = header; at < spirv.size();) {
            const size_t words = std::max(spirv[at] >> 16, 1u);
            if (visit(spirv[at] & 0xFFFF, spirv.subspan(at + 1, std::min(words, spirv.size() - at) - 1)))
                return true;
            at += words;
        }
        return false;
    };
    uint32_t id = 0;
    any([&](uint32_t op, std::span<const uint32_t> operands) {
        if (op == Decorate && operands.size() == 3 && operands[1] == decoratesSpecId && operands[2] == specId)
            id = operands[0];
        return id != 0;
    });
    // Debug instructions and constants contain words that may equal the id without using it.
    return id != 0 && any([&](uint32_t op, std::span<const uint32_t> operands) {
               return !(op >= Source && op <= Line) && op != Constant && op != SpecConstant && op != Decorate &&
                      std::ranges::find(operands, id) != operands.end();
           });
}

} // namespace agaa
