#include "core/base/embedded.h"

#include "core/base/error.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace agaa {

namespace {

// A pass permutation, which agaa-compile-passes writes.
struct SpirvModule {
    std::string_view name;
    const uint64_t* data;              // by zstd
    size_t bytes;                      // of data
    size_t words;                      // of the module
    std::array<uint64_t, 2> constants; // bit i: the module uses the specialisation constant i
};

#include "spirv_includes.inc"

constexpr const SpirvModule* modules[] = {
#include "spirv_table.inc"
};

const SpirvModule* findModule(std::string_view name) {
    const auto found = std::ranges::find(modules, name, [](const SpirvModule* each) { return each->name; });
    return found == std::end(modules) ? nullptr : *found;
}

struct TextRow {
    std::string_view path;
    std::string_view text;
};
constexpr TextRow textTable[] = {
#include "shader_texts.inc"
#include "written_glsl.inc"
};

} // namespace

bool hasSpirv(std::string_view name) { return findModule(name) != nullptr; }

std::vector<uint32_t> embeddedSpirv(std::string_view name) {
    const SpirvModule* found = findModule(name);
    if (!found)
        return {};
    std::vector<uint32_t> words(found->words);
    const size_t bytes = words.size() * sizeof(uint32_t);
    if (ZSTD_decompress(words.data(), bytes, found->data, found->bytes) != bytes)
        fail(AGAA_ERROR_INTERNAL, "the shader " + std::string(name) + " cannot be decompressed.");
    return words;
}

bool readsConstant(std::string_view name, uint32_t specId) {
    const SpirvModule* found = findModule(name);
    return found && specId < 64 * found->constants.size() && found->constants[specId / 64] >> specId % 64 & 1;
}

std::string_view embeddedGlsl(std::string_view path) {
    for (const TextRow& row : textTable)
        if (row.path == path)
            return row.text;
    return {};
}

} // namespace agaa
