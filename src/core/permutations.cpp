#include "core/permutations.h"

#include "core/error.h"

#include <iterator>

namespace agaa {

namespace {

struct Switch {
    char letter;
    const char* macro;
};
constexpr Switch switches[] = {
#define AGAA_SWITCH(letter, macro) {#letter[0], #macro},
#define AGAA_PASS(shader, letters, never)
#define AGAA_HOST_PASS(shader, letters)
#include "shaders/passes/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_HOST_PASS
};

struct PassRow {
    std::string_view shader, letters;
};
constexpr PassRow passes[] = {
#define AGAA_SWITCH(letter, macro)
#define AGAA_PASS(shader, letters, never) {#shader, letters},
#define AGAA_HOST_PASS(shader, letters) {#shader, letters},
#include "shaders/passes/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_HOST_PASS
};

} // namespace

std::string_view passSwitches(std::string_view shader) {
    for (const PassRow& row : passes)
        if (row.shader == shader)
            return row.letters;
    fail(AGAA_ERROR_INTERNAL, "permutations.inc has no pass \"" + std::string(shader) + "\".");
}

const char* switchMacro(char letter) {
    for (const Switch& row : switches)
        if (row.letter == letter)
            return row.macro;
    fail(AGAA_ERROR_INTERNAL, std::string("permutations.inc has no switch ") + letter + ".");
}

} // namespace agaa
