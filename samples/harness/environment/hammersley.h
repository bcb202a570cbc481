// Points of a sequence that fill the unit square evenly.
#pragma once

#include <glm/glm.hpp>

namespace harness {

// Returns point i of `count`.
inline glm::dvec2 hammersley(uint32_t i, uint32_t count) {
    double inverse = 0, digit = 0.5;
    for (uint32_t bits = i; bits; bits >>= 1, digit *= 0.5)
        inverse += bits & 1 ? digit : 0;
    return {(i + 0.5) / count, inverse};
}

} // namespace harness
