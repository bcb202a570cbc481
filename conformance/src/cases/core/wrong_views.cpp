#include "wrong_views.h"

#include "structs.h"

#include <cmath>

namespace agaa::conformance {

namespace {

const AgaaStructHeader unknownStruct = {farStructType, sizeof(AgaaStructHeader), nullptr};

using Rows = std::vector<WrongView>;

void addNulls(Rows& rows) {
    rows.push_back(
        {"a null description", AGAA_ERROR_INVALID_ARGUMENT, "AgaaViewDesc", [](ViewParts& p) { p.isNull = true; }});
    rows.push_back({"AgaaViewDesc::config = null", AGAA_ERROR_INVALID_ARGUMENT, "AgaaConfig",
                    [](ViewParts& p) { p.desc.config = nullptr; }});
    rows.push_back({"AgaaViewDesc::facts = null", AGAA_ERROR_INVALID_ARGUMENT, "AgaaSceneFacts",
                    [](ViewParts& p) { p.desc.facts = nullptr; }});
    rows.push_back({"AgaaConfig::technique = null", AGAA_ERROR_INVALID_ARGUMENT, "technique",
                    [](ViewParts& p) { p.config.technique = nullptr; }});
    rows.push_back({"AgaaGBufferFunction::glsl = null", AGAA_ERROR_INVALID_ARGUMENT, "glsl", [](ViewParts& p) {
                        p.chain(p.gbuffer);
                        p.gbuffer.glsl = nullptr;
                    }});
    rows.push_back({"AgaaFetchFunction::glsl = null", AGAA_ERROR_INVALID_ARGUMENT, "glsl", [](ViewParts& p) {
                        p.chain(p.fetch);
                        p.fetch.glsl = nullptr;
                    }});
    rows.push_back({"AgaaShadowFunction::glsl = null", AGAA_ERROR_INVALID_ARGUMENT, "glsl", [](ViewParts& p) {
                        p.facts.shadowMapCount = 1;
                        p.chain(p.shadow);
                        p.shadow.glsl = nullptr;
                    }});
    rows.push_back(
        {"AgaaResolvedOutput::attribute = null for CUSTOM", AGAA_ERROR_INVALID_ARGUMENT, "attribute", [](ViewParts& p) {
             p.chain(p.outputs);
             p.outputs.outputs[0].value = AGAA_RESOLVED_CUSTOM;
         }});
    rows.push_back(
        {"AgaaResolvedOutput::attribute for NORMAL", AGAA_ERROR_INVALID_ARGUMENT, "attribute", [](ViewParts& p) {
             p.chain(p.outputs);
             p.outputs.outputs[0] = {AGAA_RESOLVED_NORMAL, 0, "velocity"};
         }});
    rows.push_back(
        {"AgaaResolvedOutput::attribute that the layout lacks", AGAA_ERROR_LAYOUT, "velocity", [](ViewParts& p) {
             p.chain(p.outputs);
             p.outputs.outputs[0] = {AGAA_RESOLVED_CUSTOM, 0, "velocity"};
         }});
    rows.push_back({"AgaaShadingFunction::glsl = null", AGAA_ERROR_INVALID_ARGUMENT, "glsl", [](ViewParts& p) {
                        p.chain(p.shading);
                        p.shading.glsl = nullptr;
                    }});
}

void addStructs(Rows& rows) {
    rows.push_back(
        {"AgaaViewDesc::sType = 0", AGAA_ERROR_STRUCT, "AgaaViewDesc", [](ViewParts& p) { p.desc.sType = 0; }});
    rows.push_back({"AgaaViewDesc::structSize = 0", AGAA_ERROR_STRUCT, "AgaaViewDesc",
                    [](ViewParts& p) { p.desc.structSize = 0; }});
    rows.push_back(
        {"AgaaConfig::sType = 0", AGAA_ERROR_STRUCT, "AgaaConfig", [](ViewParts& p) { p.config.sType = 0; }});
    rows.push_back({"AgaaSceneFacts::structSize = 4", AGAA_ERROR_STRUCT, "AgaaSceneFacts",
                    [](ViewParts& p) { p.facts.structSize = 4; }});
    rows.push_back({"AgaaAggregation::structSize = 8", AGAA_ERROR_STRUCT, "AgaaAggregation",
                    [](ViewParts& p) { p.aggregation.structSize = 8; }});
    rows.push_back({"AgaaDecoupledCoverage::structSize = 8", AGAA_ERROR_STRUCT, "AgaaDecoupledCoverage",
                    [](ViewParts& p) { p.coverage.structSize = 8; }});
    rows.push_back({"AgaaAdaptiveSampling::structSize = 8", AGAA_ERROR_STRUCT, "AgaaAdaptiveSampling",
                    [](ViewParts& p) { p.adaptive.structSize = 8; }});
    rows.push_back({"AgaaMeasurement::structSize = 8", AGAA_ERROR_STRUCT, "AgaaMeasurement",
                    [](ViewParts& p) { p.measurement.structSize = 8; }});
    rows.push_back({"AgaaLayout::sType = 0", AGAA_ERROR_STRUCT, "AgaaLayout", [](ViewParts& p) {
                        p.useLayout();
                        p.layout.sType = 0;
                    }});
    const std::string type = std::to_string(farStructType);
    rows.push_back({"an unknown struct chained to AgaaViewDesc", AGAA_ERROR_UNKNOWN_STRUCT, type,
                    [](ViewParts& p) { p.desc.pNext = &unknownStruct; }});
    rows.push_back({"an unknown struct chained to AgaaConfig", AGAA_ERROR_UNKNOWN_STRUCT, type,
                    [](ViewParts& p) { p.measurement.pNext = &unknownStruct; }});
    rows.push_back({"an unknown struct chained to AgaaSceneFacts", AGAA_ERROR_UNKNOWN_STRUCT, type,
                    [](ViewParts& p) { p.facts.pNext = &unknownStruct; }});
    rows.push_back({"AgaaAggregation chained to AgaaViewDesc", AGAA_ERROR_UNKNOWN_STRUCT,
                    std::to_string(AGAA_STRUCTURE_TYPE_AGGREGATION), [](ViewParts& p) { p.desc.pNext = &p.spare; }});
    rows.push_back({"AgaaAggregation chained twice", AGAA_ERROR_UNKNOWN_STRUCT,
                    std::to_string(AGAA_STRUCTURE_TYPE_AGGREGATION),
                    [](ViewParts& p) { p.measurement.pNext = &p.spare; }});
    rows.push_back({"a chain that closes on itself", AGAA_ERROR_UNKNOWN_STRUCT, "",
                    [](ViewParts& p) { p.measurement.pNext = &p.aggregation; }});
}

void addRanges(Rows& rows) {
    const auto add = [&](const char* what, const char* words, std::function<void(ViewParts&)> corrupt) {
        rows.push_back({what, AGAA_ERROR_OUT_OF_RANGE, words, std::move(corrupt)});
    };
    add("AgaaViewDesc::width = 0", "width", [](ViewParts& p) { p.desc.width = 0; });
    add("AgaaViewDesc::height = 0", "height", [](ViewParts& p) { p.desc.height = 0; });
    add("AgaaViewDesc::flags = 1 << 63", "flags", [](ViewParts& p) { p.desc.flags = UINT64_C(1) << 63; });
    add("AgaaConfig::samples = 3", "samples", [](ViewParts& p) { p.config.samples = 3; });
    add("AgaaConfig::aggregates = 5", "aggregates", [](ViewParts& p) { p.config.aggregates = 5; });
    add("AgaaConfig::brdf = 0x7FFFFFFF", "brdf", [](ViewParts& p) { p.config.brdf = 0x7FFFFFFF; });
    add("AgaaConfig::ndf = 0x7FFFFFFF", "ndf", [](ViewParts& p) { p.config.ndf = 0x7FFFFFFF; });
    add("AgaaConfig::surfaceCosine = NaN", "surfaceCosine", [](ViewParts& p) { p.config.surfaceCosine = NAN; });
    add("AgaaConfig::flags = 1 << 63", "flags", [](ViewParts& p) { p.config.flags = UINT64_C(1) << 63; });
    add("AgaaAggregation::characteristicLength = infinity", "characteristicLength",
        [](ViewParts& p) { p.aggregation.characteristicLength = INFINITY; });
    add("AgaaAggregation::reserved = 0x7FFFFFFF", "reserved",
        [](ViewParts& p) { p.aggregation.reserved = 0x7FFFFFFF; });
    add("\"dcaa\" and AgaaConfig::samples = 4", "samples", [](ViewParts& p) {
        p.setTechnique("dcaa", 4);
        p.config.samples = 4;
    });
    add("AgaaDecoupledCoverage::merge = 0x7FFFFFFF", "merge", [](ViewParts& p) { p.coverage.merge = 0x7FFFFFFF; });
    add("AgaaDecoupledCoverage::maxBatches = 65", "maxBatches", [](ViewParts& p) { p.coverage.maxBatches = 65; });
    add("AgaaAdaptiveSampling::shadingScale = NaN", "shadingScale",
        [](ViewParts& p) { p.adaptive.shadingScale = NAN; });
    add("\"ssaa\" and AgaaMeasurement::seeds = 0x7FFFFFFF", "seeds", [](ViewParts& p) {
        p.config.technique = "ssaa";
        p.measurement.seeds = 0x7FFFFFFF;
    });
    add("AgaaMeasurement::shadingCost = 0", "shadingCost", [](ViewParts& p) { p.measurement.shadingCost = 0; });
    add("AgaaSceneFacts::maxLights = 4097", "maxLights", [](ViewParts& p) { p.facts.maxLights = 4097; });
    add("AgaaSceneFacts::shadowMapCount = 5", "shadowMapCount", [](ViewParts& p) { p.facts.shadowMapCount = 5; });
    add("AgaaSceneFacts::flags = 1 << 63", "flags", [](ViewParts& p) { p.facts.flags = UINT64_C(1) << 63; });
    add("AgaaGBufferFunction::depthBits = 8", "depthBits", [](ViewParts& p) {
        p.chain(p.gbuffer);
        p.gbuffer.depthBits = 8;
    });
    add("AgaaFetchFunction::maxDraws = 0", "maxDraws", [](ViewParts& p) {
        p.chain(p.fetch);
        p.fetch.maxDraws = 0;
    });
    add("AgaaShadowFunction::footprints = 2", "footprints", [](ViewParts& p) {
        p.facts.shadowMapCount = 2;
        p.chain(p.shadow);
        p.shadow.footprints = 2;
    });
    add("AgaaShadingFunction::level = 2", "level", [](ViewParts& p) {
        p.chain(p.shading);
        p.shading.level = 2;
    });
}

void removeAttribute(ViewParts& p, uint32_t semantic) {
    AgaaLayoutAttribute* const begin = p.layout.attributes;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < p.layout.attributeCount; ++i)
        if (begin[i].semantic != semantic)
            begin[kept++] = begin[i];
    p.layout.attributeCount = kept;
    p.useLayout();
}

void addCustom(ViewParts& p, const char* name, uint32_t bits) {
    AgaaLayoutAttribute& a = p.layout.attributes[p.layout.attributeCount++];
    const AgaaLayoutAttribute initial = AGAA_LAYOUT_ATTRIBUTE_INIT;
    a = initial;
    a.semantic = AGAA_SEMANTIC_CUSTOM;
    a.channels = 4;
    a.sampleBits = bits;
    a.name = name;
    p.useLayout();
}

// Attributes that are valid, but exclude each other.
void addLayouts(Rows& rows) {
    const auto add = [&](const char* what, const char* words, std::function<void(ViewParts&)> corrupt) {
        rows.push_back({what, AGAA_ERROR_LAYOUT, words, std::move(corrupt)});
    };
    add("a layout without DIFFUSE", "diffuse", [](ViewParts& p) { removeAttribute(p, AGAA_SEMANTIC_DIFFUSE); });
    add("a layout without NORMAL", "normal", [](ViewParts& p) { removeAttribute(p, AGAA_SEMANTIC_NORMAL); });
    add("a layout with SPECULAR and without ROUGHNESS", "roughness",
        [](ViewParts& p) { removeAttribute(p, AGAA_SEMANTIC_ROUGHNESS); });
    add("a layout with NORMAL twice", "normal", [](ViewParts& p) {
        p.layout.attributes[1] = p.layout.attributes[2];
        p.useLayout();
    });
    add("a layout that needs more than four attachments", "attachments", [](ViewParts& p) {
        addCustom(p, "first", 16);
        addCustom(p, "second", 8);
    });
    add("a layout with 12 custom channels", "channels", [](ViewParts& p) {
        for (const char* name : {"first", "second", "third"})
            addCustom(p, name, 8);
    });
}

void addOthers(Rows& rows) {
    rows.push_back({"AgaaConfig::technique = \"mlaa\"", AGAA_ERROR_UNSUPPORTED, "mlaa",
                    [](ViewParts& p) { p.config.technique = "mlaa"; }});
    rows.push_back(
        {"AgaaConfig::technique = \"\"", AGAA_ERROR_UNSUPPORTED, "", [](ViewParts& p) { p.config.technique = ""; }});
    rows.push_back(
        {"AgaaConfig::visibilityTier = AGAA_TIER_LAYERS and n = 1", AGAA_ERROR_UNSUPPORTED, "layers", [](ViewParts& p) {
             p.config.samples = 1;
             p.config.visibilityTier = AGAA_TIER_LAYERS;
         }});
    rows.push_back(
        {"\"msaa\" and AGAA_FACT_CUSTOM_DEPTH", AGAA_ERROR_UNSUPPORTED, "AGAA_FACT_CUSTOM_DEPTH", [](ViewParts& p) {
             p.config.technique = "msaa";
             p.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
         }});
    rows.push_back(
        {"\"msaa\" and an AgaaGBufferFunction", AGAA_ERROR_UNSUPPORTED, "AgaaGBufferFunction", [](ViewParts& p) {
             p.config.technique = "msaa";
             p.chain(p.gbuffer);
         }});
    rows.push_back({"the tier FRAGMENT_LISTS without an AgaaFetchFunction", AGAA_ERROR_UNSUPPORTED, "AgaaFetchFunction",
                    [](ViewParts& p) {
                        p.setTechnique("dcaa", 4);
                        p.config.generationTier = AGAA_TIER_FRAGMENT_LISTS;
                        p.desc.pNext = nullptr;
                    }});
    rows.push_back({"\"ssaa\" and AGAA_DEBUG_VIEW_CLUSTERS", AGAA_ERROR_UNSUPPORTED, "debugView", [](ViewParts& p) {
                        p.config.technique = "ssaa";
                        p.measurement.debugView = AGAA_DEBUG_VIEW_CLUSTERS;
                    }});
    rows.push_back({"AgaaViewDesc::width = 0xFFFFFFFF", AGAA_ERROR_TOO_LARGE, "",
                    [](ViewParts& p) { p.desc.width = 0xFFFFFFFF; }});
    rows.push_back({"\"single\", an AgaaGBufferFunction and AgaaViewDesc::width = 0xFFFFFFFF", AGAA_ERROR_TOO_LARGE, "",
                    [](ViewParts& p) {
                        p.config.technique = "single";
                        p.chain(p.gbuffer);
                        p.desc.width = 0xFFFFFFFF;
                    }});
    rows.push_back({"AgaaViewDesc::height = 0xFFFFFFFF", AGAA_ERROR_TOO_LARGE, "",
                    [](ViewParts& p) { p.desc.height = 0xFFFFFFFF; }});
    rows.push_back({"AgaaViewDesc::width and height = 0xFFFFFFFF", AGAA_ERROR_TOO_LARGE, "",
                    [](ViewParts& p) { p.desc.width = p.desc.height = 0xFFFFFFFF; }});
    rows.push_back({"2^32 primitives", AGAA_ERROR_TOO_LARGE, "", [](ViewParts& p) {
                        p.chain(p.fetch);
                        p.fetch.maxDraws = p.fetch.maxPrimitives = 0x10000;
                    }});
}

} // namespace

const std::vector<WrongView>& wrongViews() {
    static const Rows rows = [] {
        Rows all;
        addNulls(all);
        addStructs(all);
        addRanges(all);
        addLayouts(all);
        addOthers(all);
        return all;
    }();
    return rows;
}

void testWrongViews(Test& test, const Device* device, const std::string& function,
                    const std::function<AgaaResult(const ViewParts&, LogRecorder&)>& create, AgaaResult only) {
    for (const WrongView& row : wrongViews()) {
        if (only != AGAA_OK && row.expected != only)
            continue;
        ViewParts parts(test.sdk, device);
        row.corrupt(parts);
        LogRecorder log;
        const AgaaResult result = create(parts, log);
        expectRefused(test, result, row.expected, log, function, callWith(function, row.what), row.words);
    }
}

} // namespace agaa::conformance
