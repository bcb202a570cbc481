// The data of a frame in the layout that shaders read.
#pragma once

#include "core/frame/temporal.h"
#include "core/plan/gpu_layout.h"
#include "core/plan/plan.h"
#include "core/plan/sample_patterns.h"

#include <vector>

namespace agaa {

// positions   The plan's samples, as samplePositions() returns them.
// newest      Counters of the newest finished frame; null if there is none or the plan does not ask for them.
FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame, const SamplePositions& positions,
                              const CounterBuffer* newest = nullptr, const HistoryTurn& turn = {});
// Returns the values of `uniform vec4 agaa_constants[constantVectors]` (common/frame.glsl). Integers are floats. The
// dither frame and the capacity of fragment lists are two halves of 16 bits each.
uint32_t constantVectors(const Plan& plan);
std::vector<float> uniformConstants(const Plan& plan, const FrameConstants& constants);
// Writes the contents of an upload buffer and returns their size in bytes. destination must be as large as the
// resource. Each byte is written once and none is read, because the memory may be write-combined.
uint64_t writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame, const SamplePositions& positions,
                     const CounterBuffer* newest, const HistoryTurn& turn, void* destination);

} // namespace agaa
