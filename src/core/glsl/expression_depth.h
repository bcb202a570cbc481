// The depth of statements in a host's GLSL. Compilers walk statements by recursion, and the process ends where the
// stack ends.
#pragma once

#include <cstddef>
#include <string_view>

namespace agaa {

// glslang takes about 1 KiB of stack for each level, and threads may have stacks of 1 MiB.
inline constexpr size_t maxExpressionDepth = 500;

// Returns the largest number of brackets, operators and statements that are within each other. Operators at one level
// count one by one, because compilers nest them. Commas between arguments and between elements of lists do not count.
// Macros are not expanded.
size_t expressionDepth(std::string_view text);

} // namespace agaa
