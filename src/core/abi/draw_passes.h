// Draw passes as the public structs describe them.
#pragma once

#include "core/abi/handles.h"

namespace agaa {

// Writes all draw passes by the two-call convention.
AgaaResult writeDrawPasses(const ViewState& view, uint32_t* count, AgaaDrawPass* passes);
AgaaResult writeGlslResources(ViewState& view, uint32_t pass, uint32_t* count, AgaaGlslResource* resources);

} // namespace agaa
