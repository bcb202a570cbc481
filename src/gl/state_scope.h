// Which numbered binding points a view's frames may change: only these are saved, so that hosts do
// not pay for the hundreds that a context has.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace agaa::gl {

// Binding points beyond the context's limits are left out, repeated ones do no harm.
struct StateScope {
    std::vector<uint32_t> textureUnits;
    std::vector<uint32_t> uniformBindings;
    std::vector<uint32_t> storageBindings;
    std::vector<uint32_t> imageUnits;
    // The calls without an index (glColorMask, glViewport, …) set all of them, and hosts use those
    // calls in their draw callbacks; fewer is right only where nobody does.
    uint32_t drawBuffers = std::numeric_limits<uint32_t>::max();
    uint32_t viewports = std::numeric_limits<uint32_t>::max();
};

} // namespace agaa::gl
