// A configuration with the settings of techniques chained to it, which stay chained when it is copied.
#pragma once

#include "agaa_sdk.h"

namespace harness {

struct TechniqueConfig : AgaaConfig {
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;

    TechniqueConfig() : AgaaConfig AGAA_CONFIG_INIT { pNext = &aggregation; }
    TechniqueConfig(const TechniqueConfig& other) : AgaaConfig(other), aggregation(other.aggregation) {
        pNext = &aggregation;
    }
    TechniqueConfig& operator=(const TechniqueConfig& other) {
        AgaaConfig::operator=(other);
        aggregation = other.aggregation;
        pNext = &aggregation;
        return *this;
    }

    AgaaResult applyPreset(const char* name) { return agaaApplyPreset(name, this, &aggregation); }
};

} // namespace harness
