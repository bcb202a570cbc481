#include "core/plan/permutations.h"

#include "core/base/error.h"

#include <iterator>

namespace agaa {

namespace {

struct Switch {
    char letter;
    const char* macro;
};
constexpr Switch switches[] = {
#define AGAA_SWITCH(letter, macro) {#letter[0], #macro},
#define AGAA_PASS(folder, shader, letters, never)
#define AGAA_HOST_PASS(folder, shader, letters)
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_HOST_PASS
};

struct PassRow {
    std::string_view shader;
    const char* file; // below src/shaders
    std::string_view letters;
};
constexpr PassRow passes[] = {
#define AGAA_SWITCH(letter, macro)
#define AGAA_PASS(folder, shader, letters, never) {#shader, #folder "/" #shader ".comp", letters},
#define AGAA_HOST_PASS(folder, shader, letters) {#shader, #folder "/" #shader ".comp", letters},
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_HOST_PASS
};

} // namespace

static const PassRow& passRow(std::string_view shader) {
    for (const PassRow& row : passes)
        if (row.shader == shader)
            return row;
    fail(AGAA_ERROR_INTERNAL, "permutations.inc has no pass \"" + std::string(shader) + "\".");
}

const char* passFile(std::string_view shader) { return passRow(shader).file; }

std::string_view passSwitches(std::string_view shader) { return passRow(shader).letters; }

const char* switchMacro(char letter) {
    for (const Switch& row : switches)
        if (row.letter == letter)
            return row.macro;
    fail(AGAA_ERROR_INTERNAL, std::string("permutations.inc has no switch ") + letter + ".");
}

} // namespace agaa
