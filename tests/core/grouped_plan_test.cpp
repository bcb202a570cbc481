// Plans that know materials when they group samples: by id, from a G-buffer; presets.
#include "plan_support.h"

#include "core/glsl/compile_glsl.h"
#include "core/base/error.h"
#include "core/glsl/glsl_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace agaa::test {
namespace {

AgaaFetchFunction fetchFunction(uint64_t flags = 0) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "void agaaHostTriangle";
    function.maxDraws = function.maxPrimitives = 100;
    function.flags = flags;
    return function;
}

bool has(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

bool hasResource(const Plan& plan, const std::string& name) {
    return std::any_of(plan.resources.begin(), plan.resources.end(), [&](const Resource& r) { return r.name == name; });
}

TEST(GroupedPlan, AggregatesAreInMemoryOnlyWhereAsked) {
    const AgaaFetchFunction function = fetchFunction();
    for (const void* chained : {static_cast<const void*>(&function), static_cast<const void*>(nullptr)})
        for (uint64_t flag : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            ViewSpec spec;
            spec.generationTier = chained ? AGAA_TIER_IDS : AGAA_TIER_GBUFFER;
            spec.chained = chained;
            spec.configFlags = flag;
            const Plan plan = planFor(spec, fourSampleDevice());
            EXPECT_EQ(plan.geometryPasses(), 1u);
            EXPECT_EQ(hasResource(plan, "aggregates"), flag != 0);
            EXPECT_EQ(plan.bytesPerAggregate > 0, flag != 0);
        }
}

TEST(GroupedPlan, DrawsThatCannotBeFetchedAddAGBuffer) {
    const AgaaFetchFunction all = fetchFunction(), some = fetchFunction(AGAA_FETCH_NOT_ALL_DRAWS);
    ViewSpec spec;
    spec.chained = &all;
    const Plan fetched = planFor(spec, fourSampleDevice());
    EXPECT_EQ(fetched.geometryPasses(), 1u);
    EXPECT_FALSE(hasResource(fetched, "gbuffer-0"));
    EXPECT_EQ(fetched.totalBytes(), uint64_t(640 * 360) * 8 * 8 + 640 * 360 / 8)
        << "8 bytes a sample and a bit a pixel, nothing per aggregate";
    spec.chained = &some;
    const Plan mixed = planFor(spec, fourSampleDevice());
    EXPECT_EQ(mixed.geometryPasses(), 2u);
    EXPECT_TRUE(hasResource(mixed, "gbuffer-0"));
    EXPECT_TRUE(has(mixed.notes, "cannot be fetched"));
    const Pass& over = mixed.passes[1];
    EXPECT_EQ(over.draw().id, AGAA_DRAW_PASS_GBUFFER);
    EXPECT_EQ(over.draw().state.depthCompare, uint32_t(AGAA_COMPARE_EQUAL));
    EXPECT_EQ(over.draw().state.depthWrite, 0u);
    EXPECT_FALSE(over.draw().clearsDepth);
    EXPECT_EQ(over.draw().depthTarget, mixed.passes[0].draw().depthTarget);
}

TEST(GroupedPlan, MaterialsAreWantedWhereShadowsAreLit) {
    ViewSpec spec;
    spec.change = [](TechniqueConfig& config) { config.aggregation.litShadows = 1; };
    const Plan lit = planFor(spec, fourSampleDevice());
    EXPECT_EQ(lit.view.generationTier, AGAA_TIER_GBUFFER);
    EXPECT_TRUE(has(lit.notes, "lit shadows"));
    EXPECT_TRUE(has(lit.effects, "lit-aggregates"));
    EXPECT_TRUE(has(lit.notes, "shadows looked up at each sample: 1, up to 8 taps")) << "its price";
    EXPECT_TRUE(has(lit.notes, "whole frames took 1.0"));
    spec.shadowMaps = 0; // an effect that the scene does not call for
    const Plan dark = planFor(spec, fourSampleDevice());
    EXPECT_EQ(dark.view.aggregation.litShadows, 0u);
    EXPECT_FALSE(has(dark.effects, "lit-aggregates"));
    EXPECT_TRUE(has(dark.notes, "does not declare"));
}

TEST(GroupedPlan, EllipticLobesOfFoldedRoughnessNeedEachNormal) {
    ViewSpec spec;
    spec.layout = "paper16";
    spec.change = [](TechniqueConfig& config) { config.ndf = AGAA_NDF_LEAN; };
    EXPECT_EQ(planFor(spec, fourSampleDevice()).view.generationTier, AGAA_TIER_GBUFFER);
    spec.generationTier = AGAA_TIER_PER_SAMPLE;
    EXPECT_THROW(planFor(spec, fourSampleDevice()), Error);
}

TEST(GroupedPlan, AggregatesKeepMomentsForEllipticLobes) {
    for (const uint32_t tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        ViewSpec spec;
        const AgaaFetchFunction fetch = fetchFunction();
        spec.generationTier = tier;
        spec.chained = tier == AGAA_TIER_IDS ? &fetch : nullptr;
        spec.configFlags = AGAA_CONFIG_BUFFERED;
        const Plan round = planFor(spec, idealDevice());
        spec.change = [](TechniqueConfig& config) { config.ndf = AGAA_NDF_SGGX; };
        const Plan elliptic = planFor(spec, idealDevice());
        EXPECT_EQ(elliptic.bytesPerAggregate, round.bytesPerAggregate + 20) << tier;
        EXPECT_EQ(elliptic.totalBytes() - round.totalBytes(), 640u * 360u * 2u * 20u) << tier;
        spec.facts &= ~AGAA_FACT_SPECULAR; // the diffuse term alone reads them
        spec.change = [](TechniqueConfig& config) { config.measurement.diffuseFilter = AGAA_DIFFUSE_SGGX; };
        const Plan diffuse = planFor(spec, idealDevice());
        spec.change = nullptr;
        EXPECT_EQ(diffuse.bytesPerAggregate, planFor(spec, idealDevice()).bytesPerAggregate + 20) << tier;
    }
}

// AGAA 3.2: the paper's smallest row.
TEST(GroupedPlan, OneAggregateKeepsNoNormalsOfSamples) {
    const auto bytes = [](uint32_t aggregates, uint64_t flags, bool reversedZ) {
        ViewSpec spec;
        spec.generationTier = AGAA_TIER_PER_SAMPLE;
        spec.aggregates = aggregates;
        spec.configFlags = flags;
        spec.viewFlags = reversedZ ? AGAA_VIEW_REVERSED_Z : 0;
        uint64_t normals = 0;
        for (const Resource& resource : planFor(spec, fourSampleDevice()).resources)
            normals += resource.name == "normals" ? resource.bytes : 0;
        return normals;
    };
    EXPECT_EQ(bytes(1, 0, true), 0u);
    for (const uint64_t some : {bytes(2, 0, true), bytes(1, AGAA_CONFIG_COUNTERS, true), bytes(1, 0, false)})
        EXPECT_EQ(some, 640u * 360u * 8u * 2u);
}

TEST(GroupedPlan, EllipticLobesPreferEachNormal) {
    for (const uint32_t ndf : {AGAA_NDF_LEAN, AGAA_NDF_SGGX}) {
        ViewSpec spec;
        spec.change = [=](TechniqueConfig& config) { config.ndf = ndf; };
        const Plan plan = planFor(spec, fourSampleDevice());
        EXPECT_EQ(plan.view.generationTier, AGAA_TIER_GBUFFER);
        EXPECT_TRUE(has(plan.notes, "elliptic lobes"));
        EXPECT_TRUE(has(plan.effects, "ndf-widening"));
        EXPECT_TRUE(has(plan.effects, "elliptic-lobes"));
        EXPECT_FALSE(has(plan.effects, "gloss-weight"));
        spec.facts &= ~AGAA_FACT_SPECULAR; // no lobe, no wish
        const Plan dull = planFor(spec, fourSampleDevice());
        EXPECT_EQ(dull.view.config.ndf, uint32_t(AGAA_NDF_TOKSVIG));
        EXPECT_FALSE(has(dull.effects, "elliptic-lobes"));
        EXPECT_EQ(dull.view.generationTier, AGAA_TIER_POST_DEPTH_ATOMICS);
        spec.change = [=](TechniqueConfig& config) { // where nothing is aggregated, nothing is widened
            config.ndf = ndf;
            config.technique = "simple_complex";
        };
        EXPECT_EQ(planFor(spec, fourSampleDevice()).view.config.ndf, uint32_t(AGAA_NDF_TOKSVIG));
    }
}

TEST(GroupedPlan, GlossPartsOnlyWhatShines) {
    ViewSpec spec;
    spec.change = [](TechniqueConfig& config) { config.aggregation.glossWeight = 0.03f; };
    const Plan shiny = planFor(spec, fourSampleDevice());
    EXPECT_EQ(shiny.view.generationTier, AGAA_TIER_GBUFFER);
    EXPECT_TRUE(has(shiny.effects, "gloss-weight"));
    spec.facts &= ~AGAA_FACT_SPECULAR;
    const Plan dull = planFor(spec, fourSampleDevice());
    EXPECT_EQ(dull.view.generationTier, AGAA_TIER_POST_DEPTH_ATOMICS);
    EXPECT_EQ(dull.view.aggregation.glossWeight, 0.0f);
    EXPECT_FALSE(has(dull.effects, "gloss-weight"));
}

// Only by ids some draws come a second time.
TEST(GroupedPlan, CustomDepthIsDrawnOnceIntoAGBuffer) {
    const AgaaFetchFunction some = fetchFunction(AGAA_FETCH_NOT_ALL_DRAWS);
    ViewSpec spec;
    spec.chained = &some;
    spec.facts |= AGAA_FACT_CUSTOM_DEPTH;
    spec.generationTier = AGAA_TIER_GBUFFER;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).geometryPasses(), 1u);
    for (AgaaTier tier : {AGAA_TIER_AUTO, AGAA_TIER_IDS}) {
        spec.generationTier = tier;
        EXPECT_ANY_THROW(planFor(spec, fourSampleDevice()));
    }
}

TEST(GroupedPlan, TheTargetIsKnownBeforeItIsDrawn) {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = 100;
    view.height = 30;
    view.config = &config;
    view.facts = &facts;
    const AgaaDeviceCaps caps = fourSampleDevice();
    AgaaTarget target = AGAA_TARGET_INIT;
    ASSERT_EQ(agaaQueryTarget(&view, &caps, nullptr, &target), AGAA_OK);
    EXPECT_EQ(target.width, 100 * target.scaleX);
    EXPECT_EQ(target.height, 30 * target.scaleY);
    EXPECT_EQ(target.samples, 4u);
    EXPECT_EQ(target.scaleX * target.scaleY * target.samples, config.samples);
    EXPECT_EQ(target.geometryPasses, 2u);
    AgaaGBufferFunction own = AGAA_GBUFFER_FUNCTION_INIT;
    own.glsl = "bool agaaHostSample";
    view.pNext = &own;
    ASSERT_EQ(agaaQueryTarget(&view, &caps, nullptr, &target), AGAA_OK);
    EXPECT_EQ(target.geometryPasses, 0u);
    EXPECT_EQ(agaaQueryTarget(&view, &caps, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    target.structSize = 0;
    EXPECT_EQ(agaaQueryTarget(&view, &caps, nullptr, &target), AGAA_ERROR_STRUCT);
}

TEST(GroupedPlan, ExtensionsOfTheHostsCodeFollowTheVersion) {
    AgaaFetchFunction fetch = fetchFunction();
    fetch.glslExtensions = "#extension GL_EXT_nonuniform_qualifier : require\n";
    AgaaShadowFunction shadow = AGAA_SHADOW_FUNCTION_INIT;
    shadow.glsl = "float agaaHostShadow";
    shadow.glslExtensions = "#extension GL_EXT_control_flow_attributes : require";
    shadow.shadows = 1;
    fetch.pNext = &shadow;
    ViewSpec spec;
    spec.shadowMaps = 1;
    spec.chained = &fetch;
    const std::string both = std::string("#line 1\n") + fetch.glslExtensions + "\n#line 100000\n#line 1\n" +
                             shadow.glslExtensions + "\n#line 100000\n#define ";
    AgaaDeviceCaps device = fourSampleDevice();
    const std::string subgroups = passGlsl(planFor(spec, device).passes.back());
    EXPECT_NE(subgroups.find("shuffle : require\n" + both), std::string::npos) << subgroups.substr(0, 500);
    device.subgroupSize = 0; // the pass needs no extensions of its own
    const Pass pass = planFor(spec, device).passes.back();
    EXPECT_NE(passGlsl(pass).find("#version 450\n" + both), std::string::npos) << passGlsl(pass).substr(0, 500);
    EXPECT_NE(passGlslForOpenGl(pass, 430).find("#version 430\n" + both), std::string::npos);
    EXPECT_EQ(pass.compute().hostCodeOrigin, "AgaaFetchFunction::glsl and ::glslExtensions with "
                                             "AgaaShadowFunction::glsl and ::glslExtensions");
}

// Compiled only: no software rasteriser here has the feature.
TEST(GroupedPlan, BindlessTexturesCompile) {
    AgaaFetchFunction fetch = fetchFunction();
    fetch.glsl = "layout(set = 1, binding = 0) uniform sampler2D textures[];\n"
                 "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                 "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {\n"
                 "    m.diffuse = textureLod(textures[nonuniformEXT(p.draw)], vec2(0.5), 0.0).rgb;\n"
                 "}\n";
    ViewSpec spec;
    spec.chained = &fetch;
    const auto words = [&] {
        const Pass pass = planFor(spec, fourSampleDevice()).passes.back();
        return compileCompute(passGlsl(pass), pass.compute().hostCodeOrigin.c_str()).size();
    };
    EXPECT_THROW(words(), Error) << "without the extension";
    fetch.glslExtensions = "#extension GL_EXT_nonuniform_qualifier : require";
    EXPECT_GT(words(), 0u);
}

TEST(GroupedPlan, TheListFitsSharedMemory) {
    const AgaaFetchFunction function = fetchFunction();
    ViewSpec spec;
    spec.chained = &function;
    const auto lengthOn = [&](uint32_t bytes, uint64_t flags = AGAA_DEVICE_SOFTWARE) {
        AgaaDeviceCaps caps = fourSampleDevice();
        caps.maxSharedBytes = bytes;
        caps.flags |= flags;
        const std::string defines = planFor(spec, caps).passes.back().compute().defines;
        const size_t at = defines.find("AGAA_LIST_LENGTH ");
        return std::stoul(defines.substr(at + 17));
    };
    EXPECT_EQ(lengthOn(16384), 32u);
    EXPECT_EQ(lengthOn(32768), 192u);
    EXPECT_EQ(lengthOn(49152), 256u);
    EXPECT_EQ(lengthOn(0), 32u) << "a pixel's primitives at 32 samples";
    EXPECT_EQ(lengthOn(16384, 0), 32u);
    EXPECT_EQ(lengthOn(49152, 0), 64u) << "leaves room for other groups";
    // Six numbers of the host's own: 156 bytes each.
    spec.change = [](TechniqueConfig& config) {
        static AgaaLayout layout = AGAA_LAYOUT_INIT;
        static const char* const names[] = {"a", "b", "c", "d", "e", "f"};
        layout = *config.layout;
        layout.attributeCount = 4;
        for (const char* name : names)
            layout.attributes[layout.attributeCount++] = {AGAA_SEMANTIC_CUSTOM, 1,    16, 0, 0, AGAA_ENCODING_UNORM, 1,
                                                          AGAA_FILTER_MEAN,     name, {}};
        config.layout = &layout;
    };
    EXPECT_EQ(lengthOn(8704 + 160 * 156), 160u);
    EXPECT_EQ(lengthOn(8704 + 160 * 156 - 1), 128u);
}

TEST(Presets, SetWhatTheyDecideAndLeaveTheRest) {
    for (const char* name : {"paper", "fast", "balanced", "accurate"}) {
        TechniqueConfig config;
        config.technique = "ssaa";
        config.samples = 16;
        config.ndf = AGAA_NDF_SGGX;
        config.flags = AGAA_CONFIG_COUNTERS;
        config.measurement.flags = AGAA_MEASURE_NO_SHADOW_FILTER | AGAA_MEASURE_NO_STENCIL;
        ASSERT_EQ(config.applyPreset(name), AGAA_OK) << name;
        EXPECT_STREQ(config.technique, "agaa");
        EXPECT_EQ(config.samples, 16u);
        EXPECT_TRUE(config.flags & AGAA_CONFIG_COUNTERS);
        EXPECT_FALSE(config.measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER);
        EXPECT_TRUE(config.measurement.flags & AGAA_MEASURE_NO_STENCIL);
        ViewSpec spec;
        spec.change = [&](TechniqueConfig& c) { c.applyPreset(name); };
        const Plan plan = planFor(spec, fourSampleDevice());
        EXPECT_EQ(plan.view.generationTier == AGAA_TIER_GBUFFER, config.aggregation.litShadows != 0) << name;
        const bool grouped = std::string(name) == "balanced" || std::string(name) == "accurate";
        EXPECT_EQ(config.aggregation.litShadows != 0, grouped);
        EXPECT_EQ(config.ndf, uint32_t(grouped ? AGAA_NDF_LEAN : AGAA_NDF_TOKSVIG));
    }
}

// Two geometry passes, and aggregates in memory, cannot have all of them.
TEST(Presets, LeaveOutWhatATierCannotHave) {
    struct Row {
        uint32_t tier;
        uint64_t flags;
        bool splitsGloss, splitsByShadow;
    };
    for (const Row& row :
         {Row{AGAA_TIER_AUTO, 0, true, true}, Row{AGAA_TIER_GBUFFER, 0, true, true},
          Row{AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED, true, false}, Row{AGAA_TIER_PER_SAMPLE, 0, false, false},
          Row{AGAA_TIER_POST_DEPTH_ATOMICS, 0, false, false}})
        for (const char* name : {"balanced", "accurate"}) {
            ViewSpec spec;
            const AgaaFetchFunction fetch = fetchFunction();
            spec.chained = row.tier == AGAA_TIER_IDS ? &fetch : nullptr;
            spec.change = [&](TechniqueConfig& c) {
                c.generationTier = row.tier;
                c.flags |= row.flags;
                ASSERT_EQ(c.applyPreset(name), AGAA_OK);
            };
            const Plan plan = planFor(spec, fourSampleDevice());
            EXPECT_EQ(plan.view.aggregation.glossWeight > 0, row.splitsGloss) << name << row.tier;
            EXPECT_EQ(plan.view.aggregation.litShadows != 0, row.splitsByShadow) << name << row.tier;
            EXPECT_EQ(plan.view.config.ndf, uint32_t(AGAA_NDF_LEAN));
        }
}

// A layout, with which a class is the last of four attachments.
AgaaLayout layoutWithClass() {
    AgaaLayout layout = builtinLayout("precise");
    layout.attributes[4] = {AGAA_SEMANTIC_CUSTOM, 1, 8, 8, 0, AGAA_ENCODING_UNORM, 255, AGAA_FILTER_CLASS, "kind", {}};
    return layout;
}

TEST(Presets, HaveAnAggregateMoreForClasses) {
    const AgaaLayout layout = layoutWithClass();
    for (const auto& [name, aggregates] : {std::pair{"paper", 3u}, {"fast", 2u}, {"balanced", 4u}, {"accurate", 4u}}) {
        TechniqueConfig config;
        config.layout = &layout;
        ASSERT_EQ(config.applyPreset(name), AGAA_OK) << name;
        EXPECT_EQ(config.aggregates, aggregates) << name;
    }
}

// The prepass of two geometry passes has the class beside the normal; aggregates have a word more.
TEST(Classes, ArePaidForWhereTheyAre) {
    const AgaaLayout with = layoutWithClass();
    AgaaLayout without = with;
    --without.attributeCount;
    for (const uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_GBUFFER}) {
        const auto bytesOf = [&](const AgaaLayout& layout, const char* name) {
            ViewSpec spec;
            spec.change = [&](TechniqueConfig& config) {
                config.technique = "agaa";
                config.generationTier = tier;
                config.layout = &layout;
            };
            const Plan plan = planFor(spec, fourSampleDevice());
            for (const Resource& resource : plan.resources)
                if (resource.name == name)
                    return resource.bytes;
            return uint64_t(0);
        };
        EXPECT_EQ(bytesOf(with, "normals"), 2 * bytesOf(without, "normals")) << tier;
        if (tier == AGAA_TIER_POST_DEPTH_ATOMICS) {
            EXPECT_GT(bytesOf(with, "aggregates"), bytesOf(without, "aggregates"));
            EXPECT_GT(bytesOf(with, "normals"), 0u);
        }
    }
}

} // namespace
} // namespace agaa::test
