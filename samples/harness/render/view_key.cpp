#include "render/view_key.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace harness {

namespace {

// Appends plain values: equal bytes mean equal views. Members are added one by one, because the padding of a struct is
// undefined.
class Key {
public:
    template <class Value> void add(const Value& value) {
        static_assert(std::is_arithmetic_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add(const char* text) { bytes_ += std::string(text ? text : "") + '\0'; }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

void addLayout(Key& key, const AgaaLayout& layout) {
    key.add(layout.attributeCount);
    for (uint32_t i = 0; i < std::min<uint32_t>(layout.attributeCount, AGAA_MAX_LAYOUT_ATTRIBUTES); ++i) {
        const AgaaLayoutAttribute& a = layout.attributes[i];
        for (const uint32_t value :
             {a.semantic, a.channels, a.sampleBits, a.aggregateBits, a.chromaBits, a.encoding, a.filter})
            key.add(value);
        key.add(a.range);
        key.add(a.name);
    }
}

void addFetchFunction(Key& key, const AgaaFetchFunction& function) {
    key.add(function.glsl);
    key.add(function.glslExtensions);
    key.add(function.maxDraws);
    key.add(function.maxPrimitives);
    key.add(function.maxTriangles);
    key.add(function.descriptorSetLayout);
    key.add(function.flags);
}

void addShadingFunction(Key& key, const AgaaShadingFunction& function) {
    key.add(function.glsl);
    key.add(function.glslExtensions);
    key.add(function.level);
    key.add(function.descriptorSetLayout);
}

void addShadowFunction(Key& key, const AgaaShadowFunction& function) {
    key.add(function.glsl);
    key.add(function.glslExtensions);
    key.add(function.shadows);
    key.add(function.footprints);
    key.add(function.descriptorSetLayout);
}

// Adds the chained functions. Returns false if the chain has another struct.
bool addFunctions(Key& key, const AgaaViewDesc& desc) {
    for (auto* next = static_cast<const AgaaStructHeader*>(desc.pNext); next;
         next = static_cast<const AgaaStructHeader*>(next->pNext)) {
        key.add(next->sType);
        if (next->sType == AGAA_STRUCTURE_TYPE_FETCH_FUNCTION)
            addFetchFunction(key, *reinterpret_cast<const AgaaFetchFunction*>(next));
        else if (next->sType == AGAA_STRUCTURE_TYPE_SHADING_FUNCTION)
            addShadingFunction(key, *reinterpret_cast<const AgaaShadingFunction*>(next));
        else if (next->sType == AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION)
            addShadowFunction(key, *reinterpret_cast<const AgaaShadowFunction*>(next));
        else
            return false;
    }
    return true;
}

// Returns the struct of this type in a chain, or the initial value if there is none.
template <class T> T chainedOr(const AgaaConfig& config, uint32_t sType, const T& initial) {
    for (auto* next = static_cast<const AgaaStructHeader*>(config.pNext); next;
         next = static_cast<const AgaaStructHeader*>(next->pNext))
        if (next->sType == sType)
            return *reinterpret_cast<const T*>(next);
    return initial;
}

// Returns whether the key covers all chained structs.
bool isKnown(const AgaaConfig& config) {
    for (auto* next = static_cast<const AgaaStructHeader*>(config.pNext); next;
         next = static_cast<const AgaaStructHeader*>(next->pNext))
        if (next->sType != AGAA_STRUCTURE_TYPE_AGGREGATION && next->sType != AGAA_STRUCTURE_TYPE_MEASUREMENT &&
            next->sType != AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE &&
            next->sType != AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING && next->sType != AGAA_STRUCTURE_TYPE_TEMPORAL)
            return false;
    return true;
}

} // namespace

std::string viewKey(const AgaaViewDesc& desc) {
    const AgaaConfig& config = *desc.config;
    Key key;
    if (!addFunctions(key, desc) || !isKnown(config) || desc.facts->pNext || (config.layout && config.layout->pNext))
        return {};
    const auto aggregation = chainedOr(config, AGAA_STRUCTURE_TYPE_AGGREGATION, AgaaAggregation AGAA_AGGREGATION_INIT);
    const auto coverage =
        chainedOr(config, AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE, AgaaDecoupledCoverage AGAA_DECOUPLED_COVERAGE_INIT);
    const auto adaptive =
        chainedOr(config, AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING, AgaaAdaptiveSampling AGAA_ADAPTIVE_SAMPLING_INIT);
    const auto temporal = chainedOr(config, AGAA_STRUCTURE_TYPE_TEMPORAL, AgaaTemporal AGAA_TEMPORAL_INIT);
    const auto measurement = chainedOr(config, AGAA_STRUCTURE_TYPE_MEASUREMENT, AgaaMeasurement AGAA_MEASUREMENT_INIT);
    key.add(desc.width);
    key.add(desc.height);
    key.add(desc.flags);
    key.add(config.technique);
    for (const uint32_t value : {config.samples, config.aggregates, config.brdf, config.ndf, measurement.seeds,
                                 measurement.lanes, config.shadowTaps, config.visibilityTier, config.generationTier,
                                 measurement.shadingCost, aggregation.litShadows, measurement.debugView,
                                 measurement.diffuseFilter, coverage.merge, coverage.maxBatches, coverage.tableSize})
        key.add(value);
    for (const float value :
         {aggregation.characteristicLength, aggregation.characteristicLengthPerDistance, aggregation.aggregateThreshold,
          config.surfaceCosine, config.surfaceDistance, config.surfaceMaterial, aggregation.glossWeight,
          coverage.fragmentsPerPixel, adaptive.depthScale, adaptive.normalScale, adaptive.shadingScale,
          adaptive.shadingThreshold, adaptive.shadingMinimum, adaptive.glossWeight, adaptive.targetEvents,
          adaptive.countMemory, temporal.currentShare, temporal.clipDeviations, temporal.depthTolerance})
        key.add(value);
    key.add(config.flags);
    key.add(measurement.flags);
    key.add(coverage.flags);
    key.add(adaptive.flags);
    key.add(temporal.flags);
    key.add(temporal.motion);
    key.add(uint32_t(coverage.samplePositions != nullptr));
    for (uint32_t i = 0; coverage.samplePositions && i < 2 * config.samples; ++i)
        key.add(coverage.samplePositions[i]);
    key.add(uint32_t(config.layout != nullptr));
    if (config.layout)
        addLayout(key, *config.layout);
    key.add(desc.facts->flags);
    key.add(desc.facts->maxLights);
    key.add(desc.facts->shadowMapCount);
    return key.take();
}

} // namespace harness
