// A host's description of a view after validation: complete, in range, without pointers to the host's memory. Planning
// reads this and checks only what depends on the device.
#pragma once

#include "agaa_sdk.h"
#include "core/view/layout.h"

#include <string>
#include <vector>

namespace agaa {

// GLSL of a host's function.
struct HostText {
    std::string glsl, extensions;
};

struct ViewSettings {
    std::string technique;
    uint32_t width = 0;
    uint32_t height = 0;
    bool reversedZ = false;
    bool composite = false; // over what the output holds
    bool clipZFromMinusOne = false;
    bool vertexPulling = false; // the host's vertex shaders expand triangles
    AgaaConfig config{}; // technique: static storage; layout: null
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaDecoupledCoverage coverage = AGAA_DECOUPLED_COVERAGE_INIT; // samplePositions: null
    std::vector<float> coveragePositions; // pairs, of the host's own pattern of coverage samples
    AgaaAdaptiveSampling adaptive = AGAA_ADAPTIVE_SAMPLING_INIT;
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
    AgaaSceneFacts facts{};        // that the host announced: of layouts, tiers, resources and draw passes
    AgaaSceneFacts variantFacts{}; // of the compute passes' constants and switches; within the facts
    Layout layout; // the host's; planning drops what the facts do not call for
    uint32_t samples = 1;    // no more than the technique takes
    uint32_t aggregates = 0; // 0 where nothing is aggregated

    uint32_t functionShadows = 0; // bit i: the host's function answers for shadow i
    HostText shadowFunction;
    bool hostGBuffer = false;     // the host draws it; a function of the host's reads its samples
    HostText gbufferFunction;
    std::vector<float> samplePositions; // n pairs, where the host says them
    uint32_t depthBits = 0;             // of fixed point; 0: float
    uint32_t maxDraws = 0, maxPrimitives = 0; // that ids tell apart; 0: nothing fetches materials by id
    uint32_t primitiveBits = 0;         // of an id, the low ones
    bool someUnfetched = false;         // draws that ids cannot name go into a G-buffer
    HostText fetchFunction;
    uint64_t functionSetLayout = 0;     // of set 1 in passes with code of the host's
};

// Changes n and c of a view: as many aggregates as its technique makes of so many samples.
void setCounts(ViewSettings& view, uint32_t samples, uint32_t aggregates);

// Types of the structs that may be chained to AgaaConfig.
std::vector<uint32_t> configChain();

// Throws Error where the description is not valid, whatever the device; the message says why. null is not valid.
ViewSettings resolveView(const AgaaViewDesc* desc);

} // namespace agaa
