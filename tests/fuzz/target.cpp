#include "target.h"

namespace fuzz {

void checkLine(std::string_view call, std::string_view message) {
    for (const char c : message)
        if (static_cast<unsigned char>(c) < 32 || c == 127)
            return report(std::string(call) + " with a control character in \"" + std::string(message) + "\"");
}

} // namespace fuzz
