// Which numbered binding points a view's frames may change: only these are saved, so that hosts do
// not pay for the hundreds that a context has.
#pragma once

#include <cstdint>
#include <vector>

namespace agaa::gl {

// Binding points beyond the context's limits are left out, repeated ones do no harm.
struct StateScope {
    std::vector<uint32_t> textureUnits;
    std::vector<uint32_t> uniformBindings;
    std::vector<uint32_t> storageBindings;
    std::vector<uint32_t> imageUnits;
};

} // namespace agaa::gl
