// A frame's data as the shaders read it.
#pragma once

#include "core/gpu_layout.h"
#include "core/plan.h"
#include "core/sample_patterns.h"

namespace agaa {

// positions: of the plan's samples, as samplePositions() gives them. newest: counters of the newest finished frame, or
// null where there is none or the plan does not ask for them.
FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame,
                              const SamplePositions& positions, const CounterBuffer* newest = nullptr);
// Fills an upload buffer of the plan; destination holds as many bytes as the resource.
void writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame,
                 const SamplePositions& positions, const CounterBuffer* newest, void* destination);

} // namespace agaa
