#include "core/frame/frame_data.h"

#include "core/frame/frame_checks.h"
#include "core/view/facts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <tuple>

namespace agaa {

constexpr uint32_t firstLocation = offsetof(FrameConstants, sampleLocations) / 16; // vector

FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame, const SamplePositions& positions,
                              const CounterBuffer* newest, const HistoryTurn& turn) {
    FrameConstants out{};
    std::memcpy(out.view, frame.view, sizeof out.view);
    const float* p = frame.projection;
    const bool orthographic = p[15] == 1.0f;
    const float* offset = orthographic ? &p[12] : &p[8];
    // Depth is z / w or, where clip z begins at -1, (z / w + 1) / 2.
    const float half = plan.view.clipZFromMinusOne ? 0.5f : 1.0f;
    const float shift = plan.view.clipZFromMinusOne ? 0.5f : 0.0f;
    out.projectionScale[0] = p[0];
    out.projectionScale[1] = p[5];
    std::copy_n(offset, 2, out.projectionOffset);
    out.projection22 = half * p[10] + shift * p[11];
    out.projection32 = half * p[14] + shift * p[15];
    out.isOrthographic = orthographic;
    // Fixed point has equal steps. Steps of float are relative to the depth.
    out.depthQuantum = plan.depthBits() ? std::ldexp(1.0f, -int(plan.depthBits())) : -std::ldexp(1.0f, -24);
    const FrameExtent extent = extentOf(frame, plan);
    out.size[0] = extent.width;
    out.size[1] = extent.height;
    out.outputPlace[0] = frame.outputX;
    out.outputPlace[1] = frame.outputY;
    if (frame.facts)
        out.absentEffects = uint32_t(leftOut(*frame.facts, plan.view.facts));
    out.compositesOutput = frame.background[3] == 0.0f;
    out.characteristicLength = plan.view.aggregation.characteristicLength;
    out.characteristicLengthPerDistance = plan.view.aggregation.characteristicLengthPerDistance;
    out.aggregateThreshold = plan.view.aggregation.aggregateThreshold;
    std::memcpy(out.ambient, frame.ambient, sizeof frame.ambient);
    out.emissiveRange = plan.view.layout.emissiveRange();
    std::memcpy(out.background, frame.background, sizeof frame.background);
    out.surfaceCosine = plan.view.config.surfaceCosine;
    out.surfaceDistance = plan.view.config.surfaceDistance;
    out.surfaceMaterial = plan.view.config.surfaceMaterial;
    out.sampleCount = plan.view.samples;
    out.ditherFrame = frame.ditherFrame;
    constexpr uint32_t FrameConstants::*feedback[] = {&FrameConstants::feedback0, &FrameConstants::feedback1,
                                                      &FrameConstants::feedback2};
    static_assert(std::size(feedback) == std::tuple_size_v<decltype(plan.feedback)>);
    for (size_t i = 0; newest && i < plan.feedback.size(); ++i)
        if (plan.feedback[i] != noCounter)
            out.*feedback[i] = newest->counts[plan.feedback[i]][0];
    static_assert(sizeof out.sampleLocations == sizeof(SamplePositions));
    std::memcpy(out.sampleLocations, positions.data(), sizeof out.sampleLocations);
    out.aggregates = plan.view.aggregates;
    out.fragmentCapacity = uint32_t(plan.fragmentCapacity);
    out.maxBatches = plan.view.coverage.maxBatches;
    out.exposure = frame.exposure;
    if (plan.view.accumulates() && frame.segments & AGAA_SEGMENT_SHADING)
        writeTemporal(frame, turn, out);
    return out;
}

uint32_t constantVectors(const Plan& plan) { return firstLocation + (plan.view.samples + 1) / 2; }

// Writes a member as floats.
static void writeFloats(float* out, float value) { *out = value; }
static void writeFloats(float* out, uint32_t value) { *out = float(value); }
template <typename Value, size_t count> static void writeFloats(float* out, const Value (&values)[count]) {
    std::copy_n(values, count, out);
}

std::vector<float> uniformConstants(const Plan& plan, const FrameConstants& constants) {
    std::vector<float> out(size_t(4) * constantVectors(plan));
#define AGAA_FRAME_MEMBER(word, type, name) writeFloats(&out[word], constants.name);
#include "shaders/tables/frame.inc"
    const size_t locations = size_t(4) * firstLocation;
    std::memcpy(&out[locations], constants.sampleLocations, (out.size() - locations) * sizeof(float));
    // A float does not hold all 32-bit integers, so these are in halves.
    const uint32_t ditherFrame = constants.ditherFrame & 0xFFFF;
    const uint32_t ditherFrameHigh = constants.ditherFrame >> 16;
    const auto fragmentCapacityLow = uint32_t(plan.fragmentCapacity & 0xFFFF);
    const auto fragmentCapacityHigh = uint32_t(plan.fragmentCapacity >> 16);
    writeFloats(&out[offsetof(FrameConstants, ditherFrame) / sizeof(float)], ditherFrame);
#define AGAA_FRAME_UNIFORM_MEMBER(word, type, name) writeFloats(&out[word], name);
#include "shaders/tables/frame.inc"
    return out;
}

static uint64_t writeLights(const AgaaFrame& frame, void* destination) {
    auto* shadows = static_cast<GpuShadow*>(destination);
    for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i) {
        GpuShadow shadow{};
        if (i < frame.shadowCount) {
            const AgaaShadow source = shadowOf(frame, i);
            std::memcpy(shadow.matrices, source.matrices, sizeof shadow.matrices);
            shadow.bias = source.depthBias;
            shadow.layerCount = std::max(source.layerCount, 1u); // shadows of a host function have 0 layers
        }
        shadow.lightCount = i == 0 ? frame.lightCount : 0;
        std::memcpy(&shadows[i], &shadow, sizeof shadow);
    }
    auto* lights = reinterpret_cast<GpuLight*>(shadows + AGAA_MAX_SHADOW_MAPS);
    for (uint32_t i = 0; i < frame.lightCount; ++i) {
        const AgaaLight source = lightOf(frame, i);
        GpuLight light{};
        std::memcpy(light.position, source.position, sizeof light.position);
        light.range = source.range;
        std::memcpy(light.direction, source.direction, sizeof light.direction);
        light.type = source.type;
        std::memcpy(light.color, source.color, sizeof light.color);
        light.shadowMap = source.shadowMap;
        light.cosInner = source.cosInner;
        light.cosOuter = source.cosOuter;
        light.radius = source.radius;
        std::memcpy(&lights[i], &light, sizeof light);
    }
    return AGAA_MAX_SHADOW_MAPS * sizeof(GpuShadow) + frame.lightCount * sizeof(GpuLight);
}

uint64_t writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame, const SamplePositions& positions,
                     const CounterBuffer* newest, const HistoryTurn& turn, void* destination) {
    switch (content) {
    case UploadContent::None:
        break;
    case UploadContent::FrameConstants: {
        const FrameConstants constants = frameConstants(plan, frame, positions, newest, turn);
        std::memcpy(destination, &constants, sizeof constants);
        return sizeof constants;
    }
    case UploadContent::Lights:
        return writeLights(frame, destination);
    }
    return 0;
}

} // namespace agaa
