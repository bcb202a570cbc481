// A configuration with the chained settings of techniques. Copies keep the chain.
#pragma once

#include "agaa_sdk.h"

#include <string_view>

namespace harness {

struct TechniqueConfig : AgaaConfig {
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaDecoupledCoverage coverage = AGAA_DECOUPLED_COVERAGE_INIT;
    AgaaAdaptiveSampling adaptive = AGAA_ADAPTIVE_SAMPLING_INIT;
    AgaaTemporal temporal = AGAA_TEMPORAL_INIT;
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;

    TechniqueConfig() : AgaaConfig AGAA_CONFIG_INIT { chain(); }
    TechniqueConfig(const TechniqueConfig& other)
        : AgaaConfig(other), aggregation(other.aggregation), coverage(other.coverage), adaptive(other.adaptive),
          temporal(other.temporal), measurement(other.measurement) {
        chain();
    }
    TechniqueConfig& operator=(const TechniqueConfig& other) {
        AgaaConfig::operator=(other);
        aggregation = other.aggregation;
        coverage = other.coverage;
        adaptive = other.adaptive;
        temporal = other.temporal;
        measurement = other.measurement;
        chain();
        return *this;
    }

    // Returns whether views accumulate frames.
    bool accumulates() const { return std::string_view(technique) == "taa" || flags & AGAA_CONFIG_ACCUMULATE; }
    // Returns whether n counts coverage samples.
    bool coversByEdges() const {
        const std::string_view name = technique;
        return name == "dcaa" || name == "sgbc" ||
               (name == "agaa" && (generationTier == AGAA_TIER_FRAGMENTS || samples > 32));
    }
    // Returns whether views keep fragments in lists.
    bool keepsLists() const {
        return coversByEdges() && generationTier != AGAA_TIER_FRAGMENT_INTERLOCK &&
               generationTier != AGAA_TIER_RASTER_ORDER;
    }
    // Returns whether views need an AgaaFetchFunction, or AUTO prefers one.
    bool fetches() const {
        return generationTier == AGAA_TIER_IDS || generationTier == AGAA_TIER_FRAGMENT_LISTS ||
               generationTier == AGAA_TIER_FRAGMENTS || (generationTier == AGAA_TIER_AUTO && coversByEdges());
    }
    AgaaResult applyPreset(const char* name) { return agaaApplyPreset(name, this, &aggregation, &measurement); }

private:
    void chain() {
        aggregation.pNext = &coverage;
        coverage.pNext = &adaptive;
        adaptive.pNext = &temporal;
        temporal.pNext = &measurement;
        pNext = &aggregation;
    }
};

} // namespace harness
