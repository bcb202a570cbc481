// A frame's data as the shaders read it.
#pragma once

#include "core/gpu_layout.h"
#include "core/plan.h"
#include "core/sample_patterns.h"

namespace agaa {

// positions: of the plan's samples, as samplePositions() gives them.
FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame,
                              const SamplePositions& positions);
// Fills an upload buffer of the plan; destination holds as many bytes as the resource.
void writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame,
                 const SamplePositions& positions, void* destination);

} // namespace agaa
