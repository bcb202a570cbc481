// Checks of image arguments.
#pragma once

#include "image/image.h"

#include <string>

namespace harness {

// "640x360"
std::string sizeOf(const Image& image);

// Throws std::runtime_error if the image has no pixels, or not 3 values per pixel. The message is one sentence with the
// subject `what`.
void requireConsistent(const Image& image, const std::string& what);

} // namespace harness
