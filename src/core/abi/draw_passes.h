// Draw passes of a view as hosts see them.
#pragma once

#include "core/abi/handles.h"

namespace agaa {

// What the draw callback of a pass gets, but for what is the graphics API's.
AgaaDrawTarget emptyTarget(const Plan& plan, const Pass& pass);

// Two-call convention.
AgaaResult writeDrawPasses(const ViewState& view, uint32_t* count, AgaaDrawPass* passes);

} // namespace agaa
