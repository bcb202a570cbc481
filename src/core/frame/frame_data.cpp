#include "core/frame/frame_data.h"

#include "core/frame/frame_checks.h"
#include "core/view/facts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace agaa {

static_assert(AGAA_FACT_SPECULAR == 1 && AGAA_FACT_EMISSIVE == 2 && AGAA_FACT_AMBIENT == 8, "bits of common/frame.glsl");

constexpr uint32_t firstLocation = offsetof(FrameConstants, samples) / 16; // vector

FrameConstants frameConstants(const Plan& plan, const AgaaFrame& frame,
                              const SamplePositions& positions, const CounterBuffer* newest) {
    FrameConstants out{};
    std::memcpy(out.view, frame.view, sizeof out.view);
    const float* p = frame.projection;
    // One step of the stored depth: of the whole range for fixed point, of the depth itself (told by
    // the sign) for float.
    const float quantum = plan.depthBits ? std::ldexp(1.0f, -int(plan.depthBits)) : -std::ldexp(1.0f, -24);
    const bool orthographic = p[15] == 1.0f;
    const float* offset = orthographic ? &p[12] : &p[8];
    // Depth is z/w as [0;1] takes it, or (z/w + 1) / 2.
    const float half = plan.clipZFromMinusOne ? 0.5f : 1.0f;
    const float shift = plan.clipZFromMinusOne ? 0.5f : 0.0f;
    const float projection[8] = {p[0],
                                 p[5],
                                 offset[0],
                                 offset[1],
                                 half * p[10] + shift * p[11],
                                 half * p[14] + shift * p[15],
                                 orthographic ? 1.0f : 0.0f,
                                 quantum};
    std::memcpy(out.projection, projection, sizeof projection);
    out.size[0] = plan.width;
    out.size[1] = plan.height;
    if (frame.facts)
        out.size[2] = uint32_t(leftOut(*frame.facts, plan.facts));
    out.size[3] = frame.background[3] == 0.0f;
    out.cluster[0] = plan.aggregation.characteristicLength;
    out.cluster[1] = plan.aggregation.characteristicLengthPerDistance;
    out.cluster[2] = plan.aggregation.aggregateThreshold;
    std::memcpy(out.ambient, frame.ambient, sizeof frame.ambient);
    out.ambient[3] = plan.layout.emissiveRange();
    std::memcpy(out.background, frame.background, sizeof frame.background);
    out.surface[0] = plan.config.surfaceCosine;
    out.surface[1] = plan.config.surfaceDistance;
    out.surface[2] = plan.config.surfaceMaterial;
    out.surface[3] = float(plan.samples);
    out.ditherFrame = frame.ditherFrame;
    for (size_t i = 0; newest && i < plan.feedback.size(); ++i)
        if (plan.feedback[i] != noCounter)
            out.feedback[i] = newest->counts[plan.feedback[i]][0];
    static_assert(sizeof out.samples == sizeof(SamplePositions));
    std::memcpy(out.samples, positions.data(), sizeof out.samples);
    out.counts[0] = plan.aggregates;
    out.counts[1] = uint32_t(plan.fragmentCapacity);
    out.counts[2] = plan.coverage.maxBatches;
    return out;
}

uint32_t constantVectors(const Plan& plan) { return firstLocation + (plan.samples + 1) / 2; }

std::vector<float> uniformConstants(const Plan& plan, const FrameConstants& constants) {
    std::vector<float> out(size_t(4) * constantVectors(plan));
    std::memcpy(out.data(), &constants, out.size() * sizeof(float));
    std::copy_n(constants.size, 4, &out[4 * 6]);
    out[4 * 11] = float(constants.ditherFrame & 0xFFFF);
    out[4 * 11 + 1] = float(constants.ditherFrame >> 16);
    out[4 * 11 + 2] = float(plan.fragmentCapacity & 0xFFFF);
    out[4 * 11 + 3] = float(plan.fragmentCapacity >> 16);
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
            shadow.layerCount = std::max(source.layerCount, 1u); // a function of the host's has none
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

uint64_t writeUpload(const Plan& plan, UploadContent content, const AgaaFrame& frame,
                     const SamplePositions& positions, const CounterBuffer* newest, void* destination) {
    switch (content) {
    case UploadContent::None:
        break;
    case UploadContent::FrameConstants: {
        const FrameConstants constants = frameConstants(plan, frame, positions, newest);
        std::memcpy(destination, &constants, sizeof constants);
        return sizeof constants;
    }
    case UploadContent::Lights:
        return writeLights(frame, destination);
    }
    return 0;
}

} // namespace agaa
