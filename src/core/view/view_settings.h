// A host's description of a view after validation: complete, in range and without pointers to the host's memory.
// resolveForDevice() (resolved_view.h) checks what depends on the device.
#pragma once

#include "agaa_sdk.h"
#include "core/view/layout.h"
#include "core/view/resolved_outputs.h"
#include "core/view/technique.h"

#include <optional>
#include <string>
#include <vector>

namespace agaa {

// The GLSL text of a host's function.
struct HostText {
    std::string glsl, extensions;
};

struct ViewSettings {
    const Technique* technique = nullptr; // a row of the table; not null after resolveView()
    uint32_t width = 0;
    uint32_t height = 0;
    bool reversedZ = false;
    bool composite = false; // over the contents of the output
    bool clipZFromMinusOne = false;
    bool vertexPulling = false; // the host's vertex shaders expand triangles
    AgaaConfig config{};        // technique: static storage; layout: null
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaDecoupledCoverage coverage = AGAA_DECOUPLED_COVERAGE_INIT; // samplePositions: null
    std::vector<float> coveragePositions; // x and y of each, if the host sets the positions of coverage samples
    AgaaAdaptiveSampling adaptive = AGAA_ADAPTIVE_SAMPLING_INIT;
    AgaaTemporal temporal = AGAA_TEMPORAL_INIT; // motion: null
    std::string motionAttribute;                // AgaaTemporal::motion
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
    AgaaSceneFacts facts{};        // announced by the host; they determine layouts, tiers, resources and draw passes
    AgaaSceneFacts variantFacts{}; // within `facts`; they determine the constants and switches of compute passes
    Layout layout;                 // of the host; resolveForDevice() removes attributes that the facts do not need
    uint32_t samples = 1;          // at most Technique::maxSamples
    uint32_t aggregates = 0;       // 0: the technique has no aggregates

    uint32_t functionShadows = 0;  // bit i: the host's function looks up shadow i
    uint32_t footprintShadows = 0; // bits of functionShadows: over the footprint of each event
    HostText shadowFunction;
    std::optional<HostText> shadingFunction;
    bool hostShadesEvents = false; // agaaShade(), in place of agaaReflect()
    bool hostGBuffer = false;      // the host draws the G-buffer; gbufferFunction reads its samples
    HostText gbufferFunction;
    std::vector<float> samplePositions;       // x and y of each sample, if the host sets them
    uint32_t depthBits = 0;                   // of the host's fixed-point depth buffer; 0: it has floats
    uint32_t maxDraws = 0, maxPrimitives = 0; // that ids distinguish; 0: materials are not fetched by id
    uint32_t maxTriangles = 0;                // of a frame, that compute passes expand; 0: the host draws them
    uint32_t primitiveBits = 0;               // low bits of an id that number the primitive
    bool someUnfetched = false;               // draws that cannot be fetched go into a G-buffer
    HostText fetchFunction;
    std::vector<ResolvedOutput> resolvedOutputs;
    uint64_t functionSetLayout = 0; // of set 1 in passes with GLSL of the host
};

// Changes n and c of a view. A technique without aggregates has none, and no view has more aggregates than samples.
void setCounts(ViewSettings& view, uint32_t samples, uint32_t aggregates);
// Changes n to a value that the technique of the settings accepts. Throws AGAA_ERROR_UNSUPPORTED if positions of
// samples are those of another n.
void changeSamples(ViewSettings& view, uint32_t samples);

// Returns the types of the structs that may be chained to AgaaConfig.
std::vector<uint32_t> configChain(TechniqueTable table);

// Returns the checked description. Throws Error if it is null or not valid on any device; the message says why.
ViewSettings resolveView(const AgaaViewDesc* desc, TechniqueTable table);

} // namespace agaa
