// Plans of "dcaa" whose fragments carry their materials.
#include "plan_support.h"

#include "core/base/error.h"
#include "core/glsl/host_glsl.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace agaa::test {
namespace {

ViewSpec carried() {
    return {.technique = "dcaa",
            .samples = 64,
            .aggregates = 4,
            .layout = "dcaa28",
            .generationTier = AGAA_TIER_MATERIAL_LISTS,
            .fetches = false};
}

uint64_t bytesOf(const Plan& plan, const std::string& name) { return plan.resources[plan.surface(name.c_str())].bytes; }

// Id, next fragment, depth, coverage, depth plane, normal and material.
TEST(CoveragePlan, FragmentsWithMaterialsAreOf40Bytes) {
    ViewSpec spec = carried();
    const Plan plan = planFor(spec, idealDevice());
    const uint64_t pixels = uint64_t(spec.width) * spec.height;
    EXPECT_EQ(plan.bytesPerAggregate, 28u);
    EXPECT_EQ(bytesOf(plan, "surfaces"), 112 * pixels);
    EXPECT_EQ(bytesOf(plan, "fragments"), listBytes(spec, 40));
    for (const auto& [samples, bytes] : {std::pair{32u, 36u}, {128u, 48u}}) {
        spec.samples = samples;
        EXPECT_EQ(bytesOf(planFor(spec, idealDevice()), "fragments"), listBytes(spec, bytes)) << samples;
    }
}

// Two words for how normals spread, in each surface and in fragments that carry materials.
TEST(CoveragePlan, EllipticLobesTakeEightBytes) {
    ViewSpec spec = carried();
    const uint64_t pixels = uint64_t(spec.width) * spec.height;
    for (const uint32_t ndf : {AGAA_NDF_LEAN, AGAA_NDF_SGGX}) {
        spec.change = [ndf](TechniqueConfig& config) { config.ndf = ndf; };
        const Plan plan = planFor(spec, idealDevice());
        EXPECT_EQ(plan.view.config.ndf, ndf);
        EXPECT_EQ(plan.bytesPerAggregate, 36u);
        EXPECT_EQ(bytesOf(plan, "surfaces"), 144 * pixels);
        EXPECT_EQ(bytesOf(plan, "fragments"), listBytes(spec, 48));
        EXPECT_TRUE(std::ranges::count(plan.effects, "elliptic-lobes"));
    }
    spec.facts = AGAA_FACT_EMISSIVE; // no highlights
    EXPECT_EQ(planFor(spec, idealDevice()).view.config.ndf, uint32_t(AGAA_NDF_TOKSVIG));
}

// AUTO fetches where the host can for all draws. Otherwise fragments carry their materials.
TEST(CoveragePlan, FragmentsCarryMaterialsThatCannotBeFetched) {
    AgaaFetchFunction all = AGAA_FETCH_FUNCTION_INIT;
    all.glsl = "";
    all.maxDraws = all.maxPrimitives = 1;
    AgaaFetchFunction some = all;
    some.flags = AGAA_FETCH_NOT_ALL_DRAWS;
    ViewSpec spec = carried();
    const auto tierWith = [&](const AgaaFetchFunction* fetch, uint32_t tier) {
        spec.chained = fetch;
        spec.generationTier = tier;
        return planFor(spec, fourSampleDevice()).view.generationTier;
    };
    EXPECT_EQ(tierWith(&all, AGAA_TIER_AUTO), AGAA_TIER_FRAGMENT_LISTS);
    for (const AgaaFetchFunction* fetch : std::initializer_list<const AgaaFetchFunction*>{&some, nullptr})
        EXPECT_EQ(tierWith(fetch, AGAA_TIER_AUTO), AGAA_TIER_MATERIAL_LISTS);
    EXPECT_EQ(tierWith(&all, AGAA_TIER_MATERIAL_LISTS), AGAA_TIER_MATERIAL_LISTS);
}

TEST(CoveragePlan, WhatFragmentsCannotCarryIsRefused) {
    ViewSpec depth = carried();
    depth.facts |= AGAA_FACT_CUSTOM_DEPTH;
    EXPECT_NE(refusal(depth, idealDevice()).find("discard on their own"), std::string::npos);
    ViewSpec other = carried();
    other.technique = "agaa";
    other.samples = 8;
    EXPECT_NE(refusal(other, idealDevice()).find("the tier material-lists is for"), std::string::npos);
    for (const uint64_t flag : {AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_DEVICE_GEOMETRY_SHADERS}) {
        AgaaDeviceCaps caps = idealDevice();
        caps.flags &= ~flag;
        EXPECT_NE(refusal(carried(), caps).find("the device has no"), std::string::npos) << flag;
    }
}

// A device without geometry shaders runs each tier if vertex shaders of the host expand triangles, and says so
// otherwise.
TEST(CoveragePlan, VertexPullingReplacesGeometryShaders) {
    AgaaDeviceCaps caps = idealDevice();
    caps.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    for (const auto& [technique, tier] : {std::pair{"dcaa", AGAA_TIER_FRAGMENT_LISTS},
                                          {"dcaa", AGAA_TIER_MATERIAL_LISTS},
                                          {"dcaa", AGAA_TIER_FRAGMENT_INTERLOCK},
                                          {"dcaa", AGAA_TIER_RASTER_ORDER},
                                          {"dcaa", AGAA_TIER_AUTO},
                                          {"agaa", AGAA_TIER_FRAGMENTS},
                                          {"agaa", AGAA_TIER_AUTO}}) {
        SCOPED_TRACE(std::string(technique) + " " + agaaTierName(tier));
        ViewSpec spec{.technique = technique, .samples = 64, .aggregates = 2, .generationTier = uint32_t(tier)};
        const std::string refused = refusal(spec, caps);
        EXPECT_NE(refused.find("the device has no geometry shaders"), std::string::npos) << refused;
        EXPECT_NE(refused.find("AGAA_VIEW_VERTEX_PULLING"), std::string::npos) << refused;
        const Plan expanded = planFor(spec, idealDevice());
        spec.viewFlags = AGAA_VIEW_VERTEX_PULLING;
        const Plan pulled = planFor(spec, caps);
        EXPECT_EQ(pulled.view.generationTier, expanded.view.generationTier);
        EXPECT_EQ(pulled.totalBytes(), expanded.totalBytes());
        EXPECT_TRUE(std::ranges::any_of(pulled.notes, [](const std::string& note) {
            return note.find("AGAA_VIEW_VERTEX_PULLING") != std::string::npos;
        }));
        ASSERT_EQ(pulled.passes.size(), expanded.passes.size());
        for (size_t i = 0; i < pulled.passes.size(); ++i) {
            const Pass &p = pulled.passes[i], &e = expanded.passes[i];
            if (p.kind() != PassKind::HostDraw)
                continue;
            EXPECT_EQ(p.draw().state.vertexPulling, 1u);
            EXPECT_EQ(e.draw().state.vertexPulling, 0u);
            EXPECT_EQ(hostGeometry(pulled, p, {}), "");
            EXPECT_EQ(hostVertex(expanded, e, {}), "");
            EXPECT_NE(hostVertex(pulled, p, {}).find("void agaa_pullVertex("), std::string::npos);
            EXPECT_EQ(hostGeometry(expanded, e, {}).find("void agaa_pullVertex("), std::string::npos);
            EXPECT_EQ(hostDeclarations(pulled, p, {}), hostDeclarations(expanded, e, {}));
            EXPECT_NE(hostPassKey(pulled, p, {}), hostPassKey(expanded, e, {}));
        }
    }
    // All else is as without the flag.
    ViewSpec other{.viewFlags = AGAA_VIEW_VERTEX_PULLING};
    for (const Pass& pass : planFor(other, caps).passes)
        EXPECT_TRUE(pass.kind() != PassKind::HostDraw || pass.draw().state.vertexPulling == 0);
    caps.flags &= ~AGAA_DEVICE_FRAGMENT_ATOMICS;
    ViewSpec noAtomics = carried();
    noAtomics.viewFlags = AGAA_VIEW_VERTEX_PULLING;
    EXPECT_NE(refusal(noAtomics, caps).find("no atomics"), std::string::npos);
}

// No lists, and no more than the surfaces; AUTO does not select it.
TEST(CoveragePlan, InterlockKeepsSurfacesAlone) {
    ViewSpec spec = carried();
    spec.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
    const Plan plan = planFor(spec, idealDevice());
    EXPECT_EQ(plan.view.generationTier, AGAA_TIER_FRAGMENT_INTERLOCK);
    EXPECT_EQ(plan.totalBytes(), 112u * spec.width * spec.height);
    EXPECT_EQ(plan.fragmentCapacity, 0u);
    EXPECT_EQ(plan.geometryPasses(), 1u);
    AgaaDeviceCaps caps = idealDevice();
    caps.flags &= ~AGAA_DEVICE_FRAGMENT_INTERLOCK;
    EXPECT_THROW(planFor(spec, caps), Error);
    spec.change = [](TechniqueConfig& config) { config.coverage.flags = AGAA_COVERAGE_EXACT; };
    EXPECT_THROW(planFor(spec, idealDevice()), Error);
    spec = carried();
    spec.generationTier = AGAA_TIER_AUTO;
    EXPECT_EQ(planFor(spec, idealDevice()).view.generationTier, AGAA_TIER_MATERIAL_LISTS);
}

// The texels of seven attachments are the surfaces; AUTO does not select the tier.
TEST(CoveragePlan, RasterOrderKeepsSurfacesInAttachments) {
    ViewSpec spec = carried();
    spec.generationTier = AGAA_TIER_RASTER_ORDER;
    AgaaDeviceCaps caps = idealDevice();
    const Plan plan = planFor(spec, caps);
    EXPECT_EQ(plan.view.generationTier, AGAA_TIER_RASTER_ORDER);
    EXPECT_EQ(plan.totalBytes(), 112u * spec.width * spec.height);
    EXPECT_EQ(plan.fragmentCapacity, 0u);
    const auto draw = std::ranges::find(plan.passes, PassKind::HostDraw, &Pass::kind);
    ASSERT_NE(draw, plan.passes.end());
    EXPECT_EQ(draw->draw().state.colorAttachmentCount, 7u);
    ASSERT_EQ(draw->draw().colorTargets.size(), 1u);
    EXPECT_EQ(plan.resources[draw->draw().colorTargets[0]].layers, 7u);
    HostDialect dialect;
    dialect.openGl = true;
    const std::string text = hostDeclarations(plan, *draw, dialect);
    EXPECT_NE(hostExtensions(plan, *draw, dialect).find("GL_EXT_shader_framebuffer_fetch"), std::string::npos);
    EXPECT_NE(text.find("layout(location = 6) inout uvec4 agaa_target6;"), std::string::npos);
    EXPECT_EQ(text.find("agaa_target7"), std::string::npos);
    EXPECT_EQ(text.find("out vec4 agaa_out"), std::string::npos);
    dialect = {};
    dialect.descriptorSet = 2;
    const std::string vulkan = hostDeclarations(plan, *draw, dialect);
    EXPECT_EQ(hostExtensions(plan, *draw, dialect), "");
    EXPECT_NE(
        vulkan.find("layout(input_attachment_index = 0, set = 2, binding = 10) uniform usubpassInput agaa_held[7];"),
        std::string::npos);
    EXPECT_NE(vulkan.find("layout(location = 6) out uvec4 agaa_target6;"), std::string::npos);
    EXPECT_EQ(draw->draw().state.readsAttachments, 1u);
    caps.flags &= ~AGAA_DEVICE_FRAMEBUFFER_FETCH;
    const std::string refused = refusal(spec, caps);
    for (const char* extension : {"GL_EXT_shader_framebuffer_fetch", "VK_EXT_rasterization_order_attachment_access"})
        EXPECT_NE(refused.find(extension), std::string::npos) << refused;
    spec.aggregates = 5;
    EXPECT_NE(refusal(spec, idealDevice()).find("5 surfaces of this layout take 140"), std::string::npos);
    spec.aggregates = 4;
    spec.change = [](TechniqueConfig& config) { config.coverage.flags = AGAA_COVERAGE_EXACT; };
    EXPECT_NE(refusal(spec, idealDevice()).find("the tier raster-order does not keep"), std::string::npos);
}

const std::vector<float> ownPositions(2 * 128, 0.25f);

void useOwnPattern(TechniqueConfig& config) { config.coverage.samplePositions = ownPositions.data(); }

// A table of the usual size, a pass that fills it, and all else as with the library's pattern.
TEST(CoveragePlan, OwnPatternsTakeATable) {
    for (const auto& [technique, tier] : {std::pair{"dcaa", AGAA_TIER_FRAGMENT_LISTS},
                                          {"dcaa", AGAA_TIER_MATERIAL_LISTS},
                                          {"dcaa", AGAA_TIER_FRAGMENT_INTERLOCK},
                                          {"dcaa", AGAA_TIER_RASTER_ORDER},
                                          {"agaa", AGAA_TIER_FRAGMENTS}}) {
        SCOPED_TRACE(agaaTierName(tier));
        ViewSpec spec{.technique = technique, .samples = 64, .aggregates = 2, .generationTier = uint32_t(tier)};
        const Plan library = planFor(spec, idealDevice());
        spec.change = useOwnPattern;
        const Plan own = planFor(spec, idealDevice());
        EXPECT_EQ(own.totalBytes(), library.totalBytes());
        EXPECT_EQ(own.constantBytes(), library.constantBytes() + 128 * 128 * 16);
        EXPECT_EQ(own.view.samplePositions, std::vector<float>(2 * 64, 0.25f));
        EXPECT_TRUE(library.view.samplePositions.empty());
        std::vector<std::string> names;
        for (const Pass& pass : own.passes)
            if (pass.name != "fill coverage table")
                names.push_back(pass.name);
        ASSERT_EQ(own.passes.size(), library.passes.size() + 1);
        for (size_t i = 0; i < names.size(); ++i)
            EXPECT_EQ(names[i], library.passes[i].name);
        for (const Pass& pass : own.passes)
            if (pass.kind() == PassKind::Compute) {
                EXPECT_EQ(pass.constants[AGAA_TABLE_SIZE], 128u) << pass.name;
            }
        spec.change = [](TechniqueConfig& config) {
            useOwnPattern(config);
            config.coverage.tableSize = 256;
        };
        EXPECT_EQ(planFor(spec, idealDevice()).constantBytes(), library.constantBytes() + 256 * 256 * 16);
    }
}

// Techniques and tiers without coverage samples do not read positions.
TEST(CoveragePlan, OtherTechniquesHaveNoTable) {
    for (const ViewSpec& used :
         {ViewSpec{.technique = "ssaa", .samples = 32}, ViewSpec{.technique = "agaa", .samples = 8},
          ViewSpec{.technique = "agaa", .samples = 32, .generationTier = AGAA_TIER_GBUFFER}}) {
        ViewSpec spec = used;
        const Plan plain = planFor(spec, idealDevice());
        spec.change = useOwnPattern;
        EXPECT_EQ(planToJson(planFor(spec, idealDevice())), planToJson(plain)) << used.technique << used.samples;
    }
}

// No driver of the tests has the extension: the text is compiled, and says what it needs.
TEST(CoveragePlan, InterlockCompiles) {
    glslang::InitializeProcess();
    for (const char* masked : {"0", "1"})
        for (const auto& [flags, hasOwnPattern] :
             {std::pair{UINT64_C(0), false}, {AGAA_CONFIG_COUNTERS, false}, {AGAA_CONFIG_COUNTERS, true}}) {
            ViewSpec spec = carried();
            spec.generationTier = AGAA_TIER_FRAGMENT_INTERLOCK;
            spec.configFlags = flags;
            if (hasOwnPattern)
                spec.change = useOwnPattern;
            const Plan plan = planFor(spec, idealDevice());
            const auto pass = std::ranges::find(plan.passes, PassKind::HostDraw, &Pass::kind);
            ASSERT_NE(pass, plan.passes.end());
            HostDialect dialect;
            for (const bool openGl : {false, true}) {
                dialect.openGl = openGl;
                const std::string text =
                    "#version 450\n" + hostExtensions(plan, *pass, dialect) + "#define AGAA_ALPHA_MASKED " + masked +
                    "\n" + hostDeclarations(plan, *pass, dialect) +
                    "void main() {\n    AgaaSurfaceInput s = agaa_surfaceInput();\n    agaa_emit(s);\n}\n";
                glslang::TShader shader(EShLangFragment);
                const char* source = text.c_str();
                shader.setStrings(&source, 1);
                if (!openGl) {
                    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
                    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
                    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
                }
                const auto messages = openGl ? EShMsgDefault : EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
                ASSERT_TRUE(shader.parse(GetDefaultResources(), openGl ? 110 : 450, false, messages))
                    << shader.getInfoLog();
                glslang::TProgram program;
                program.addShader(&shader);
                ASSERT_TRUE(program.link(messages)) << program.getInfoLog();
                if (openGl)
                    continue;
                std::vector<uint32_t> words;
                glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), words);
                constexpr uint32_t opCapability = 17, pixelInterlock = 5378;
                bool isNamed = false;
                for (size_t at = 5; at < words.size(); at += words[at] >> 16)
                    isNamed |= (words[at] & 0xFFFF) == opCapability && words[at + 1] == pixelInterlock;
                EXPECT_TRUE(isNamed);
            }
        }
    glslang::FinalizeProcess();
}

// Hosts evaluate materials where the text says so.
TEST(CoveragePlan, DeclarationsAskForMaterials) {
    const auto declarations = [](const ViewSpec& spec) {
        const Plan plan = planFor(spec, idealDevice());
        for (const Pass& pass : plan.passes)
            if (pass.kind() == PassKind::HostDraw)
                return hostDeclarations(plan, pass, {});
        return std::string();
    };
    ViewSpec fetched = carried();
    fetched.generationTier = AGAA_TIER_FRAGMENT_LISTS;
    fetched.fetches = true;
    EXPECT_NE(declarations(fetched).find("#define AGAA_NEEDS_MATERIAL 0\n"), std::string::npos);
    EXPECT_NE(declarations(carried()).find("#define AGAA_NEEDS_MATERIAL 1\n"), std::string::npos);
}

} // namespace
} // namespace agaa::test
