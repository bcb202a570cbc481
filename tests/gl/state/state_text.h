// States in words, to name those that differ.
#pragma once

#include "gl/state_guard.h"

#include <string>
#include <vector>

namespace agaa::test {

struct StateText {
    std::string name; // of the row, with the element in brackets where it is repeated
    std::string value;
    bool operator==(const StateText&) const = default;
};

// What the guard has captured.
std::vector<StateText> describe(const gl::StateGuard& guard);

} // namespace agaa::test
