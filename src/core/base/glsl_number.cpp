#include "core/base/glsl_number.h"

#include <charconv>

namespace agaa {

std::string glslNumber(float value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    std::string text(digits, end);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

} // namespace agaa
