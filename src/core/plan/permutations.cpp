#include "core/plan/permutations.h"

#include "core/base/error.h"

#include <vector>

namespace agaa {

namespace {

struct SwitchRow {
    char letter;
    const char* macro;
};
constexpr SwitchRow switchRows[] = {
// The index is the Switch.
#define AGAA_SWITCH(letter, name, macro) {#letter[0], #macro},
#define AGAA_PASS(...)
#define AGAA_NEVER(...)
#define AGAA_HOST_PASS(...)
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_NEVER
#undef AGAA_HOST_PASS
};

struct PassRow {
    std::string_view shader;
    const char* file; // below src/shaders
    std::vector<Switch> switches;
};

const std::vector<PassRow>& passRows() {
    using enum Switch;
    static const std::vector<PassRow> rows = {
#define AGAA_SWITCH(letter, name, macro)
#define AGAA_PASS(folder, shader, ...) {#shader, #folder "/" #shader ".comp", {__VA_ARGS__}},
#define AGAA_NEVER(...)
#define AGAA_HOST_PASS(folder, shader, ...) {#shader, #folder "/" #shader ".comp", {__VA_ARGS__}},
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_NEVER
#undef AGAA_HOST_PASS
    };
    return rows;
}

const PassRow& passRow(std::string_view shader) {
    for (const PassRow& row : passRows())
        if (row.shader == shader)
            return row;
    fail(AGAA_ERROR_INTERNAL, "permutations.inc has no pass \"" + std::string(shader) + "\".");
}

} // namespace

const char* passFile(std::string_view shader) { return passRow(shader).file; }

std::span<const Switch> passSwitches(std::string_view shader) { return passRow(shader).switches; }

char switchLetter(Switch which) { return switchRows[uint32_t(which)].letter; }

const char* switchMacro(Switch which) { return switchRows[uint32_t(which)].macro; }

} // namespace agaa
