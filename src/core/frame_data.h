// A frame's data as the shaders read it.
#pragma once

#include "core/gpu_layout.h"
#include "core/plan.h"

namespace agaa {

FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame);
// destination: lightBufferBytes(maxLights) bytes.
void writeLights(const AgaaFrame& frame, void* destination);

} // namespace agaa
