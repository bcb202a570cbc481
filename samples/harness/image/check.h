// What every function that takes an image expects of it.
#pragma once

#include "image/image.h"

#include <string>

namespace harness {

// "640x360"
std::string sizeOf(const Image& image);

// Throws std::runtime_error where the image has no pixels or not 3 values for each of them; `what`
// is the subject of the message, one sentence.
void requireConsistent(const Image& image, const std::string& what);

} // namespace harness
