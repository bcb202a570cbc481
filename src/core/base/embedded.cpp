#include "core/base/embedded.h"

#include "core/base/error.h"
#include "core/base/spirv_code.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <new>

namespace agaa {

namespace {

// A pass permutation, which agaa-compile-passes writes.
struct SpirvModule {
    std::string_view name;
    const uint64_t* data;              // by zstd
    size_t bytes;                      // of data
    size_t codeBytes;                  // of the module, encoded (spirv_code.h)
    const SpirvModule* base;           // whose code data differs from, or null
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

std::vector<uint8_t> codeOf(const SpirvModule& module) {
    const std::vector<uint8_t> base = module.base ? codeOf(*module.base) : std::vector<uint8_t>();
    std::vector<uint8_t> code(module.codeBytes);
    const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
    if (!context)
        throw std::bad_alloc();
    size_t size = ZSTD_DCtx_refPrefix(context.get(), base.data(), base.size());
    if (!ZSTD_isError(size))
        size = ZSTD_decompressDCtx(context.get(), code.data(), code.size(), module.data, module.bytes);
    if (size != code.size())
        fail(AGAA_ERROR_INTERNAL, "the shader " + std::string(module.name) + " cannot be decompressed.");
    return code;
}

// A text among all texts, which agaa-embed-text writes.
struct TextRow {
    std::string_view path;
    size_t begin, size;
};
#include "shader_texts.inc"

std::string decompressedTexts() {
    std::string texts(textBytes, '\0');
    if (ZSTD_decompress(texts.data(), texts.size(), textData, textDataBytes) != texts.size())
        fail(AGAA_ERROR_INTERNAL, "the texts of shaders cannot be decompressed.");
    return texts;
}

} // namespace

bool hasSpirv(std::string_view name) { return findModule(name) != nullptr; }

std::vector<uint32_t> embeddedSpirv(std::string_view name) {
    const SpirvModule* found = findModule(name);
    if (!found)
        return {};
    std::vector<uint32_t> words = decodedSpirv(codeOf(*found));
    if (words.empty())
        fail(AGAA_ERROR_INTERNAL, "the shader " + std::string(name) + " cannot be decoded.");
    return words;
}

bool readsConstant(std::string_view name, uint32_t specId) {
    const SpirvModule* found = findModule(name);
    return found && specId < 64 * found->constants.size() && found->constants[specId / 64] >> specId % 64 & 1;
}

std::string_view embeddedGlsl(std::string_view path) {
    static const std::string texts = decompressedTexts();
    const auto row = std::ranges::find(textRows, path, &TextRow::path);
    return row == std::end(textRows) ? std::string_view() : std::string_view(texts).substr(row->begin, row->size);
}

} // namespace agaa
