// Text of files in messages.
#pragma once

#include <string>
#include <string_view>

namespace harness {

// Returns a file's text for a sentence: control characters become spaces, and long words, such as data URIs, are cut.
std::string shortened(std::string_view text);

} // namespace harness
