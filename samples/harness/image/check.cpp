#include "image/check.h"

#include <stdexcept>

namespace harness {

std::string sizeOf(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

void requireConsistent(const Image& image, const std::string& what) {
    if (image.width == 0 || image.height == 0)
        throw std::runtime_error(what + " has no pixels.");
    if (image.rgb.size() != image.pixelCount() * 3)
        throw std::runtime_error(what + " of " + sizeOf(image) + " pixels holds " + std::to_string(image.rgb.size()) +
                                 " values instead of " + std::to_string(image.pixelCount() * 3) + ".");
}

} // namespace harness
