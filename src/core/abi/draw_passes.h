// Draw passes of a view as hosts see them.
#pragma once

#include "core/abi/handles.h"

namespace agaa {

// Two-call convention.
AgaaResult writeDrawPasses(const ViewState& view, uint32_t* count, AgaaDrawPass* passes);

} // namespace agaa
