// The switches that compute passes are compiled for (src/shaders/tables/permutations.inc).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace agaa {

enum class Switch : uint32_t {
#define AGAA_SWITCH(letter, name, macro) name,
#define AGAA_PASS(...)
#define AGAA_NEVER(...)
#define AGAA_HOST_PASS(...)
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_NEVER
#undef AGAA_HOST_PASS
};

struct SwitchSetting {
    Switch which;
    bool isOn;
};

// The shader's file below src/shaders. Throws Error for a shader that the table does not have.
const char* passFile(std::string_view shader);
// The switches of a pass, in the order of permutations' names. Throws Error for a shader that the table does not have.
std::span<const Switch> passSwitches(std::string_view shader);
char switchLetter(Switch which);
const char* switchMacro(Switch which);

} // namespace agaa
