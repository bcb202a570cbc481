// Numbered binding points that frames may change. Only these are saved: a context has hundreds, and saving all would
// cost the host time.
#pragma once

#include <cstdint>
#include <vector>

namespace agaa::gl {

// Binding points beyond the context's limits are ignored. Repeated ones are allowed.
struct StateScope {
    std::vector<uint32_t> textureUnits;
    std::vector<uint32_t> uniformBindings;
    std::vector<uint32_t> storageBindings;
    std::vector<uint32_t> imageUnits;
};

} // namespace agaa::gl
