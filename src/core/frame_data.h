// A frame's data as the shaders read it.
#pragma once

#include "core/gpu_layout.h"
#include "core/plan.h"

namespace agaa {

FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame);
// Fills an upload buffer of the plan; destination holds as many bytes as the resource.
void writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame,
                 void* destination);

} // namespace agaa
