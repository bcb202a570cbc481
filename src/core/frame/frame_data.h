// A frame's data as the shaders read it.
#pragma once

#include "core/plan/gpu_layout.h"
#include "core/plan/plan.h"
#include "core/plan/sample_patterns.h"

#include <vector>

namespace agaa {

// positions: of the plan's samples, as samplePositions() gives them. newest: counters of the newest finished frame, or
// null where there is none or the plan does not ask for them.
FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame,
                              const SamplePositions& positions, const CounterBuffer* newest = nullptr);
// The same for `uniform vec4 agaa_constants[constantVectors]` (frame.glsl): whole numbers as floats, the number of a
// dither frame and the room of lists of fragments in two halves each.
uint32_t constantVectors(const Plan& plan);
std::vector<float> uniformConstants(const Plan& plan, const FrameConstants& constants);
// Writes the contents of an upload buffer and returns their size in bytes. destination must be as large as the resource.
uint64_t writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame,
                     const SamplePositions& positions, const CounterBuffer* newest, void* destination);

} // namespace agaa
