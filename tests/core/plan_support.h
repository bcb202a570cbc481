// Views for planner tests.
#pragma once

#include "core/base/error.h"
#include "core/plan/planner.h"
#include "core/view/technique.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

namespace agaa::test {

// A configuration with the settings of all techniques chained to it. The chain stays its own when it is copied.
struct TechniqueConfig : AgaaConfig {
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaDecoupledCoverage coverage = AGAA_DECOUPLED_COVERAGE_INIT;
    AgaaAdaptiveSampling adaptive = AGAA_ADAPTIVE_SAMPLING_INIT;
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;

    TechniqueConfig() : AgaaConfig AGAA_CONFIG_INIT { chain(); }
    TechniqueConfig(const TechniqueConfig& other)
        : AgaaConfig(other), aggregation(other.aggregation), coverage(other.coverage), adaptive(other.adaptive),
          measurement(other.measurement) {
        chain();
    }
    TechniqueConfig& operator=(const TechniqueConfig&) = delete;

    AgaaResult applyPreset(const char* name) { return agaaApplyPreset(name, this, &aggregation, &measurement); }

private:
    void chain() {
        aggregation.pNext = &coverage;
        coverage.pNext = &adaptive;
        adaptive.pNext = &measurement;
        pNext = &aggregation;
    }
};

struct ViewSpec {
    const char* technique = "agaa";
    uint32_t samples = 8;
    uint32_t aggregates = 2;
    const char* layout = "precise";
    uint32_t visibilityTier = AGAA_TIER_AUTO;
    uint32_t generationTier = AGAA_TIER_AUTO;
    uint32_t width = 640;
    uint32_t height = 360;
    uint64_t configFlags = 0;
    uint64_t facts = AGAA_FACT_ALL_SHADED;
    uint32_t shadowMaps = 1;
    uint32_t maxLights = 4; // so few are not culled
    uint64_t viewFlags = 0;
    const void* chained = nullptr; // to the view
    bool fetches = true;           // of techniques with coverage samples, where nothing else is chained
    std::function<void(TechniqueConfig&)> change = {}; // of what else there is
};

// A device with 1 and 4 samples, as Mesa's software rasterisers.
inline AgaaDeviceCaps fourSampleDevice() {
    AgaaDeviceCaps caps = idealDevice();
    caps.sampleCounts = 0b101;
    caps.maxImageSize = 16384;
    caps.maxStorageRange = UINT64_C(128) << 20;
    caps.flags &= ~AGAA_DEVICE_NV_MIXED_SAMPLES;
    return caps;
}

inline ViewSettings settingsFor(const ViewSpec& spec) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout(spec.layout, &layout);
    TechniqueConfig config;
    config.technique = spec.technique;
    config.samples = spec.samples;
    config.aggregates = spec.aggregates;
    config.layout = &layout;
    config.visibilityTier = spec.visibilityTier;
    config.generationTier = spec.generationTier;
    config.flags = spec.configFlags;
    if (spec.change)
        spec.change(config);
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = spec.facts;
    facts.shadowMapCount = spec.shadowMaps;
    facts.maxLights = spec.maxLights;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = spec.width;
    view.height = spec.height;
    view.config = &config;
    view.facts = &facts;
    view.flags = spec.viewFlags;
    view.pNext = spec.chained;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    // Of other numbers of samples.
    if (findTechnique(techniques(), spec.technique)->countsCoverage(config.generationTier, config.samples)) {
        config.samples = std::max(spec.samples, 32u);
        fetch.glsl = "";
        fetch.maxDraws = fetch.maxPrimitives = 1;
        view.pNext = spec.chained || !spec.fetches ? spec.chained : &fetch;
    }
    return resolveView(&view, techniques());
}

// Returns the bytes of lists with eight fragments for each pixel: counts, three words for each pixel, a word for each
// tile of 8 by 8 pixels, and the fragments.
inline uint64_t listBytes(const ViewSpec& spec, uint64_t bytesOfFragment) {
    const uint64_t tiles = uint64_t(spec.width + 7) / 8 * ((spec.height + 7) / 8);
    return 64 + 4 * tiles + (12 + 8 * bytesOfFragment) * spec.width * spec.height;
}

inline Plan planFor(const ViewSpec& spec, const AgaaDeviceCaps& caps) { return makePlan(settingsFor(spec), caps, 2); }

inline const Pass& passNamed(const Plan& plan, const char* name) {
    const auto found = std::ranges::find(plan.passes, name, &Pass::name);
    if (found == plan.passes.end())
        throw std::runtime_error(std::string("The plan has no pass \"") + name + "\".");
    return *found;
}

// Returns the sentence with which the view is refused as unsupported; empty if it has a plan.
inline std::string refusal(const ViewSpec& spec, const AgaaDeviceCaps& caps) {
    try {
        planFor(spec, caps);
    } catch (const Error& error) {
        return error.code == AGAA_ERROR_UNSUPPORTED ? error.message : "another error: " + error.message;
    }
    return "";
}

// Returns an ideal device without these features.
inline AgaaDeviceCaps without(uint64_t flags) {
    AgaaDeviceCaps caps = idealDevice();
    caps.flags &= ~flags;
    return caps;
}

} // namespace agaa::test
