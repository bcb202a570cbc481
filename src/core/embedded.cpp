#include "core/embedded.h"

#include <iterator>

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
#include "host_glsl.inc"
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

} // namespace agaa
